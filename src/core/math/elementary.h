// core/math: elementary functions that give the same bits on every machine. The C library's do not:
// glibc picks among variants by processor, and its results change between releases.
//
// Contract of each, for every finite argument of its domain: |error| <= 1 ulp in double; float is
// the double result rounded once; Quad uses libquadmath. Outside of the domain the result is a NaN,
// at a pole an infinity, as in C.
#pragma once

#include "core/math/scalar.h"

namespace alhazen {

double sin_deg(
    double angle_deg);  // exact at multiples of 30 degrees where the result is 0, +-1/2, +-1
double cos_deg(double angle_deg);  // likewise
double tan_deg(double angle_deg);
double asin_deg(double x);
double acos_deg(double x);
double atan2_deg(double y, double x);  // in (-180, 180]

template <class Real>
struct SinCos {
  Real sin, cos;
};

// exp_of(x) = e^x, log_of(x) = ln x, power(b, e) = b^e for b >= 0 (power(0,0) = 1).
// sin_cos_of_turns(u): sine and cosine of 2 pi u. atan2_turns(y, x): the angle of (x, y) in turns,
// in [-1/2, 1/2]. acos_turns(x): in [0, 1/2].
#define ALHAZEN_ELEMENTARY(Real)         \
  Real exp_of(Real x);                   \
  Real log_of(Real x);                   \
  Real power(Real base, Real exponent);  \
  SinCos<Real> sin_cos_of_turns(Real u); \
  Real atan2_turns(Real y, Real x);      \
  Real acos_turns(Real x);
ALHAZEN_ELEMENTARY(float)
ALHAZEN_ELEMENTARY(double)
#if ALHAZEN_HAS_QUAD
ALHAZEN_ELEMENTARY(Quad)
#endif
#undef ALHAZEN_ELEMENTARY

}  // namespace alhazen

// core/math: the scalar types that kernels are instantiated for, behind one set of names.
// float: an accuracy that costs less. double: the default. Quad: the oracle (docs/numerics.md).
#pragma once

#include <cmath>
#include <limits>

#if defined(__GNUC__) && !defined(__clang__) && !defined(ALHAZEN_WITHOUT_QUAD) && \
    __has_include(<quadmath.h>)
#define ALHAZEN_HAS_QUAD 1
#include <quadmath.h>
#else
#define ALHAZEN_HAS_QUAD 0
#endif

namespace alhazen {

// IEEE 754 operations only: each is correctly rounded, so each gives the same bits everywhere.
template <class Real>
struct ScalarTraits {
  static Real fma(Real a, Real b, Real c) { return std::fma(a, b, c); }
  static Real sqrt(Real x) { return std::sqrt(x); }
  static Real abs(Real x) { return std::fabs(x); }
  static Real floor(Real x) { return std::floor(x); }
  static bool is_finite(Real x) { return std::isfinite(x); }
  static bool is_nan(Real x) { return std::isnan(x); }
  static bool sign_bit(Real x) { return std::signbit(x); }
  static constexpr Real infinity() { return std::numeric_limits<Real>::infinity(); }
  // Half the distance from 1 to the next larger number: the relative error of one rounding.
  static constexpr Real unit_roundoff() { return std::numeric_limits<Real>::epsilon() / 2; }
  static constexpr Real pi() { return static_cast<Real>(3.141592653589793238462643383279502884L); }
};

#if ALHAZEN_HAS_QUAD
__extension__ typedef __float128 Quad;

template <>
struct ScalarTraits<Quad> {
  static Quad fma(Quad a, Quad b, Quad c) { return fmaq(a, b, c); }
  static Quad sqrt(Quad x) { return sqrtq(x); }
  static Quad abs(Quad x) { return fabsq(x); }
  static Quad floor(Quad x) { return floorq(x); }
  static bool is_finite(Quad x) { return finiteq(x) != 0; }
  static bool is_nan(Quad x) { return isnanq(x) != 0; }
  static bool sign_bit(Quad x) { return signbitq(x) != 0; }
  static constexpr Quad infinity() { return static_cast<Quad>(__builtin_huge_val()); }
  // 2^-113, built from powers of two that a double holds exactly.
  static constexpr Quad unit_roundoff() {
    return static_cast<Quad>(0x1p-100) * static_cast<Quad>(0x1p-13);
  }
  static constexpr Quad pi() {
    // 3.14159265358979323846264338327950288419716939937510 as a sum of two doubles and a tail,
    // so that no compiler extension for quad literals is needed.
    return static_cast<Quad>(0x1.921fb54442d18p+1) + static_cast<Quad>(0x1.1a62633145c07p-53) +
           static_cast<Quad>(-0x1.f1976b7ed8fbcp-109);
  }
};
#endif

// A kernel that is a template on Real serves one ray or lanes of rays (render/simd/lanes.h). What
// it decides is then a MaskOf<Real>, and it selects where it would branch; for one number these are
// a bool and the conditional operator.
template <class Real>
struct LaneTraits {
  using Scalar = Real;
  using Mask = bool;
  using Int = int;  // small whole numbers that go with a Real: faces
  static constexpr int kWidth = 1;
};
template <class Real>
using ScalarOf = typename LaneTraits<Real>::Scalar;
template <class Real>
using MaskOf = typename LaneTraits<Real>::Mask;
template <class Real>
using IntOf = typename LaneTraits<Real>::Int;

template <class T>
constexpr T select(bool condition, T yes, T no) {
  return condition ? yes : no;
}
constexpr bool any(bool condition) {
  return condition;
}
constexpr bool all(bool condition) {
  return condition;
}

template <class Real>
inline Real fused_multiply_add(Real a, Real b, Real c) {
  return ScalarTraits<Real>::fma(a, b, c);
}
template <class Real>
inline Real square_root(Real x) {
  return ScalarTraits<Real>::sqrt(x);
}
template <class Real>
inline Real absolute(Real x) {
  return ScalarTraits<Real>::abs(x);
}
template <class Real>
inline Real round_down(Real x) {
  return ScalarTraits<Real>::floor(x);
}
template <class Real>
inline MaskOf<Real> is_finite(Real x) {
  return ScalarTraits<Real>::is_finite(x);
}
template <class Real>
inline MaskOf<Real> is_nan(Real x) {
  return ScalarTraits<Real>::is_nan(x);
}
template <class Real>
constexpr Real infinity() {
  return ScalarTraits<Real>::infinity();
}
template <class Real>
constexpr Real pi() {
  return ScalarTraits<Real>::pi();
}
template <class Real>
constexpr Real smaller(Real a, Real b) {
  return select(b < a, b, a);
}
template <class Real>
constexpr Real larger(Real a, Real b) {
  return select(a < b, b, a);
}

// a*b - c*d with an error of at most 1.5 ulp, however much cancels (Kahan; Jeannerod, Louvet and
// Muller 2013).
template <class Real>
inline Real difference_of_products(Real a, Real b, Real c, Real d) {
  const Real cd = c * d;
  const Real difference = fused_multiply_add(a, b, -cd);
  const Real error = fused_multiply_add(-c, d, cd);
  return difference + error;
}

}  // namespace alhazen

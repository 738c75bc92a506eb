// core/math: sine, cosine and tangent in double. Angles are reduced to an eighth of a turn without
// rounding, so that no argument is too large and symmetric arguments give symmetric bits.
#include <initializer_list>

#include "core/math/elementary.h"
#include "core/math/error_free.h"

namespace alhazen {
namespace {

using Word = DoubleWord<double>;

constexpr Word kRadiansPerTurn{0x1.921fb54442d18p+2, 0x1.1a62633145c07p-52};
constexpr Word kRadiansPerDegree{0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};

struct SinCosWords {
  Word sin, cos;
};

// Taylor series for |p| <= pi/4. The terms of degree up to 3 are summed in two words, the others
// are below 1/70 of the whole: relative error < 2^-58, before the two words become one.
SinCosWords sin_cos_of_radians(Word p) {
  constexpr Word kSixth{0x1.5555555555555p-3, 0x1.5555555555555p-57};
  const double z = p.hi * p.hi;
  double s = 1. / 355687428096000, c = 1. / 20922789888000;
  for (const double term :
       {-1. / 1307674368000, 1. / 6227020800, -1. / 39916800, 1. / 362880, -1. / 5040, 1. / 120}) {
    s = fused_multiply_add(s, z, term);
  }
  for (const double term :
       {-1. / 87178291200, 1. / 479001600, -1. / 3628800, 1. / 40320, -1. / 720, 1. / 24}) {
    c = fused_multiply_add(c, z, term);
  }
  const Word square = two_product(p.hi, p.hi);
  const Word cubic = -(square * p.hi * kSixth) + p.hi;
  const Word quadratic = square * -0.5 + 1.0;
  const double sin_low = fused_multiply_add(p.lo, fused_multiply_add(z, -0.5, 1.0), cubic.lo);
  const double cos_low = fused_multiply_add(-p.hi, p.lo, quadratic.lo);
  return {quick_two_sum(cubic.hi, fused_multiply_add(z * z * p.hi, s, sin_low)),
          quick_two_sum(quadratic.hi, fused_multiply_add(z * z, c, cos_low))};
}

// The sine and cosine of p + a number of quarter turns.
SinCosWords turned_by_quarters(SinCosWords p, int quarters) {
  switch (quarters & 3) {
    case 0:
      return p;
    case 1:
      return {p.cos, -p.sin};
    case 2:
      return {-p.sin, -p.cos};
    default:
      return {-p.cos, p.sin};
  }
}

// For an angle >= 0.
SinCosWords sin_cos_of_degrees(double angle_deg) {
  const double within_turn = std::fmod(angle_deg, 360.0);  // exact by IEEE 754
  const double quarters = round_down(within_turn / 90 + 0.5);
  const double rest = within_turn - 90 * quarters;  // exact: the two are within a factor of two
  return turned_by_quarters(sin_cos_of_radians(kRadiansPerDegree * rest),
                            static_cast<int>(quarters));
}

// At a multiple of 90 degrees 0 comes out as +0, whichever quadrant it was approached from.
double rounded(Word value) {
  return value.hi + 0.0;
}

double with_sign_of(double argument, double value) {
  return ScalarTraits<double>::sign_bit(argument) ? -value : value;
}

}  // namespace

double sin_deg(double angle_deg) {
  return with_sign_of(angle_deg, rounded(sin_cos_of_degrees(absolute(angle_deg)).sin));
}

double cos_deg(double angle_deg) {
  return rounded(sin_cos_of_degrees(absolute(angle_deg)).cos);
}

double tan_deg(double angle_deg) {
  const SinCosWords p = sin_cos_of_degrees(absolute(angle_deg));
  if (p.cos.hi == 0) return with_sign_of(angle_deg, infinity<double>());
  if (p.sin.hi == 0) return with_sign_of(angle_deg, 0);
  return with_sign_of(angle_deg, (p.sin / p.cos).hi);
}

SinCos<double> sin_cos_of_turns(double u) {
  const double size = absolute(u);
  const double within_turn = size - round_down(size);  // exact
  const double quarters = round_down(fused_multiply_add(4.0, within_turn, 0.5));
  const double rest = fused_multiply_add(-0.25, quarters, within_turn);  // exact
  const SinCosWords p =
      turned_by_quarters(sin_cos_of_radians(kRadiansPerTurn * rest), static_cast<int>(quarters));
  return {with_sign_of(u, rounded(p.sin)), rounded(p.cos)};
}

SinCos<float> sin_cos_of_turns(float u) {
  const SinCos<double> result = sin_cos_of_turns(static_cast<double>(u));
  return {static_cast<float>(result.sin), static_cast<float>(result.cos)};
}

}  // namespace alhazen

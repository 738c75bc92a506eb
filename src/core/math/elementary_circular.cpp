// core/math: sine, cosine and tangent in double. Angles are reduced to an eighth of a turn without
// rounding, so that no argument is too large and symmetric arguments give symmetric bits.
#include "core/math/circular_kernels.h"
#include "core/math/elementary.h"
#include "core/math/error_free.h"

namespace alhazen {
namespace {

using kernel::rounded;
using kernel::sin_cos_of_radians;
using kernel::turned_by_quarters;
using Word = DoubleWord<double>;
using SinCosWords = kernel::SinCosWords<double>;

constexpr Word kRadiansPerDegree{0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};

// For an angle >= 0.
SinCosWords sin_cos_of_degrees(double angle_deg) {
  const double within_turn = std::fmod(angle_deg, 360.0);  // exact by IEEE 754
  const double quarters = round_down(within_turn / 90 + 0.5);
  const double rest = within_turn - 90 * quarters;  // exact: the two are within a factor of two
  return turned_by_quarters(sin_cos_of_radians(kRadiansPerDegree * rest), quarters);
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
  if (p.sin.hi == 0) return with_sign_of(angle_deg, 0.0);
  return with_sign_of(angle_deg, (p.sin / p.cos).hi);
}

SinCos<double> sin_cos_of_turns(double u) {
  return kernel::sin_cos_of_turns(u);
}

SinCos<float> sin_cos_of_turns(float u) {
  const SinCos<double> result = sin_cos_of_turns(static_cast<double>(u));
  return {static_cast<float>(result.sin), static_cast<float>(result.cos)};
}

}  // namespace alhazen

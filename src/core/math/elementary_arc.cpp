// core/math: the inverse circular functions of single numbers.
#include "core/math/arc_kernels.h"
#include "core/math/elementary.h"

namespace alhazen {
namespace {

using kernel::angle_in_half_plane;
using kernel::other_leg;
using kernel::turn_in_half_plane;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double asin_deg(double x) {
  const double size = absolute(x);
  if (!(size <= 1)) return kNaN;
  if (size == 1) return with_sign_of(x, 90.0);
  // Below 2^-32 the arc is its sine to within 2^-65.
  if (size < 0x1p-32) return with_sign_of(x, angle_in_half_plane(size, 1.0, 360.0));
  return with_sign_of(x, (turn_in_half_plane<double>({size, 0}, other_leg(size)) * 360.0).hi);
}

double acos_deg(double x) {
  return kernel::acos_in(x, 360.0);
}

double atan2_deg(double y, double x) {
  if (is_nan(x) || is_nan(y)) return kNaN;
  const double angle = with_sign_of(y, angle_in_half_plane(absolute(y), x, 360.0));
  return angle == -180 ? 180 : angle;
}

double acos_turns(double x) {
  return kernel::acos_turns(x);
}

double atan2_turns(double y, double x) {
  return kernel::atan2_turns(y, x);
}

float acos_turns(float x) {
  return static_cast<float>(acos_turns(static_cast<double>(x)));
}
float atan2_turns(float y, float x) {
  return static_cast<float>(atan2_turns(static_cast<double>(y), static_cast<double>(x)));
}

}  // namespace alhazen

#include "app/compare/flip_color.h"

#include <cmath>

#include "core/math/chromaticities.h"

namespace alhazen {
namespace {

// From the primaries and the white of ITU-R BT.709 in exact fractions; every row sums to 1.
constexpr ColorMatrix kXyzFromLight{
    {{{0.43388734556603986, 0.3762240091374987, 0.1898886452964614},
      {0.21263900587151036, 0.7151686787677559, 0.07219231536073371},
      {0.01775004007097326, 0.10944762085523849, 0.8728023390737882}}}};
constexpr ColorMatrix kLightFromXyz{
    {{{3.0803990906794647, -1.5373831775700935, -0.543015913109371},
      {-0.921223358860277, 1.8759675015077206, 0.0452558573525563},
      {0.052873938970364444, -0.20397695888897657, 1.151103019918612}}}};

// CIE 15, with the line below (6/29)^3 that gives black a slope.
double lab_curve(double t) {
  constexpr double kBend = 6.0 / 29.0;
  return t > kBend * kBend * kBend ? std::cbrt(t) : t / (3.0 * kBend * kBend) + 4.0 / 29.0;
}

}  // namespace

Rgbd xyz_of_light(Rgbd light) {
  return kXyzFromLight * light;
}

Rgbd light_of_xyz(Rgbd xyz) {
  return kLightFromXyz * xyz;
}

Rgbd ycxcz_of_xyz(Rgbd xyz) {
  return {116.0 * xyz.g - 16.0, 500.0 * (xyz.r - xyz.g), 200.0 * (xyz.g - xyz.b)};
}

Rgbd xyz_of_ycxcz(Rgbd ycxcz) {
  const double y = (ycxcz.r + 16.0) / 116.0;
  return {y + ycxcz.g / 500.0, y, y - ycxcz.b / 200.0};
}

Rgbd lab_of_xyz(Rgbd xyz) {
  const double x = lab_curve(xyz.r), y = lab_curve(xyz.g), z = lab_curve(xyz.b);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

Rgbd hunt_adjusted(Rgbd lab) {
  return {lab.r, 0.01 * lab.r * lab.g, 0.01 * lab.r * lab.b};
}

double hyab(Rgbd lab_1, Rgbd lab_2) {
  const Rgbd d = lab_1 - lab_2;
  return std::fabs(d.r) + std::hypot(d.g, d.b);
}

}  // namespace alhazen

// parser/eval: trigonometry and units.
#include "core/math/elementary.h"
#include "parser/eval/builtin/builtin.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {
namespace {

constexpr BuiltinParameter kAngleParameter[] = {{"angle", kAngle}};
constexpr BuiltinParameter kNumberParameter[] = {{"value", kNumber}};
constexpr BuiltinParameter kPoint[] = {{"y", kNumber}, {"x", kNumber}};
constexpr BuiltinParameter kUnit[] = {{"value", kNumber | kAngle}};
constexpr BuiltinParameter kAbout[] = {{"axis", kVec3}, {"angle", kAngle}};

Value sin_of(const BuiltinCall& call) {
  return sin_deg(call.deg(0));
}
Value cos_of(const BuiltinCall& call) {
  return cos_deg(call.deg(0));
}
Value tan_of(const BuiltinCall& call) {
  if (cos_deg(call.deg(0)) == 0) {
    return call.outside_domain(0, "an angle other than 90deg, 270deg and the like");
  }
  return tan_deg(call.deg(0));
}
Value asin_of(const BuiltinCall& call) {
  if (!(absolute(call.number(0)) <= 1)) return call.outside_domain(0, "a number from -1 to 1");
  return Angle{asin_deg(call.number(0))};
}
Value acos_of(const BuiltinCall& call) {
  if (!(absolute(call.number(0)) <= 1)) return call.outside_domain(0, "a number from -1 to 1");
  return Angle{acos_deg(call.number(0))};
}
Value atan_of(const BuiltinCall& call) {
  return Angle{atan2_deg(call.number(0), 1)};
}
Value atan2_of(const BuiltinCall& call) {
  if (call.number(0) == 0 && call.number(1) == 0) {
    return call.outside_domain(0, "a point other than the origin");
  }
  return Angle{atan2_deg(call.number(0), call.number(1))};
}
// A number becomes an angle of so many degrees, an angle the number of its degrees.
Value deg_of(const BuiltinCall& call) {
  if (call.values[0].is(Type::angle)) return call.deg(0);
  return Angle{call.number(0)};
}
Value rad_of(const BuiltinCall& call) {
  if (call.values[0].is(Type::angle)) return call.deg(0) * (alhazen::pi<double>() / 180);
  return Angle{call.number(0) * 180 / alhazen::pi<double>()};
}
Value about_of(const BuiltinCall& call) {
  const Vec3d axis = call.vec3(0);
  // Scaled first: the square of a very long or short axis is out of range.
  const double size = larger(absolute(axis.x), larger(absolute(axis.y), absolute(axis.z)));
  if (size == 0) return call.outside_domain(0, "an axis other than <0, 0, 0>");
  return TransformPtr{std::make_shared<const Affined>(
      rotation({axis.x / size, axis.y / size, axis.z / size}, call.deg(1)))};
}

constexpr BuiltinFunction kFunctions[] = {
    {"about", kAbout, false, "transform", "a turn about an axis, for `rotate`", about_of},
    {"acos", kNumberParameter, false, "angle", "the angle from 0deg to 180deg with this cosine",
     acos_of},
    {"asin", kNumberParameter, false, "angle", "the angle from -90deg to 90deg with this sine",
     asin_of},
    {"atan", kNumberParameter, false, "angle", "the angle from -90deg to 90deg with this tangent",
     atan_of},
    {"atan2", kPoint, false, "angle", "the direction of the point (x, y), from -180deg to 180deg",
     atan2_of},
    {"cos", kAngleParameter, false, "number", "the cosine; exactly 0 at 90deg", cos_of},
    {"deg", kUnit, false, "angle or number",
     "an angle of so many degrees; of an angle, the number of its degrees", deg_of},
    {"rad", kUnit, false, "angle or number",
     "an angle of so many radians; of an angle, the number of its radians", rad_of},
    {"sin", kAngleParameter, false, "number", "the sine", sin_of},
    {"tan", kAngleParameter, false, "number", "the tangent", tan_of},
};

}  // namespace

std::span<const BuiltinFunction> angle_functions() {
  return kFunctions;
}

}  // namespace alhazen::parser

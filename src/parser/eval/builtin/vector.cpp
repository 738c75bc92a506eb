// parser/eval: functions of vectors.
#include <cmath>

#include "core/math/elementary.h"
#include "parser/eval/builtin/builtin.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {
namespace {

constexpr BuiltinParameter kOne[] = {{"v", kVec3}};
constexpr BuiltinParameter kTwo[] = {{"a", kVec3}, {"b", kVec3}};
constexpr BuiltinParameter kTurn[] = {{"v", kVec3}, {"turn", kAngles | kTransform}};
constexpr BuiltinParameter kComponents[] = {{"x", kNumber}, {"y", kNumber}, {"z", kNumber}};

double size_of(Vec3d v) {
  return larger(absolute(v.x), larger(absolute(v.y), absolute(v.z)));
}

// Scaled by a power of two first, which is exact and keeps the squares in range.
double safe_length(Vec3d v) {
  if (size_of(v) == 0) return 0;
  const int exponent = std::ilogb(size_of(v));
  const auto near_one = [&](double c) { return std::scalbn(c, -exponent); };
  return std::scalbn(length(Vec3d{near_one(v.x), near_one(v.y), near_one(v.z)}), exponent);
}

Value dot_of(const BuiltinCall& call) {
  return dot(call.vec3(0), call.vec3(1));
}
Value cross_of(const BuiltinCall& call) {
  return cross(call.vec3(0), call.vec3(1));
}
Value length_of(const BuiltinCall& call) {
  return safe_length(call.vec3(0));
}
Value distance_of(const BuiltinCall& call) {
  return safe_length(call.vec3(0) - call.vec3(1));
}
Value normalize_of(const BuiltinCall& call) {
  const double size = size_of(call.vec3(0));
  if (size == 0) return call.outside_domain(0, "a vector other than <0, 0, 0>");
  return normalized(call.vec3(0) / size);
}
Value angle_between(const BuiltinCall& call) {
  for (const std::size_t i : {0U, 1U}) {
    if (size_of(call.vec3(i)) == 0) {
      return call.outside_domain(i, "a vector other than <0, 0, 0>");
    }
  }
  const Vec3d a = call.vec3(0) / size_of(call.vec3(0)), b = call.vec3(1) / size_of(call.vec3(1));
  return Angle{atan2_deg(length(cross(a, b)), dot(a, b))};
}
Value turned(const BuiltinCall& call) {
  if (call.values[1].is(Type::transform)) {
    return call.values[1].as<TransformPtr>().matrix->vector(call.vec3(0));
  }
  const Vec3d deg = call.values[1].as<AngleVector>().deg;
  return (rotation({0, 0, 1}, deg.z) * rotation({0, 1, 0}, deg.y) * rotation({1, 0, 0}, deg.x))
      .vector(call.vec3(0));
}
Value vec_of(const BuiltinCall& call) {
  return Vec3d{call.number(0), call.number(1), call.number(2)};
}

constexpr BuiltinFunction kFunctions[] = {
    {"angle_between", kTwo, false, "angle", "the angle between two directions", angle_between},
    {"cross", kTwo, false, "vector", "the cross product", cross_of},
    {"distance", kTwo, false, "number", "the length of the difference", distance_of},
    {"dot", kTwo, false, "number", "the dot product", dot_of},
    {"length", kOne, false, "number", "the length", length_of},
    {"normalize", kOne, false, "vector", "the vector of length 1 in the same direction",
     normalize_of},
    {"turn", kTurn, false, "vector", "the vector after a rotation, as `rotate` takes it", turned},
    {"vec", kComponents, false, "vector", "the same as <x, y, z>", vec_of},
};

}  // namespace

std::span<const BuiltinFunction> vector_functions() {
  return kFunctions;
}

}  // namespace alhazen::parser

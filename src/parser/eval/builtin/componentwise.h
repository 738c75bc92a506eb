// parser/eval: functions of one number applied to each component of what has several.
#pragma once

#include "parser/eval/value.h"

namespace alhazen::parser {

// Precondition: a number, an angle, a vector, a vector of angles or a colour.
template <class Map>
Value map_components(const Value& value, Map f) {
  const auto each = [&](Vec3d v) { return Vec3d{f(v.x), f(v.y), f(v.z)}; };
  switch (value.type()) {
    case Type::number:
      return f(value.number());
    case Type::angle:
      return Angle{f(value.as<Angle>().deg)};
    case Type::vec2:
      return Vec2d{f(value.as<Vec2d>().x), f(value.as<Vec2d>().y)};
    case Type::vec3:
      return each(value.as<Vec3d>());
    case Type::angles:
      return AngleVector{each(value.as<AngleVector>().deg)};
    case Type::color: {
      const auto c = value.as<Rgbd>();
      return Rgbd{f(c.r), f(c.g), f(c.b)};
    }
    default:
      return Poison{};
  }
}

// visit(component) for each of them. Precondition: as above.
template <class Visit>
void for_each_component(const Value& value, Visit visit) {
  map_components(value, [&](double c) {
    visit(c);
    return c;
  });
}

// Precondition: both of one type, which is one of those above.
template <class Combine>
Value combine(const Value& a, const Value& b, Combine f) {
  const auto each = [&](Vec3d v, Vec3d w) { return Vec3d{f(v.x, w.x), f(v.y, w.y), f(v.z, w.z)}; };
  switch (a.type()) {
    case Type::number:
      return f(a.number(), b.number());
    case Type::angle:
      return Angle{f(a.as<Angle>().deg, b.as<Angle>().deg)};
    case Type::vec2: {
      const auto v = a.as<Vec2d>(), w = b.as<Vec2d>();
      return Vec2d{f(v.x, w.x), f(v.y, w.y)};
    }
    case Type::vec3:
      return each(a.as<Vec3d>(), b.as<Vec3d>());
    case Type::angles:
      return AngleVector{each(a.as<AngleVector>().deg, b.as<AngleVector>().deg)};
    case Type::color: {
      const auto c = a.as<Rgbd>(), d = b.as<Rgbd>();
      return Rgbd{f(c.r, d.r), f(c.g, d.g), f(c.b, d.b)};
    }
    default:
      return Poison{};
  }
}

}  // namespace alhazen::parser

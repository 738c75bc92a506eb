// parser/eval: short names for the sets of types that tables are written with.
#pragma once

#include "parser/eval/value.h"

namespace alhazen::parser {

inline constexpr TypeSet kNumber = set_of(Type::number);
inline constexpr TypeSet kAngle = set_of(Type::angle);
inline constexpr TypeSet kBool = set_of(Type::boolean);
inline constexpr TypeSet kString = set_of(Type::string);
inline constexpr TypeSet kVec2 = set_of(Type::vec2);
inline constexpr TypeSet kVec3 = set_of(Type::vec3);
inline constexpr TypeSet kAngles = set_of(Type::angles);
inline constexpr TypeSet kColor = set_of(Type::color);
inline constexpr TypeSet kList = set_of(Type::list);
inline constexpr TypeSet kRange = set_of(Type::range);
inline constexpr TypeSet kTexture = set_of(Type::texture);
inline constexpr TypeSet kHighlight = set_of(Type::highlight);
inline constexpr TypeSet kMaterial = set_of(Type::material);
inline constexpr TypeSet kObject = set_of(Type::object);
inline constexpr TypeSet kTransform = set_of(Type::transform);

}  // namespace alhazen::parser

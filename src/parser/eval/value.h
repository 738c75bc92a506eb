// parser/eval: what an expression of the language can be. Values are immutable and cheap to copy.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/cheap_variant.h"
#include "core/math/transform.h"
#include "core/math/vec.h"
#include "core/scene/material.h"
#include "core/scene/shape.h"
#include "core/scene/texture.h"
#include "parser/ast/ast.h"

namespace alhazen::parser {

class Scope;
struct Group;
struct Value;
struct BuiltinFunction;

// Stands for the value of something that has been reported: it spreads through expressions and is
// never reported again.
struct Poison {};
// Held in degrees, so that cos(90deg) is 0.
struct Angle {
  double deg = 0;
};
struct Vec2d {
  double x = 0, y = 0;
};
// Rotations about x, then y, then z.
struct AngleVector {
  Vec3d deg;
};
struct Text {
  std::shared_ptr<const std::string> bytes;
};
struct List {
  std::vector<Value> elements;
  int depth = 1;             // of lists within lists
  std::uint64_t weight = 1;  // values in it at all depths: what comparing it may cost
};
using ListPtr = std::shared_ptr<const List>;
// first, first + step, ... before last, or up to it when inclusive. Of numbers or of angles.
struct Interval {
  double first = 0, last = 0, step = 1;
  bool inclusive = false;
  bool has_step = false;
  bool of_angles = false;
  // How many values it has; up to 2^53, more are counted as that.
  double count() const;
};
using IntervalPtr = std::shared_ptr<const Interval>;
// A function of the scene and the scope that it sees, or one that is built in. Scopes that a
// function sees live as long as the evaluation.
struct Function {
  const ast::Function* definition = nullptr;
  Scope* scope = nullptr;
};
struct TextureRef {
  TextureId id;
};
struct HighlightPtr {
  std::shared_ptr<const Highlight> highlight;
};
struct MaterialRef {
  MaterialId id;
};
struct Object {
  std::shared_ptr<const Group> group;
};
struct TransformPtr {
  std::shared_ptr<const Affined> matrix;
};

// In the order of the alternatives of Value.
enum class Type {
  poison,
  number,
  angle,
  boolean,
  string,
  vec2,
  vec3,
  angles,
  color,
  list,
  range,
  function,
  builtin,
  texture,
  highlight,
  material,
  object,
  transform,
};
inline constexpr int kTypeCount = 18;

// A set of types, one bit each.
using TypeSet = std::uint32_t;
constexpr TypeSet set_of(Type type) {
  return TypeSet{1} << static_cast<int>(type);
}
template <class... Types>
constexpr TypeSet set_of(Type first, Types... rest) {
  return set_of(first) | set_of(rest...);
}
inline constexpr TypeSet kAnyType = ~TypeSet{0};

struct Value {
  using Storage = CheapVariant<Poison, double, Angle, bool, Text, Vec2d, Vec3d, AngleVector, Rgbd,
                               ListPtr, IntervalPtr, Function, const BuiltinFunction*, TextureRef,
                               HighlightPtr, MaterialRef, Object, TransformPtr>;
  Storage storage;

  Value() = default;
  template <class T>
  requires Storage::has<T> Value(T v) : storage(std::move(v)) {}

  Type type() const { return static_cast<Type>(storage.index()); }
  bool is(Type t) const { return type() == t; }
  bool is_poison() const { return is(Type::poison); }
  template <class T>
  const T& as() const {
    return storage.get<T>();
  }
  double number() const { return as<double>(); }
  const std::string& text() const { return *as<Text>().bytes; }
  const std::vector<Value>& elements() const { return as<ListPtr>()->elements; }
};

// "number", "angle", ... as messages and the manual call it.
std::string_view type_name(Type type);
// With its article: "a number", "an angle".
std::string_view a_type_name(Type type);
// "a number or an angle".
std::string describe(TypeSet types);

// As the language would write it, with as many digits as are needed to read it back. Strings
// within lists are quoted, alone they are not. At most `max_length` bytes, then "...".
std::string to_text(const Value& value, std::size_t max_length = 4096);
std::string number_text(double value);

// Equality of two values of one type; functions are equal to themselves only.
bool equal(const Value& a, const Value& b);

bool is_finite(const Value& value);

}  // namespace alhazen::parser

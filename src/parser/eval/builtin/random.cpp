// parser/eval: chance without state. Each function is pure: the same arguments give the same
// number, on every machine and in whatever order a scene is evaluated.
#include <bit>
#include <cstdint>

#include "core/base/hash.h"
#include "core/math/elementary.h"
#include "parser/eval/builtin/builtin.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {
namespace {

constexpr TypeSet kSeedTypes = kNumber | kAngle | kBool | kString | kVec2 | kVec3;
constexpr BuiltinParameter kSeeds[] = {{"seed", kSeedTypes}};
constexpr BuiltinParameter kBetween[] = {{"low", kNumber}, {"high", kNumber}, {"seed", kSeedTypes}};
constexpr BuiltinParameter kChoice[] = {{"values", kList}, {"seed", kSeedTypes}};
constexpr BuiltinParameter kNoise[] = {{"point", kNumber | kVec3}, {"seed", kNumber, true}};

std::uint64_t word_of(double x) {
  return std::bit_cast<std::uint64_t>(x + 0.0);
}

std::uint64_t hash_of(const Value& seed) {
  const auto type = static_cast<std::uint64_t>(seed.type());
  switch (seed.type()) {
    case Type::number:
      return mix_64(type, word_of(seed.number()));
    case Type::angle:
      return mix_64(type, word_of(seed.as<Angle>().deg));
    case Type::boolean:
      return mix_64(type, seed.as<bool>() ? 1 : 0);
    case Type::string:
      return mix_64(type, fnv1a_64(seed.text()));
    case Type::vec2: {
      const auto v = seed.as<Vec2d>();
      return mix_64(mix_64(type, word_of(v.x)), word_of(v.y));
    }
    default: {
      const auto v = seed.as<Vec3d>();
      return mix_64(mix_64(mix_64(type, word_of(v.x)), word_of(v.y)), word_of(v.z));
    }
  }
}

// Of the arguments from `first` on, in order, apart for each `stream`.
std::uint64_t hash_of(const BuiltinCall& call, std::size_t first, std::uint64_t stream = 0) {
  std::uint64_t state = mix_64(0x616c68617a656eULL, stream);
  for (std::size_t i = first; i < call.values.size(); ++i) {
    const Value& seed = call.values[i];
    // Out of fuel the number does not matter: the evaluation ends.
    if (seed.is(Type::string) && !call.context.spend_scan(seed.text().size(), call.spans[i])) {
      return state;
    }
    state = mix_64(state, hash_of(seed));
  }
  return state;
}

// The 53 upper bits: every multiple of 2^-53 in [0, 1) is equally likely.
double unit(std::uint64_t word) {
  return static_cast<double>(word >> 11) * 0x1p-53;
}

Value random_of(const BuiltinCall& call) {
  return unit(hash_of(call, 0));
}
Value random_in(const BuiltinCall& call) {
  const double low = call.number(0), high = call.number(1);
  if (!(low <= high)) return call.outside_domain(0, "a lower bound that is not above the upper");
  const double u = unit(hash_of(call, 2));
  return (1 - u) * low + u * high;
}
Value random_vector(const BuiltinCall& call) {
  return Vec3d{unit(hash_of(call, 0, 1)), unit(hash_of(call, 0, 2)), unit(hash_of(call, 0, 3))};
}
// By Archimedes: the height of a uniform point of the sphere is uniform.
Value random_direction(const BuiltinCall& call) {
  const double height = 2 * unit(hash_of(call, 0, 1)) - 1;
  const double around = 360 * unit(hash_of(call, 0, 2));
  const double radius = square_root((1 - height) * (1 + height));
  return Vec3d{radius * cos_deg(around), height, radius * sin_deg(around)};
}
Value choose(const BuiltinCall& call) {
  const auto& values = call.values[0].elements();
  if (values.empty()) return call.outside_domain(0, "a list with at least one element");
  const double index = round_down(unit(hash_of(call, 1)) * static_cast<double>(values.size()));
  return values[static_cast<std::size_t>(index)];
}

// Value noise: random numbers at the corners of the unit cubes, smoothed between by the quintic of
// Perlin (2002). In [0, 1), continuous with two derivatives.
Value noise(const BuiltinCall& call) {
  const Vec3d p =
      call.values[0].is(Type::vec3) ? call.vec3(0) : Vec3d{call.values[0].number(), 0, 0};
  const double seed = call.number_or(1, 0);
  const Vec3d cell{round_down(p.x), round_down(p.y), round_down(p.z)};
  const Vec3d f = p - cell;
  const auto ease = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
  const Vec3d w{ease(f.x), ease(f.y), ease(f.z)};
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3d at = cell;
    double weight = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const bool far = ((corner >> axis) & 1) != 0;
      at[axis] += far ? 1 : 0;
      weight *= far ? w[axis] : 1 - w[axis];
    }
    const std::uint64_t word =
        mix_64(mix_64(mix_64(word_of(seed), word_of(at.x)), word_of(at.y)), word_of(at.z));
    sum += weight * unit(word);
  }
  return sum;
}

constexpr BuiltinFunction kFunctions[] = {
    {"choose", kChoice, true, "an element", "one of the elements, by chance", choose},
    {"noise", kNoise, false, "number", "a smooth random function of space, from 0 to 1", noise},
    {"random", kSeeds, true, "number", "a random number from 0 up to 1; other seeds give another",
     random_of},
    {"random_direction", kSeeds, true, "vector", "a random vector of length 1", random_direction},
    {"random_in", kBetween, true, "number", "a random number between two bounds", random_in},
    {"random_vector", kSeeds, true, "vector", "a random point of the unit cube", random_vector},
};

}  // namespace

std::span<const BuiltinFunction> random_functions() {
  return kFunctions;
}

}  // namespace alhazen::parser

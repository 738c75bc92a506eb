#include "render/shape/twins.h"

#include <algorithm>
#include <cmath>

#include "render/shape/bounds.h"

namespace alhazen::render {
namespace {

// Points on a shape are rounded a few times; and shapes that are meant to be one may have been
// computed in two ways.
constexpr int kUlps = 16;
// A mesh has neighbours that are as far apart as they are large.
constexpr int kLeastSize = 256;

template <class Real>
Real extent_of(const Landmarks<Real>& marks) {
  Real extent = 0;
  for (const Real length : marks.lengths)
    extent = larger(extent, absolute(length));
  return extent;
}

template <class Real>
constexpr Real kTolerance = Real(2 * kUlps) * ScalarTraits<Real>::unit_roundoff();

// A number that twins share, but for `reach`; others do hardly ever. Square roots of primes have no
// linear relation with whole factors, so places of a grid have different numbers.
struct Keyed {
  double key, reach;
  ShapeId id;
};
template <class Real>
Keyed keyed(ShapeId id, const Landmarks<Real>& marks) {
  static constexpr double kPrimes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41};
  static const std::vector<double> kWeights = [] {
    std::vector<double> weights;
    for (const double prime : kPrimes)
      weights.push_back(std::sqrt(prime));
    return weights;
  }();
  const double rounding = std::max(static_cast<double>(kTolerance<Real>), kTolerance<double>);
  double key = 0, weight = 0;
  if (!is_finite(marks.size)) {
    for (int axis = 0; axis < 3; ++axis)
      key += kWeights[axis] * static_cast<double>(marks.direction[axis]);
    return {key, 8 * rounding, id};
  }
  for (int i = 0; i < marks.used; ++i) {
    key += kWeights[i] * static_cast<double>(marks.lengths[i]);
    weight += kWeights[i];
  }
  return {key, 2 * weight * rounding * static_cast<double>(extent_of(marks)), id};
}

}  // namespace

void Twins::add(std::vector<ShapeId> layers, const std::function<int(ShapeId)>& rank) {
  std::sort(layers.begin(), layers.end());
  const ShapeId stand_in = layers.front();
  std::stable_sort(layers.begin(), layers.end(),
                   [&](ShapeId a, ShapeId b) { return rank(a) < rank(b); });
  for (std::size_t layer = 0; layer < layers.size(); ++layer)
    places_[layers[layer]] = {stacks_.size(), layer};
  stacks_.push_back({stand_in, std::move(layers)});
}

void Twins::add(const Twins& others, const std::function<ShapeId(ShapeId)>& id_of,
                const std::function<int(ShapeId)>& rank) {
  for (const Stack& stack : others.stacks_) {
    std::vector<ShapeId> layers;
    for (const ShapeId layer : stack.layers)
      layers.push_back(id_of(layer));
    add(std::move(layers), rank);
  }
}

template <class Real>
bool are_twins(const Landmarks<Real>& a, const Landmarks<Real>& b) {
  if (a.form != b.form) return false;
  Real apart = 0;
  for (std::size_t i = 0; i < a.lengths.size(); ++i)
    apart = larger(apart, absolute(a.lengths[i] - b.lengths[i]));
  const Vec3<Real> turned = a.direction - b.direction;
  return apart <= kTolerance<Real> * larger(extent_of(a), extent_of(b)) &&
         apart * Real(kLeastSize) <= smaller(a.size, b.size) &&
         largest_coordinate(turned) <= kTolerance<Real>;
}

template <class Real>
Twins find_twins(ShapeId shapes, const std::function<Landmarks<Real>(ShapeId)>& landmarks_of,
                 const std::function<int(ShapeId)>& rank) {
  std::vector<Keyed> all;
  all.reserve(shapes);
  for (ShapeId id = 0; id < shapes; ++id) {
    const Keyed shape = keyed(id, landmarks_of(id));
    if (std::isfinite(shape.key)) all.push_back(shape);
  }
  std::sort(all.begin(), all.end(), [](const Keyed& a, const Keyed& b) {
    return a.key != b.key ? a.key < b.key : a.id < b.id;
  });
  Twins twins;
  std::vector<bool> taken(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (taken[i]) continue;
    std::vector<ShapeId> layers;
    for (std::size_t k = i + 1; k < all.size() && all[k].key - all[i].key <= all[i].reach; ++k) {
      if (taken[k] || !are_twins(landmarks_of(all[i].id), landmarks_of(all[k].id))) continue;
      taken[k] = true;
      layers.push_back(all[k].id);
    }
    if (layers.empty()) continue;
    layers.push_back(all[i].id);
    twins.add(std::move(layers), rank);
  }
  return twins;
}

template bool are_twins(const Landmarks<float>&, const Landmarks<float>&);
template bool are_twins(const Landmarks<double>&, const Landmarks<double>&);
template Twins find_twins(ShapeId, const std::function<Landmarks<float>(ShapeId)>&,
                          const std::function<int(ShapeId)>&);
template Twins find_twins(ShapeId, const std::function<Landmarks<double>(ShapeId)>&,
                          const std::function<int(ShapeId)>&);
#if ALHAZEN_HAS_QUAD
template bool are_twins(const Landmarks<Quad>&, const Landmarks<Quad>&);
template Twins find_twins(ShapeId, const std::function<Landmarks<Quad>(ShapeId)>&,
                          const std::function<int(ShapeId)>&);
#endif

}  // namespace alhazen::render

// render/wave: rays in flight, structure of arrays, in the order that every stage keeps.
//
// Order is what makes a picture's bits independent of how work is cut: of one camera sample's rays
// each stage handles them in queue order and appends in that order, so the sum into the sample is
// the same whatever else shares the batch (docs/waves.md).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "core/math/vec.h"
#include "render/accel/hit.h"
#include "render/surface/texture_point.h"
#include "render/wave/media.h"

namespace alhazen::render {

// The camera sample of a batch that a ray belongs to.
using SlotId = std::uint32_t;

template <class Real>
struct RayQueue {
  std::vector<Vec3<Real>> origin, direction;
  std::vector<Source> source;
  std::vector<Rgb<Real>> weight;  // of the radiance that comes along the ray, in the sample's
  std::vector<SlotId> slot;
  std::vector<MediumId> medium;       // what the ray starts in
  std::vector<std::uint64_t> path;    // names the branch of the ray tree: seeds its random numbers
  std::vector<std::uint32_t> depth;   // reflections and refractions so far
  std::vector<std::uint32_t> passed;  // surfaces that the same line has come straight through

  std::size_t size() const { return slot.size(); }
  bool empty() const { return slot.empty(); }
  Ray<Real> ray(std::size_t i) const { return {origin[i], direction[i]}; }

  void push(const Ray<Real>& ray, const Source& from, Rgb<Real> w, SlotId s, MediumId m,
            std::uint64_t p, std::uint32_t d, std::uint32_t straight_through = 0) {
    origin.push_back(ray.origin);
    direction.push_back(ray.direction);
    source.push_back(from);
    weight.push_back(w);
    slot.push_back(s);
    medium.push_back(m);
    path.push_back(p);
    depth.push_back(d);
    passed.push_back(straight_through);
  }
  void clear() { truncate(0); }

  // Brings the rays of each sample together without changing their order. Stages append by kind of
  // surface, so a generation is not sorted by itself, and need not be unless it is cut.
  void group_by_sample() {
    std::vector<std::uint32_t> order(size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [this](std::uint32_t a, std::uint32_t b) { return slot[a] < slot[b]; });
    const auto reorder = [&order](auto& values) {
      auto sorted = values;
      for (std::size_t i = 0; i < order.size(); ++i)
        sorted[i] = values[order[i]];
      values = std::move(sorted);
    };
    reorder(origin);
    reorder(direction);
    reorder(source);
    reorder(weight);
    reorder(slot);
    reorder(medium);
    reorder(path);
    reorder(depth);
    reorder(passed);
  }

  // Precondition: grouped by sample. An index near `near` at which another sample's rays begin; 0
  // if all are of one sample.
  std::size_t cut_near(std::size_t near) const {
    std::size_t below = near;
    while (below > 0 && slot[below - 1] == slot[below])
      --below;
    if (below > 0) return below;
    std::size_t above = near + 1;
    while (above < size() && slot[above - 1] == slot[above])
      ++above;
    return above < size() ? above : 0;
  }

  // Takes the rays from `begin` on out of the queue.
  RayQueue split_off(std::size_t begin) {
    RayQueue tail;
    const auto move_tail = [begin](auto& from, auto& to) {
      to.assign(from.begin() + static_cast<std::ptrdiff_t>(begin), from.end());
    };
    move_tail(origin, tail.origin);
    move_tail(direction, tail.direction);
    move_tail(source, tail.source);
    move_tail(weight, tail.weight);
    move_tail(slot, tail.slot);
    move_tail(medium, tail.medium);
    move_tail(path, tail.path);
    move_tail(depth, tail.depth);
    move_tail(passed, tail.passed);
    truncate(begin);
    return tail;
  }

 private:
  void truncate(std::size_t size) {
    origin.resize(size);
    direction.resize(size);
    source.resize(size);
    weight.resize(size);
    slot.resize(size);
    medium.resize(size);
    path.resize(size);
    depth.resize(size);
    passed.resize(size);
  }
};

// What the rays of one generation met, in their order; a ray that met nothing has no entry.
template <class Real>
struct HitQueue {
  std::vector<std::uint32_t> ray;  // index into the generation's RayQueue
  std::vector<Hit<Real>> hit;
  std::vector<MaterialId> material;
  // Faces passed at the very point of the hit without being an interface; only where rays pass
  // through things.
  std::vector<std::array<Touched, 4>> passed;
  std::vector<Vec3<Real>> position;               // on the surface, world frame of the renderer
  std::vector<Vec3<Real>> geometric_normal;       // outward, unit
  std::vector<Vec3<Real>> shading_normal;         // unit, on the side that the ray came from
  std::vector<TexturePoint<Real>> texture_point;  // only where the plan has textures
  std::vector<Rgb<Real>> color;  // albedo or reflectance, of materials that have one

  std::size_t size() const { return ray.size(); }
  void push(std::uint32_t r, const Hit<Real>& what, MaterialId m) {
    ray.push_back(r);
    hit.push_back(what);
    material.push_back(m);
  }
  void clear() {
    ray.clear();
    hit.clear();
    material.clear();
    passed.clear();
  }
  void resize_points() {
    position.resize(ray.size());
    geometric_normal.resize(ray.size());
    shading_normal.resize(ray.size());
  }
};

// Light on its way to a surface: what it will add if nothing stands between.
template <class Real>
struct ShadowQueue {
  std::vector<Vec3<Real>> origin, direction;
  std::vector<Source> source;
  std::vector<Real> distance;        // to the light; infinite for a directional one
  std::vector<ShapeId> light_shape;  // the light's own visible surface, which does not shadow it
  std::vector<Rgb<Real>> radiance;
  std::vector<SlotId> slot;
  std::vector<MediumId> medium;

  std::size_t size() const { return slot.size(); }
  void push(const Ray<Real>& ray, const Source& from, Real dist, ShapeId shape, Rgb<Real> l,
            SlotId s, MediumId m) {
    origin.push_back(ray.origin);
    direction.push_back(ray.direction);
    source.push_back(from);
    distance.push_back(dist);
    light_shape.push_back(shape);
    radiance.push_back(l);
    slot.push_back(s);
    medium.push_back(m);
  }
  void clear() {
    origin.clear();
    direction.clear();
    source.clear();
    distance.clear();
    light_shape.clear();
    radiance.clear();
    slot.clear();
    medium.clear();
  }
};

}  // namespace alhazen::render

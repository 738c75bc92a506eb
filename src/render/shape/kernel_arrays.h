// render/shape: the kernels of all shapes, one array for each kind, and which of them a shape is.
#pragma once

#include <utility>
#include <vector>

#include "core/math/transform.h"
#include "core/scene/shape.h"
#include "render/shape/box.h"
#include "render/shape/disc.h"
#include "render/shape/frustum.h"
#include "render/shape/parallelogram.h"
#include "render/shape/plane.h"
#include "render/shape/sphere.h"
#include "render/shape/triangle.h"

namespace alhazen::render {

enum class Kind : std::uint8_t { sphere, plane, box, disc, frustum, triangle, parallelogram };

// How an object frame lies in the world.
template <class Real>
struct Placement {
  Affine<Real> world_from_object, object_from_world;

  static auto fields(auto& p) {
    return std::tie(p.world_from_object.rows, p.object_from_world.rows);
  }
  Ray<Real> in_object(const Ray<Real>& ray) const {
    return {object_from_world.point(ray.origin), object_from_world.vector(ray.direction)};
  }
};

// Which kernel a shape is. A million spheres are a million of these.
struct Entry {
  static constexpr std::uint32_t kNotPlaced = (1U << 28) - 1;

  std::uint32_t index;                // in the array of its kind
  std::uint32_t kind : 3;             // a Kind
  std::uint32_t in_object_frame : 1;  // the ray has to be mapped
  std::uint32_t placement : 28;       // kNotPlaced: the object frame is the scene's world

  bool is_placed() const { return placement != kNotPlaced; }
};
static_assert(sizeof(Entry) == 8);

template <class Real>
struct KernelArrays {
  std::vector<Sphere<Real>> spheres;
  std::vector<Plane<Real>> planes;
  std::vector<Box<Real>> boxes;
  std::vector<Disc<Real>> discs;
  std::vector<Frustum<Real>> frusta;
  std::vector<Triangle<Real>> triangles;
  std::vector<Parallelogram<Real>> parallelograms;

  // What `visitor` makes of the array of that kind.
  template <class Visitor>
  auto visit(Kind kind, const Visitor& visitor) const {
    switch (kind) {
      case Kind::sphere:
        return visitor(spheres);
      case Kind::plane:
        return visitor(planes);
      case Kind::box:
        return visitor(boxes);
      case Kind::disc:
        return visitor(discs);
      case Kind::frustum:
        return visitor(frusta);
      case Kind::triangle:
        return visitor(triangles);
      case Kind::parallelogram:
        break;
    }
    return visitor(parallelograms);
  }
  // What it makes of one kernel.
  template <class Visitor>
  auto visit(const Entry& entry, const Visitor& visitor) const {
    return visit(static_cast<Kind>(entry.kind),
                 [&](const auto& kernels) { return visitor(kernels[entry.index]); });
  }
};

}  // namespace alhazen::render

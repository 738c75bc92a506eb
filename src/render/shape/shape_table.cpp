#include "render/shape/shape_table.h"

#include "core/base/overloaded.h"
#include "render/shape/convert.h"
#include "render/shape/doubt_flat.h"
#include "render/shape/doubt_solid.h"

namespace alhazen::render {
namespace {

// The disc, the triangle and the parallelogram bound nothing.
template <class Kernel, class Real>
bool encloses(const Kernel& kernel, Vec3<Real> point) {
  if constexpr (requires { contains(kernel, point); }) {
    return contains(kernel, point);
  } else {
    return false;
  }
}

}  // namespace

template <class Real>
class ShapeTable<Real>::Builder {
 public:
  Builder(ShapeTable& table, Vec3d origin) : table_(table), origin_(origin) {}

  void add(const Shape& shape) {
    Entry entry{};
    entry.placement = kNoId;
    Placed place{};
    if (shape.world_from_object) {
      place = placed(*shape.world_from_object);
      entry.placement = static_cast<std::uint32_t>(table_.placements_.size());
      table_.placements_.push_back(
          {Affine<Real>(place.world_from_object), Affine<Real>(place.object_from_world)});
    }
    const Placed* there = shape.world_from_object ? &place : nullptr;
    std::visit(
        Overloaded{
            [&](const alhazen::Sphere& s) { in_object(entry, s, Kind::sphere, table_.spheres_); },
            [&](const alhazen::Box& s) { in_object(entry, s, Kind::box, table_.boxes_); },
            [&](const alhazen::Disc& s) { in_object(entry, s, Kind::disc, table_.discs_); },
            [&](const Cylinder& s) { in_object(entry, s, Kind::frustum, table_.frusta_); },
            [&](const Cone& s) { in_object(entry, s, Kind::frustum, table_.frusta_); },
            [&](const alhazen::Plane& s) {
              in_world(entry, s, there, Kind::plane, table_.planes_);
            },
            [&](const alhazen::Triangle& s) {
              in_world(entry, s, there, Kind::triangle, table_.triangles_);
            },
            [&](const Quad4& s) {
              in_world(entry, s, there, Kind::parallelogram, table_.parallelograms_);
            }},
        shape.geometry);
  }

 private:
  // The placement as seen from the origin of the table; the scene promises it is not singular.
  Placed placed(Affined world_from_object) const {
    for (int i = 0; i < 3; ++i)
      world_from_object.rows[i][3] -= origin_[i];
    return {world_from_object, inverse(world_from_object).value_or(Affined()),
            determinant(world_from_object) < 0};
  }

  template <class Geometry, class Kernel>
  void in_object(Entry entry, const Geometry& geometry, Kind kind, std::vector<Kernel>& kernels) {
    entry.in_object_frame = entry.placement != kNoId;
    const Vec3d origin = entry.in_object_frame ? Vec3d() : origin_;
    push(entry, kind, kernels, convert<Real>(from_scene(geometry, origin)));
  }

  template <class Geometry, class Kernel>
  void in_world(Entry entry, const Geometry& geometry, const Placed* place, Kind kind,
                std::vector<Kernel>& kernels) {
    push(entry, kind, kernels,
         convert<Real>(place != nullptr ? from_scene(geometry, *place)
                                        : from_scene(geometry, origin_)));
  }

  template <class Kernel>
  void push(Entry entry, Kind kind, std::vector<Kernel>& kernels, const Kernel& kernel) {
    entry.kind = kind;
    entry.index = static_cast<std::uint32_t>(kernels.size());
    kernels.push_back(kernel);
    table_.entries_.push_back(entry);
  }

  ShapeTable& table_;
  Vec3d origin_;
};

template <class Real>
ShapeTable<Real>::ShapeTable(const std::vector<Shape>& shapes, Vec3d world_origin)
    : world_origin_(world_origin) {
  Builder builder(*this, world_origin);
  for (const Shape& shape : shapes)
    builder.add(shape);
}

template <class Real>
template <class Visitor>
auto ShapeTable<Real>::visit(const Entry& entry, const Visitor& visitor) const {
  switch (entry.kind) {
    case Kind::sphere:
      return visitor(spheres_[entry.index]);
    case Kind::plane:
      return visitor(planes_[entry.index]);
    case Kind::box:
      return visitor(boxes_[entry.index]);
    case Kind::disc:
      return visitor(discs_[entry.index]);
    case Kind::frustum:
      return visitor(frusta_[entry.index]);
    case Kind::triangle:
      return visitor(triangles_[entry.index]);
    case Kind::parallelogram:
      break;
  }
  return visitor(parallelograms_[entry.index]);
}

// In the frame that the shape's kernel lives in.
template <class Real>
Ray<Real> ShapeTable<Real>::own_ray(const Entry& entry, const Ray<Real>& ray) const {
  if (!entry.in_object_frame) return ray;
  const Affine<Real>& map = placements_[entry.placement].object_from_world;
  return {map.point(ray.origin), map.vector(ray.direction)};
}

template <class Real>
Crossings<Real> ShapeTable<Real>::crossings(ShapeId id, const Ray<Real>& ray,
                                            Departure from) const {
  const Entry& entry = entries_[id];
  const Ray<Real> own = own_ray(entry, ray);
  return visit(entry, [&](const auto& kernel) { return render::crossings(kernel, own, from); });
}

template <class Real>
Doubts<Real> ShapeTable<Real>::doubts(ShapeId id, const Ray<Real>& ray, Departure from) const {
  const Entry& entry = entries_[id];
  const Ray<Real> own = own_ray(entry, ray);
  return visit(entry, [&](const auto& kernel) { return render::doubts(kernel, own, from); });
}

template <class Real>
SurfacePoint<Real> ShapeTable<Real>::surface(ShapeId id, const Ray<Real>& ray,
                                             const Crossing<Real>& crossing) const {
  return find_surface<true>(id, ray, crossing);
}

template <class Real>
SurfacePoint<Real> ShapeTable<Real>::plain_surface(ShapeId id, const Ray<Real>& ray,
                                                   const Crossing<Real>& crossing) const {
  return find_surface<false>(id, ray, crossing);
}

template <class Real>
template <bool with_coordinates>
SurfacePoint<Real> ShapeTable<Real>::find_surface(ShapeId id, const Ray<Real>& ray,
                                                  const Crossing<Real>& crossing) const {
  const Entry& entry = entries_[id];
  const auto on_kernel = [&](const Ray<Real>& own) {
    return visit(entry, [&](const auto& kernel) {
      return render::surface<with_coordinates>(kernel, own, crossing);
    });
  };
  if (entry.placement == kNoId) {
    const Surface<Real> point = on_kernel(ray);
    return {point, point.position + world_origin_};
  }
  const Placement& place = placements_[entry.placement];
  if (!entry.in_object_frame) {
    const Surface<Real> point = on_kernel(ray);
    return {point, place.object_from_world.point(point.position)};
  }
  Surface<Real> point = on_kernel(
      {place.object_from_world.point(ray.origin), place.object_from_world.vector(ray.direction)});
  const Vec3<Real> object_position = point.position;
  point.position = place.world_from_object.point(object_position);
  point.normal = normalized(place.object_from_world.transposed(point.normal));
  point.shading_normal = point.normal;  // smooth triangles have been mapped beforehand
  return {point, object_position};
}

template <class Real>
bool ShapeTable<Real>::contains(ShapeId id, Vec3<Real> point) const {
  const Entry& entry = entries_[id];
  const Vec3<Real> own =
      entry.in_object_frame ? placements_[entry.placement].object_from_world.point(point) : point;
  return visit(entry, [&](const auto& kernel) { return encloses(kernel, own); });
}

template <class Real>
std::optional<ShapeBounds<Real>> ShapeTable<Real>::bounds(ShapeId id) const {
  const Entry& entry = entries_[id];
  return visit(entry, [&]<class Kernel>(const Kernel& kernel) -> std::optional<ShapeBounds<Real>> {
    if constexpr (bounds::HasHull<Kernel, Real>) {
      if (!entry.in_object_frame) return bounds_in_world<Real>(kernel);
      const Placement& place = placements_[entry.placement];
      return bounds_in_world(kernel, place.world_from_object, place.object_from_world);
    } else {
      return std::nullopt;
    }
  });
}

template class ShapeTable<float>;
template class ShapeTable<double>;
#if ALHAZEN_HAS_QUAD
template class ShapeTable<Quad>;
#endif

}  // namespace alhazen::render

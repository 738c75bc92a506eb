#include "render/shape/shape_table.h"

#include "core/base/overloaded.h"
#include "render/shape/doubt_flat.h"
#include "render/shape/doubt_solid.h"
#include "render/shape/from_scene.h"

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

// Of a ball that is not placed: to the bit what bounds_in_world() makes of it, which maps it by the
// identity first. Of a million shapes, those are most.
template <class Real>
ShapeBounds<Real> bounds_of_ball(const Sphere<Real>& ball) {
  bounds::Hull<Real> hull;
  hull.add(ball.center, Vec3<Real>(ball.radius, ball.radius, ball.radius));
  return bounds_around<Real>(ball, hull);
}

}  // namespace

template <class Real>
class ShapeTable<Real>::Builder {
 public:
  Builder(ShapeTable& table, Vec3d origin) : table_(table), origin_(origin) {}

  void add(const Shape& shape) {
    Entry entry{};
    entry.placement = Entry::kNotPlaced;
    Placed place{};
    if (shape.world_from_object) {
      place = placed(*shape.world_from_object, origin_);
      entry.placement = static_cast<std::uint32_t>(table_.placements_.size()) & Entry::kNotPlaced;
      table_.placements_.push_back(
          {Affine<Real>(place.world_from_object), Affine<Real>(place.object_from_world)});
    }
    const Placed* there = shape.world_from_object ? &place : nullptr;
    std::visit(
        Overloaded{
            [&](const alhazen::Sphere& s) {
              in_object(entry, s, Kind::sphere, table_.kernels_.spheres);
            },
            [&](const alhazen::Box& s) { in_object(entry, s, Kind::box, table_.kernels_.boxes); },
            [&](const alhazen::Disc& s) { in_object(entry, s, Kind::disc, table_.kernels_.discs); },
            [&](const Cylinder& s) { in_object(entry, s, Kind::frustum, table_.kernels_.frusta); },
            [&](const Cone& s) { in_object(entry, s, Kind::frustum, table_.kernels_.frusta); },
            [&](const alhazen::Plane& s) {
              in_world(entry, s, there, Kind::plane, table_.kernels_.planes);
            },
            [&](const alhazen::Triangle& s) {
              in_world(entry, s, there, Kind::triangle, table_.kernels_.triangles);
            },
            [&](const Quad4& s) {
              in_world(entry, s, there, Kind::parallelogram, table_.kernels_.parallelograms);
            }},
        shape.geometry);
  }

 private:
  template <class Geometry, class Kernel>
  void in_object(Entry entry, const Geometry& geometry, Kind kind, std::vector<Kernel>& kernels) {
    entry.in_object_frame = entry.is_placed();
    const Vec3d origin = entry.is_placed() ? Vec3d() : origin_;
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
    entry.kind = static_cast<std::uint32_t>(kind);
    entry.index = static_cast<std::uint32_t>(kernels.size());
    kernels.push_back(kernel);
    table_.entries_.push_back(entry);
  }

  ShapeTable& table_;
  Vec3d origin_;
};

template <class Real>
ShapeTable<Real>::ShapeTable(const ShapeList& shapes, Vec3d world_origin,
                             const std::function<int(ShapeId)>& rank, double reach)
    : world_origin_(world_origin) {
  entries_.reserve(shapes.size());
  Builder builder(*this, world_origin);
  for (const Shape& shape : shapes)
    builder.add(shape);
  twins_ = find_twins<Real>(
      size(), [this](ShapeId id) { return landmarks(id); },
      rank ? rank : [](ShapeId) { return 0; });
  lay_sheets(shapes, static_cast<Real>(reach));
}

// In the frame that the shape's kernel lives in.
template <class Real>
Ray<Real> ShapeTable<Real>::own_ray(const Entry& entry, const Ray<Real>& ray) const {
  return entry.in_object_frame ? placements_[entry.placement].in_object(ray) : ray;
}

template <class Real>
Crossings<Real> ShapeTable<Real>::crossings(ShapeId id, const Ray<Real>& ray,
                                            Departure from) const {
  const Entry& entry = entries_[id];
  const Ray<Real> own = own_ray(entry, ray);
  return kernels_.visit(entry,
                        [&](const auto& kernel) { return render::crossings(kernel, own, from); });
}

template <class Real>
Doubts<Real> ShapeTable<Real>::doubts(ShapeId id, const Ray<Real>& ray, Departure from) const {
  const Entry& entry = entries_[id];
  const Ray<Real> own = own_ray(entry, ray);
  return kernels_.visit(entry,
                        [&](const auto& kernel) { return render::doubts(kernel, own, from); });
}

template <class Real>
SurfacePoint<Real> ShapeTable<Real>::surface(ShapeId id, const Ray<Real>& ray,
                                             const Crossing<Real>& crossing) const {
  return surface_of_one<true>(entries_[id], ray, crossing);
}

template <class Real>
SurfacePoint<Real> ShapeTable<Real>::plain_surface(ShapeId id, const Ray<Real>& ray,
                                                   const Crossing<Real>& crossing) const {
  return surface_of_one<false>(entries_[id], ray, crossing);
}

template <class Real>
bool ShapeTable<Real>::contains(ShapeId id, Vec3<Real> point) const {
  const Entry& entry = entries_[id];
  const Vec3<Real> own =
      entry.in_object_frame ? placements_[entry.placement].object_from_world.point(point) : point;
  return kernels_.visit(entry, [&](const auto& kernel) { return encloses(kernel, own); });
}

template <class Real>
std::optional<ShapeBounds<Real>> ShapeTable<Real>::bounds(ShapeId id) const {
  const Entry& entry = entries_[id];
  return kernels_.visit(
      entry, [&]<class Kernel>(const Kernel& kernel) -> std::optional<ShapeBounds<Real>> {
        if constexpr (bounds::HasHull<Kernel, Real>) {
          if constexpr (std::same_as<Kernel, Sphere<Real>>) {
            if (!entry.in_object_frame) return bounds_of_ball(kernel);
          }
          if (!entry.in_object_frame) return bounds_in_world<Real>(kernel);
          const Placement<Real>& place = placements_[entry.placement];
          return bounds_in_world(kernel, place.world_from_object, place.object_from_world);
        } else {
          return std::nullopt;
        }
      });
}

template <class Real>
Landmarks<Real> ShapeTable<Real>::landmarks(ShapeId id) const {
  const Entry& entry = entries_[id];
  const auto place = entry.in_object_frame ? landmarks::Place<Real>(placements_[entry.placement])
                                           : landmarks::Place<Real>();
  Landmarks<Real> marks;
  kernels_.visit(entry, [&](const auto& kernel) { landmarks::put(marks, kernel, place); });
  marks.form = 8 * marks.form + static_cast<int>(entry.kind);
  return marks;
}

template class ShapeTable<float>;
template class ShapeTable<double>;
#if ALHAZEN_HAS_QUAD
template class ShapeTable<Quad>;
#endif

}  // namespace alhazen::render

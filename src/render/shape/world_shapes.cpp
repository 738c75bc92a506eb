#include "render/shape/world_shapes.h"

#include <algorithm>

#include "render/shape/from_scene.h"

namespace alhazen::render {

template <class Real>
WorldShapes<Real>::WorldShapes(const SceneShapes& shapes, Vec3d world_origin,
                               const std::function<int(ShapeId)>& rank)
    : singles_(shapes.singles(), world_origin,
               [&](ShapeId n) { return rank ? rank(shapes.index().id_of_single(n)) : 0; }),
      index_(shapes.index()) {
  // How far the camera is from a group, at most, in the group's frame.
  std::vector<double> reach_of(shapes.prototypes().size(), 0);
  placements_.reserve(shapes.instance_count());
  prototype_of_.reserve(shapes.instance_count());
  for (InstanceId id = 0; id < shapes.instance_count(); ++id) {
    const Placed place = placed(shapes.world_from_group(id), world_origin);
    placements_.push_back(
        {Affine<Real>(place.world_from_object), Affine<Real>(place.object_from_world)});
    prototype_of_.push_back(shapes.prototype_of(id));
    double& reach = reach_of[shapes.prototype_of(id)];
    reach = std::max(reach, largest_coordinate(place.object_from_world.point(Vec3d())));
  }
  for (const ShapeList& prototype : shapes.prototypes())
    prototypes_.emplace_back(prototype, reach_of[prototypes_.size()]);
  if (!has_instances()) return;
  const auto rank_of = [&rank](ShapeId id) { return rank ? rank(id) : 0; };
  const auto id_of_single = [this](ShapeId n) { return index_.id_of_single(n); };
  twins_.add(singles_.twins(), id_of_single, rank_of);
  for (InstanceId id = 0; id < shapes.instance_count(); ++id) {
    const auto id_of = [first = index_.first(id)](ShapeId n) { return first + n; };
    twins_.add(prototypes_[prototype_of_[id]].twins(), id_of, rank_of);
  }
}

template <class Real>
template <class Work>
auto WorldShapes<Real>::with_table(ShapeId id, const Work& work) const {
  constexpr const Placement<Real>* kNotPlaced = nullptr;
  if (!has_instances()) return work(singles_, id, kNotPlaced);
  const InstanceIndex::Place place = index_.locate(id);
  if (place.instance == kNoId) return work(singles_, place.number, kNotPlaced);
  return work(prototypes_[prototype_of_[place.instance]], place.number,
              &placements_[place.instance]);
}

template <class Real>
Vec3<Real> WorldShapes<Real>::lift(ShapeId id) const {
  return with_table(
      id, [](const ShapeTable<Real>& table, ShapeId number, const Placement<Real>* place) {
        const Vec3<Real> own = table.lift(number);
        return place == nullptr ? own : place->world_from_object.vector(own);
      });
}

template <class Real>
Crossings<Real> WorldShapes<Real>::crossings(ShapeId id, const Ray<Real>& ray,
                                             Departure from) const {
  return with_table(
      id, [&](const ShapeTable<Real>& table, ShapeId number, const Placement<Real>* place) {
        return table.crossings(number, place == nullptr ? ray : place->in_object(ray), from);
      });
}

template <class Real>
Doubts<Real> WorldShapes<Real>::doubts(ShapeId id, const Ray<Real>& ray, Departure from) const {
  return with_table(
      id, [&](const ShapeTable<Real>& table, ShapeId number, const Placement<Real>* place) {
        return table.doubts(number, place == nullptr ? ray : place->in_object(ray), from);
      });
}

template <class Real>
SurfacePoint<Real> WorldShapes<Real>::surface(ShapeId id, const Ray<Real>& ray,
                                              const Crossing<Real>& crossing) const {
  return with_table(
      id, [&](const ShapeTable<Real>& table, ShapeId number, const Placement<Real>* place) {
        if (place == nullptr) return table.surface(number, ray, crossing);
        return out_of_group(table.surface(number, place->in_object(ray), crossing), *place);
      });
}

template <class Real>
SurfacePoint<Real> WorldShapes<Real>::plain_surface(ShapeId id, const Ray<Real>& ray,
                                                    const Crossing<Real>& crossing) const {
  return with_table(
      id, [&](const ShapeTable<Real>& table, ShapeId number, const Placement<Real>* place) {
        if (place == nullptr) return table.plain_surface(number, ray, crossing);
        return out_of_group(table.plain_surface(number, place->in_object(ray), crossing), *place);
      });
}

template <class Real>
bool WorldShapes<Real>::contains(ShapeId id, Vec3<Real> point) const {
  return with_table(id, [&](const ShapeTable<Real>& table, ShapeId number,
                            const Placement<Real>* place) {
    return table.contains(number, place == nullptr ? point : place->object_from_world.point(point));
  });
}

template <class Real>
std::optional<ShapeBounds<Real>> WorldShapes<Real>::bounds(ShapeId id) const {
  return with_table(id, [&](const ShapeTable<Real>& table, ShapeId number,
                            const Placement<Real>* place) {
    const auto own = table.bounds(number);
    if (!own || place == nullptr) return own;
    return std::optional(bounds_in_world(*own, place->world_from_object, place->object_from_world));
  });
}

template class WorldShapes<float>;
template class WorldShapes<double>;
#if ALHAZEN_HAS_QUAD
template class WorldShapes<Quad>;
#endif

}  // namespace alhazen::render

#include "render/accel/world_tree.h"

#include <utility>

#include "render/accel/instance_hits.h"
#include "render/accel/shape_hits.h"
#include "render/accel/twin_hits.h"

namespace alhazen::render {
namespace {

// For shape_hits.h, as in shape_tree.cpp.
template <class Real>
auto hits_of(const WorldTree<Real>& tree, const Ray<Real>& ray, const Source& source, Real from,
             Real t_max, ShapeId ignored) {
  return [&tree, &ray, &source, from, t_max, ignored](const Real& to, const auto& take) {
    const WorldShapes<Real>& shapes = tree.shapes();
    const bool leaves = source.shape < shapes.size() && source.shape != ignored;
    if (leaves && !for_each_hit(shapes, ray, source, t_max, source.shape, take)) return;
    const bool goes_on = tree.singles().visit(ray, from, to, [&](ShapeId number) {
      const ShapeId id = tree.id_of_single(number);
      if (id == source.shape || id == ignored) return true;
      return for_each_hit(shapes, ray, source, t_max, id,
                          shapes.singles().crossings(number, ray, Departure()), take);
    });
    if (!goes_on) return;
    tree.instances().visit(ray, from, to, [&](InstanceId instance) {
      return for_each_hit_of_instance(tree, instance, ray, source, from, to, ignored, take);
    });
  };
}

}  // namespace

template <class Real>
std::vector<ShapeTree<Real>> WorldTree<Real>::prototype_trees(const WorldShapes<Real>& shapes,
                                                              int threads) {
  std::vector<ShapeTree<Real>> trees;
  for (const ShapeTable<Real>& prototype : shapes.prototypes())
    trees.emplace_back(prototype, threads);
  return trees;
}

template <class Real>
WorldTree<Real>::WorldTree(const WorldShapes<Real>& shapes, int threads)
    : shapes_(&shapes),
      singles_(shapes.singles(), threads),
      prototypes_(prototype_trees(shapes, threads)),
      instances_(
          shapes.instance_count(), [this](InstanceId id) { return bounds_of(id); },
          [](InstanceId) { return true; }, threads) {
  if (!shapes.has_instances()) return;
  id_of_single_.reserve(shapes.singles().size());
  for (ShapeId number = 0; number < shapes.singles().size(); ++number)
    id_of_single_.push_back(shapes.index().id_of_single(number));
}

template <class Real>
std::optional<ShapeBounds<Real>> WorldTree<Real>::bounds_of(InstanceId id) const {
  const auto& own = prototype_of(id).bounds();
  if (!own) return std::nullopt;
  const Placement<Real>& place = shapes_->placement(id);
  return bounds_in_world(*own, place.world_from_object, place.object_from_world);
}

template <class Real>
std::size_t WorldTree<Real>::bytes() const {
  std::size_t bytes =
      singles_.bytes() + instances_.bytes() + id_of_single_.size() * sizeof(ShapeId);
  for (const ShapeTree<Real>& prototype : prototypes_)
    bytes += prototype.bytes();
  return bytes;
}

template <class Real>
std::optional<Hit<Real>> closest_hit(const WorldTree<Real>& tree, const Ray<Real>& ray,
                                     const Source& source, Real t_max, ShapeId ignored) {
  if (!tree.shapes().has_instances())
    return closest_hit(tree.singles(), ray, source, t_max, ignored);
  return closest_layer(
      tree.shapes(), ray, source, ignored, [&](const Source& from, ShapeId without) {
        return first_after<Real>(nullptr, t_max, hits_of(tree, ray, from, Real(0), t_max, without));
      });
}

template <class Real>
std::optional<Hit<Real>> next_hit(const WorldTree<Real>& tree, const Ray<Real>& ray,
                                  const Source& source, const Hit<Real>& previous, Real t_max,
                                  ShapeId ignored) {
  if (!tree.shapes().has_instances())
    return next_hit(tree.singles(), ray, source, previous, t_max, ignored);
  return next_layer(tree.shapes(), ray, source, previous, ignored,
                    [&](const Source& from, const Hit<Real>* last, ShapeId without) {
                      const Real start = last != nullptr ? last->t : Real(0);
                      return first_after(last, t_max,
                                         hits_of(tree, ray, from, start, t_max, without));
                    });
}

template <class Real>
bool any_hit(const WorldTree<Real>& tree, const Ray<Real>& ray, const Source& source, Real t_max,
             ShapeId ignored) {
  if (!tree.shapes().has_instances()) return any_hit(tree.singles(), ray, source, t_max, ignored);
  return any_layer(tree.shapes(), ray, source, ignored, [&](const Source& from, ShapeId without) {
    return any_of<Real>(t_max, hits_of(tree, ray, from, Real(0), t_max, without));
  });
}

template class WorldTree<float>;
template class WorldTree<double>;
#if ALHAZEN_HAS_QUAD
template class WorldTree<Quad>;
#endif
template std::optional<Hit<float>> closest_hit(const WorldTree<float>&, const Ray<float>&,
                                               const Source&, float, ShapeId);
template std::optional<Hit<float>> next_hit(const WorldTree<float>&, const Ray<float>&,
                                            const Source&, const Hit<float>&, float, ShapeId);
template bool any_hit(const WorldTree<float>&, const Ray<float>&, const Source&, float, ShapeId);
template std::optional<Hit<double>> closest_hit(const WorldTree<double>&, const Ray<double>&,
                                                const Source&, double, ShapeId);
template std::optional<Hit<double>> next_hit(const WorldTree<double>&, const Ray<double>&,
                                             const Source&, const Hit<double>&, double, ShapeId);
template bool any_hit(const WorldTree<double>&, const Ray<double>&, const Source&, double, ShapeId);
#if ALHAZEN_HAS_QUAD
template std::optional<Hit<Quad>> closest_hit(const WorldTree<Quad>&, const Ray<Quad>&,
                                              const Source&, Quad, ShapeId);
template std::optional<Hit<Quad>> next_hit(const WorldTree<Quad>&, const Ray<Quad>&, const Source&,
                                           const Hit<Quad>&, Quad, ShapeId);
template bool any_hit(const WorldTree<Quad>&, const Ray<Quad>&, const Source&, Quad, ShapeId);
#endif

}  // namespace alhazen::render

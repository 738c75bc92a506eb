#include "render/accel/shape_tree.h"

#include "render/accel/shape_hits.h"
#include "render/accel/twin_hits.h"

namespace alhazen::render {
namespace {

// For shape_hits.h: the hits up to t_max from t = `from` on, and others. The shape that the ray
// leaves comes first.
template <class Real>
auto hits_of(const ShapeTree<Real>& tree, const Ray<Real>& ray, const Source& source, Real from,
             Real t_max, ShapeId ignored) {
  return [&tree, &ray, &source, from, t_max, ignored](const Real& to, const auto& take) {
    const ShapeTable<Real>& table = tree.table();
    const auto consider = [&](ShapeId id) {
      return for_each_hit(table, ray, source, t_max, id, take);
    };
    if (source.shape < table.size() && source.shape != ignored && !consider(source.shape)) return;
    tree.visit(ray, from, to,
               [&](ShapeId id) { return id == source.shape || id == ignored || consider(id); });
  };
}

}  // namespace

template <class Real>
std::optional<Hit<Real>> closest_hit(const ShapeTree<Real>& tree, const Ray<Real>& ray,
                                     const Source& source, Real t_max, ShapeId ignored) {
  return closest_layer(
      tree.table(), ray, source, ignored, [&](const Source& from, ShapeId without) {
        return first_after<Real>(nullptr, t_max, hits_of(tree, ray, from, Real(0), t_max, without));
      });
}

template <class Real>
std::optional<Hit<Real>> next_hit(const ShapeTree<Real>& tree, const Ray<Real>& ray,
                                  const Source& source, const Hit<Real>& previous, Real t_max,
                                  ShapeId ignored) {
  return next_layer(tree.table(), ray, source, previous, ignored,
                    [&](const Source& from, const Hit<Real>* last, ShapeId without) {
                      const Real start = last != nullptr ? last->t : Real(0);
                      return first_after(last, t_max,
                                         hits_of(tree, ray, from, start, t_max, without));
                    });
}

template <class Real>
bool any_hit(const ShapeTree<Real>& tree, const Ray<Real>& ray, const Source& source, Real t_max,
             ShapeId ignored) {
  return any_layer(tree.table(), ray, source, ignored, [&](const Source& from, ShapeId without) {
    return any_of<Real>(t_max, hits_of(tree, ray, from, Real(0), t_max, without));
  });
}

template std::optional<Hit<float>> closest_hit(const ShapeTree<float>&, const Ray<float>&,
                                               const Source&, float, ShapeId);
template std::optional<Hit<float>> next_hit(const ShapeTree<float>&, const Ray<float>&,
                                            const Source&, const Hit<float>&, float, ShapeId);
template bool any_hit(const ShapeTree<float>&, const Ray<float>&, const Source&, float, ShapeId);
template std::optional<Hit<double>> closest_hit(const ShapeTree<double>&, const Ray<double>&,
                                                const Source&, double, ShapeId);
template std::optional<Hit<double>> next_hit(const ShapeTree<double>&, const Ray<double>&,
                                             const Source&, const Hit<double>&, double, ShapeId);
template bool any_hit(const ShapeTree<double>&, const Ray<double>&, const Source&, double, ShapeId);
#if ALHAZEN_HAS_QUAD
template std::optional<Hit<Quad>> closest_hit(const ShapeTree<Quad>&, const Ray<Quad>&,
                                              const Source&, Quad, ShapeId);
template std::optional<Hit<Quad>> next_hit(const ShapeTree<Quad>&, const Ray<Quad>&, const Source&,
                                           const Hit<Quad>&, Quad, ShapeId);
template bool any_hit(const ShapeTree<Quad>&, const Ray<Quad>&, const Source&, Quad, ShapeId);
#endif

}  // namespace alhazen::render

#include "render/accel/closest_hit.h"

#include "render/accel/shape_hits.h"
#include "render/accel/twin_hits.h"

namespace alhazen::render {
namespace {

// Calls `visit` with every hit up to t_max until it returns false.
template <class Real, class Visitor>
void for_all_shapes(const ShapeTable<Real>& table, const Ray<Real>& ray, const Source& source,
                    Real t_max, ShapeId ignored, const Visitor& visit) {
  for (ShapeId id = 0; id < table.size(); ++id) {
    if (id == ignored || table.twins().is_hidden(id)) continue;
    if (!for_each_hit(table, ray, source, t_max, id, visit)) return;
  }
}

// Of shapes that stand in for others, and those without a twin.
template <class Real>
std::optional<Hit<Real>> first_of(const ShapeTable<Real>& table, const Ray<Real>& ray,
                                  const Source& source, Real t_max, ShapeId ignored,
                                  const Hit<Real>* previous) {
  std::optional<Hit<Real>> best;
  for_all_shapes(table, ray, source, t_max, ignored, [&](const Hit<Real>& hit) {
    const bool late = previous == nullptr || precedes(*previous, hit);
    if (late && (!best || precedes(hit, *best))) best = hit;
    return true;
  });
  return best;
}

}  // namespace

template <class Real>
std::optional<Hit<Real>> closest_hit(const ShapeTable<Real>& table, const Ray<Real>& ray,
                                     const Source& source, Real t_max, ShapeId ignored) {
  return closest_layer(table, ray, source, ignored, [&](const Source& from, ShapeId without) {
    return first_of<Real>(table, ray, from, t_max, without, nullptr);
  });
}

template <class Real>
std::optional<Hit<Real>> next_hit(const ShapeTable<Real>& table, const Ray<Real>& ray,
                                  const Source& source, const Hit<Real>& previous, Real t_max,
                                  ShapeId ignored) {
  return next_layer(table, ray, source, previous, ignored,
                    [&](const Source& from, const Hit<Real>* last, ShapeId without) {
                      return first_of(table, ray, from, t_max, without, last);
                    });
}

template <class Real>
bool any_hit(const ShapeTable<Real>& table, const Ray<Real>& ray, const Source& source, Real t_max,
             ShapeId ignored) {
  return any_layer(table, ray, source, ignored, [&](const Source& from, ShapeId without) {
    bool found = false;
    for_all_shapes(table, ray, from, t_max, without, [&found](const Hit<Real>&) {
      found = true;
      return false;
    });
    return found;
  });
}

template std::optional<Hit<float>> closest_hit(const ShapeTable<float>&, const Ray<float>&,
                                               const Source&, float, ShapeId);
template std::optional<Hit<double>> closest_hit(const ShapeTable<double>&, const Ray<double>&,
                                                const Source&, double, ShapeId);
template std::optional<Hit<float>> next_hit(const ShapeTable<float>&, const Ray<float>&,
                                            const Source&, const Hit<float>&, float, ShapeId);
template std::optional<Hit<double>> next_hit(const ShapeTable<double>&, const Ray<double>&,
                                             const Source&, const Hit<double>&, double, ShapeId);
template bool any_hit(const ShapeTable<float>&, const Ray<float>&, const Source&, float, ShapeId);
template bool any_hit(const ShapeTable<double>&, const Ray<double>&, const Source&, double,
                      ShapeId);
#if ALHAZEN_HAS_QUAD
template std::optional<Hit<Quad>> closest_hit(const ShapeTable<Quad>&, const Ray<Quad>&,
                                              const Source&, Quad, ShapeId);
template std::optional<Hit<Quad>> next_hit(const ShapeTable<Quad>&, const Ray<Quad>&, const Source&,
                                           const Hit<Quad>&, Quad, ShapeId);
template bool any_hit(const ShapeTable<Quad>&, const Ray<Quad>&, const Source&, Quad, ShapeId);
#endif

}  // namespace alhazen::render

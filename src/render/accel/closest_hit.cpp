#include "render/accel/closest_hit.h"

namespace alhazen::render {
namespace {

// Calls `visit` with every hit up to t_max until it returns false.
template <class Real, class Visitor>
void for_each_hit(const ShapeTable<Real>& table, const Ray<Real>& ray, const Source& source,
                  Real t_max, const Visitor& visit) {
  for (ShapeId id = 0; id < table.size(); ++id) {
    const Departure from = id == source.shape ? Departure{source.face, source.side} : Departure();
    for (const Crossing<Real>& c : table.crossings(id, ray, from)) {
      if (c.t <= t_max && !visit(Hit<Real>{c.t, id, c.face, c.enters})) return;
    }
  }
}

}  // namespace

template <class Real>
std::optional<Hit<Real>> closest_hit(const ShapeTable<Real>& table, const Ray<Real>& ray,
                                     const Source& source, Real t_max) {
  std::optional<Hit<Real>> best;
  for_each_hit(table, ray, source, t_max, [&best](const Hit<Real>& hit) {
    if (!best || precedes(hit, *best)) best = hit;
    return true;
  });
  return best;
}

template <class Real>
std::optional<Hit<Real>> next_hit(const ShapeTable<Real>& table, const Ray<Real>& ray,
                                  const Source& source, const Hit<Real>& previous, Real t_max) {
  std::optional<Hit<Real>> best;
  for_each_hit(table, ray, source, t_max, [&](const Hit<Real>& hit) {
    if (precedes(previous, hit) && (!best || precedes(hit, *best))) best = hit;
    return true;
  });
  return best;
}

template <class Real>
bool any_hit(const ShapeTable<Real>& table, const Ray<Real>& ray, const Source& source,
             Real t_max) {
  bool found = false;
  for_each_hit(table, ray, source, t_max, [&found](const Hit<Real>&) {
    found = true;
    return false;
  });
  return found;
}

template std::optional<Hit<float>> closest_hit(const ShapeTable<float>&, const Ray<float>&,
                                               const Source&, float);
template std::optional<Hit<double>> closest_hit(const ShapeTable<double>&, const Ray<double>&,
                                                const Source&, double);
template std::optional<Hit<float>> next_hit(const ShapeTable<float>&, const Ray<float>&,
                                            const Source&, const Hit<float>&, float);
template std::optional<Hit<double>> next_hit(const ShapeTable<double>&, const Ray<double>&,
                                             const Source&, const Hit<double>&, double);
template bool any_hit(const ShapeTable<float>&, const Ray<float>&, const Source&, float);
template bool any_hit(const ShapeTable<double>&, const Ray<double>&, const Source&, double);
#if ALHAZEN_HAS_QUAD
template std::optional<Hit<Quad>> closest_hit(const ShapeTable<Quad>&, const Ray<Quad>&,
                                              const Source&, Quad);
template std::optional<Hit<Quad>> next_hit(const ShapeTable<Quad>&, const Ray<Quad>&, const Source&,
                                           const Hit<Quad>&, Quad);
template bool any_hit(const ShapeTable<Quad>&, const Ray<Quad>&, const Source&, Quad);
#endif

}  // namespace alhazen::render

#include "render/accel/closest_hit.h"

#include "render/accel/shape_hits.h"
#include "render/accel/twin_hits.h"

namespace alhazen::render {
namespace {

// For shape_hits.h: every hit up to t_max of shapes that stand in for others, and of those without
// a twin.
template <class Shapes, class Real>
auto all_hits(const Shapes& shapes, const Ray<Real>& ray, const Source& source, Real t_max,
              ShapeId ignored) {
  return [&shapes, &ray, &source, t_max, ignored](const Real&, const auto& take) {
    for (ShapeId id = 0; id < shapes.size(); ++id) {
      if (id == ignored || shapes.twins().is_hidden(id)) continue;
      if (!for_each_hit(shapes, ray, source, t_max, id, take)) return;
    }
  };
}

}  // namespace

template <class Shapes, class Real>
std::optional<Hit<Real>> closest_hit(const Shapes& shapes, const Ray<Real>& ray,
                                     const Source& source, Real t_max, ShapeId ignored) {
  return closest_layer(shapes, ray, source, ignored, [&](const Source& from, ShapeId without) {
    return first_after<Real>(nullptr, t_max, all_hits(shapes, ray, from, t_max, without));
  });
}

template <class Shapes, class Real>
std::optional<Hit<Real>> next_hit(const Shapes& shapes, const Ray<Real>& ray, const Source& source,
                                  const Hit<Real>& previous, Real t_max, ShapeId ignored) {
  return next_layer(shapes, ray, source, previous, ignored,
                    [&](const Source& from, const Hit<Real>* last, ShapeId without) {
                      return first_after(last, t_max, all_hits(shapes, ray, from, t_max, without));
                    });
}

template <class Shapes, class Real>
bool any_hit(const Shapes& shapes, const Ray<Real>& ray, const Source& source, Real t_max,
             ShapeId ignored) {
  return any_layer(shapes, ray, source, ignored, [&](const Source& from, ShapeId without) {
    return any_of<Real>(t_max, all_hits(shapes, ray, from, t_max, without));
  });
}

template std::optional<Hit<float>> closest_hit(const ShapeTable<float>&, const Ray<float>&,
                                               const Source&, float, ShapeId);
template std::optional<Hit<float>> next_hit(const ShapeTable<float>&, const Ray<float>&,
                                            const Source&, const Hit<float>&, float, ShapeId);
template bool any_hit(const ShapeTable<float>&, const Ray<float>&, const Source&, float, ShapeId);
template std::optional<Hit<double>> closest_hit(const ShapeTable<double>&, const Ray<double>&,
                                                const Source&, double, ShapeId);
template std::optional<Hit<double>> next_hit(const ShapeTable<double>&, const Ray<double>&,
                                             const Source&, const Hit<double>&, double, ShapeId);
template bool any_hit(const ShapeTable<double>&, const Ray<double>&, const Source&, double,
                      ShapeId);
#if ALHAZEN_HAS_QUAD
template std::optional<Hit<Quad>> closest_hit(const ShapeTable<Quad>&, const Ray<Quad>&,
                                              const Source&, Quad, ShapeId);
template std::optional<Hit<Quad>> next_hit(const ShapeTable<Quad>&, const Ray<Quad>&, const Source&,
                                           const Hit<Quad>&, Quad, ShapeId);
template bool any_hit(const ShapeTable<Quad>&, const Ray<Quad>&, const Source&, Quad, ShapeId);
#endif
template std::optional<Hit<float>> closest_hit(const WorldShapes<float>&, const Ray<float>&,
                                               const Source&, float, ShapeId);
template std::optional<Hit<float>> next_hit(const WorldShapes<float>&, const Ray<float>&,
                                            const Source&, const Hit<float>&, float, ShapeId);
template bool any_hit(const WorldShapes<float>&, const Ray<float>&, const Source&, float, ShapeId);
template std::optional<Hit<double>> closest_hit(const WorldShapes<double>&, const Ray<double>&,
                                                const Source&, double, ShapeId);
template std::optional<Hit<double>> next_hit(const WorldShapes<double>&, const Ray<double>&,
                                             const Source&, const Hit<double>&, double, ShapeId);
template bool any_hit(const WorldShapes<double>&, const Ray<double>&, const Source&, double,
                      ShapeId);
#if ALHAZEN_HAS_QUAD
template std::optional<Hit<Quad>> closest_hit(const WorldShapes<Quad>&, const Ray<Quad>&,
                                              const Source&, Quad, ShapeId);
template std::optional<Hit<Quad>> next_hit(const WorldShapes<Quad>&, const Ray<Quad>&,
                                           const Source&, const Hit<Quad>&, Quad, ShapeId);
template bool any_hit(const WorldShapes<Quad>&, const Ray<Quad>&, const Source&, Quad, ShapeId);
#endif

}  // namespace alhazen::render

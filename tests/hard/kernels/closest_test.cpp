// A15: the nearest hit against a plain loop over all shapes, whatever closest_hit is made of.
#include <cmath>
#include <gtest/gtest.h>

#include "hard/kernels/zoo.h"
#include "render/accel/closest_hit.h"

namespace alhazen::hard {
namespace {

using render::Hit;
using render::Source;

// Sizes from 10^-9 to 10^9, boxes that are almost flat, and everything of which there can be two:
// the same shape again, a box beside a box, a disc in the plane of another.
std::vector<Shape> crowd(Dice& dice) {
  std::vector<Shape> shapes;
  for (int i = 0; i < 12; ++i) {
    const double size = std::pow(10.0, dice.uniform(-9, 9));
    for (const Geometry& geometry : every_kind(dice, size)) {
      if (dice.below(3) == 0) shapes.push_back(shape_of(geometry));
    }
  }
  for (int i = 0; i < 6; ++i) {
    const Vec3d a = dice.in_cube(2);
    Vec3d size{dice.uniform(0.2, 2), dice.uniform(0.2, 2), dice.uniform(0.2, 2)};
    size[i % 3] = std::abs(a[i % 3]) * 0x1p-50;
    shapes.push_back(shape_of(alhazen::Box{a, a + size}));
    const Vec3d b{std::floor(a.x), std::floor(a.y), std::floor(a.z)};
    shapes.push_back(shape_of(alhazen::Box{b, b + Vec3d{1, 1, 1}}));
    shapes.push_back(shape_of(alhazen::Box{b + Vec3d{1, 0, 0}, b + Vec3d{2, 1, 1}}));
    shapes.push_back(shape_of(alhazen::Disc{b, {0, 1, 0}, 1, 0}));
    shapes.push_back(shape_of(alhazen::Plane{{0, 1, 0}, b.y}));
    shapes.push_back(shape_of(alhazen::Sphere{b, 0.5}, rotation({1, 1, 0}, 30)));
  }
  for (int i = 0; i < 5; ++i)
    shapes.push_back(shapes[static_cast<std::size_t>(dice.below(static_cast<int>(shapes.size())))]);
  return shapes;
}

// Of all crossings the first by t, then entering before leaving, then by shape and face. Of shapes
// that are one surface the first stands in for all, and the outermost is met by what enters, the
// innermost by what leaves.
template <class Real>
std::optional<Hit<Real>> first_of_all(const ShapeTable<Real>& table, const Ray<Real>& ray,
                                      const Source& source) {
  std::optional<Hit<Real>> best;
  const auto& twins = table.twins();
  for (ShapeId id = 0; id < table.size(); ++id) {
    if (twins.is_hidden(id)) continue;
    const Departure from = id == source.shape ? Departure{source.face, source.side} : Departure();
    for (const Crossing<Real>& c : table.crossings(id, ray, from)) {
      const auto order = [](const Hit<Real>& h) {
        return std::tuple(h.t, !h.enters, h.shape, h.face);
      };
      const Hit<Real> hit{c.t, id, c.face, c.enters};
      if (!best || order(hit) < order(*best)) best = hit;
    }
  }
  if (best) best->shape = twins.first(best->shape, best->enters);
  return best;
}

template <class Real>
bool same_hit(const std::optional<Hit<Real>>& a, const std::optional<Hit<Real>>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->t == b->t && a->shape == b->shape && a->face == b->face && a->enters == b->enters;
}

template <class Real>
void nearest() {
  double different = 0;
  std::size_t met = 0, met_again = 0, ties = 0;
  Dice dice(150);
  for (int scene = 0; scene < 20; ++scene) {
    const std::vector<Shape> shapes = crowd(dice);
    const ShapeTable<Real> table(shapes, Vec3d{});
    for (std::size_t i = 0; i < rays(500); ++i) {
      // From and to a place of its own size each, or along a lattice, where ties are.
      const Vec3d from = dice.in_cube(std::pow(10.0, dice.uniform(-9, 9)));
      const Vec3d to = dice.in_cube(std::pow(10.0, dice.uniform(-9, 9)));
      const Vec3d cell{double(dice.below(9) - 4), double(dice.below(9) - 4),
                       double(dice.below(9) - 4)};
      const Vec3d step{double(dice.below(3) - 1), double(dice.below(3) - 1), 1};
      const Ray<Real> ray =
          i % 2 == 0 ? ray_of<Real>(from, normalized(to - from)) : ray_of<Real>(cell, step);
      const auto hit = closest_hit(table, ray, Source(), infinity<Real>());
      const auto truth = first_of_all(table, ray, Source());
      if (!same_hit(hit, truth)) ++different;
      if (!truth) continue;
      ++met;
      if (table.twins().has_twin(truth->shape)) continue;  // on to its next layer: Twins.*
      // Onward from there, with nothing known of how the ray came: every face at t = 0 is met.
      Source source{truth->shape, truth->face, Side::kByDirection};
      const auto point = table.plain_surface(truth->shape, ray, truth->crossing());
      const Ray<Real> onward{point.position, ray.direction};
      const auto again = closest_hit(table, onward, source, infinity<Real>());
      const auto true_again = first_of_all(table, onward, source);
      if (!same_hit(again, true_again)) ++different;
      if (true_again) ++met_again;
      if (true_again && true_again->t == Real(0)) ++ties;
    }
  }
  EXPECT_GT(met, rays(2000));
  EXPECT_GT(met_again, rays(500));
  EXPECT_GT(ties, rays(20));
  figure_in<Real>("A15", "nearest hits that are not those of a loop over all shapes", different, 0);
}

TEST(Hard, A15_ClosestHit) {
  nearest<double>();
  nearest<float>();
}

}  // namespace
}  // namespace alhazen::hard

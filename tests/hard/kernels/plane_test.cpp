// A8: planes seen at angles down to 2^-50, where POV-Ray ends the world at 1e7.
#include "render/shape/plane.h"

#include <cmath>
#include <gtest/gtest.h>

#include "hard/kernels/support.h"

namespace alhazen::hard {
namespace {

#if ALHAZEN_HAS_QUAD
using render::Plane;

// Along the axes nothing is rounded but the quotient: t = h / sin a to half an ulp.
template <class Real>
double worst_closed_form() {
  double worst = 0;
  for (const double height : {2.0, 0x1.99p-4, 0x1.e84p19}) {
    for (int k = 0; k <= 50; ++k) {
      const Plane<Real> plane{{Real(0), Real(1), Real(0)}, Real(1)};
      const Vec3d eye{0, height + 1, 0}, d{1, -std::ldexp(1.0, -k), 0};
      const auto hits = crossings(plane, ray_of<Real>(eye, d), Departure());
      if (hits.size() != 1) return infinity<double>();
      const Quad h = static_cast<Quad>(static_cast<Real>(eye.y)) - 1;
      worst = larger(worst, relative_error(hits[0].t, h * static_cast<Quad>(std::ldexp(1.0, k))));
    }
  }
  return worst;
}

// Slanted planes, from an eye at the origin and from one at `eye_distance` in the plane's own
// directions: dot products of the normal whose terms cancel to 2^-k of their size.
template <class Real>
void slanted(double eye_distance, int lowest) {
  double worst = 0, missed = 0;
  Dice dice(80);
  for (std::size_t i = 0; i < rays(20000); ++i) {
    const Vec3d n = dice.direction();
    const double drop = std::ldexp(dice.uniform(0.5, 1), -dice.below(lowest + 1));
    const Vec3d along = aside_of(n, dice), eye = eye_distance * aside_of(n, dice);
    Plane<Real> plane{};
    plane.normal = Vec3<Real>(n);
    plane.offset = Real(-2);
    const Ray<Real> ray = ray_of<Real>(eye, along - drop * n);
    const Vec3<Quad> exact_n(plane.normal);
    const Quad height = static_cast<Quad>(plane.offset) - dot(exact_n, Vec3<Quad>(ray.origin));
    const Quad truth = height / dot(exact_n, Vec3<Quad>(ray.direction));
    const auto hits = crossings(plane, ray, Departure());
    if ((truth >= Quad(0)) != (hits.size() == 1)) {
      ++missed;
    } else if (hits.size() == 1) {
      worst = larger(worst, relative_error(hits[0].t, truth));
    }
  }
  const std::string where = eye_distance > 0 ? " from an eye far along" : " from the origin";
  figure_in<Real>("A8", "slanted planes wrongly met or missed" + where, missed, 0);
  // Two dot products and a difference to one rounding each, or 2 where the terms do not cancel, and
  // the quotient.
  figure_in<Real>("A8", "relative error of t on slanted planes" + where, worst, 4, "eps");
}

TEST(Hard, A8_GrazedPlane) {
  figure_in<double>("A8", "relative error of h / sin a", worst_closed_form<double>(), 1, "eps");
  figure_in<float>("A8", "relative error of h / sin a", worst_closed_form<float>(), 1, "eps");
  slanted<double>(0, 50);
  slanted<float>(0, 22);
  slanted<double>(1e8, 50);
  slanted<float>(1e4, 22);
}
#endif

}  // namespace
}  // namespace alhazen::hard

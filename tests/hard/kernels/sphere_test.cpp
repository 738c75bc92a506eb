// A1 to A3: rays that graze spheres, spheres far away, and the sphere one stands on. Origins or
// centres are 0, as the renderer's rays of the camera have them, so that nothing is rounded before
// the kernel begins; A3 moves both as well.
#include "render/shape/sphere.h"

#include <cmath>
#include <gtest/gtest.h>

#include "hard/kernels/support.h"

namespace alhazen::hard {
namespace {

#if ALHAZEN_HAS_QUAD
using render::Sphere;

// Two words give t to 4 eps: c and b to half a rounding each, the root to one, and the sum and the
// quotient made of them. The bound of the catalogue.
constexpr double kBound = 4;

template <class Real>
Sphere<Quad> oracle_of(const Sphere<Real>& sphere) {
  return {Vec3<Quad>(sphere.center), static_cast<Quad>(sphere.radius)};
}

// Whether the oracle's count is the same for spheres that are larger and smaller by 4 roundings of
// the numbers that are in play: of the radius alone where nothing is rounded before the kernel.
template <class Real>
bool is_decided(const Sphere<Real>& sphere, const Ray<Real>& ray, Quad size) {
  const Quad rounding = static_cast<Quad>(4 * kEps<Real>) * size;
  Sphere<Quad> smaller = oracle_of(sphere), larger = smaller;
  smaller.radius -= rounding;
  larger.radius += rounding;
  return crossings(smaller, exact(ray), Departure()).size() ==
         crossings(larger, exact(ray), Departure()).size();
}

template <class Real>
void compare(Verdict<Real>& verdict, const Sphere<Real>& sphere, const Ray<Real>& ray) {
  const Real extent = length(sphere.center) + sphere.radius + length(ray.origin);
  const bool is_exact = sphere.center == Vec3<Real>() || ray.origin == Vec3<Real>();
  const Quad size = static_cast<Quad>(is_exact ? sphere.radius : extent);
  verdict.compare(
      sphere, oracle_of(sphere), ray, [&] { return is_decided(sphere, ray, size); },
      static_cast<double>(extent));
}

template <class Real>
void graze(int closest) {
  Verdict<Real> verdict;
  Dice dice(1);
  for (std::size_t i = 0; i < rays(10000); ++i) {
    const double away = std::ldexp(1.0, -(4 + dice.below(closest - 3)));
    const double impact = 1 + (i % 2 == 0 ? away : -away);
    const Vec3d d = dice.direction();
    const double radius = dice.uniform(0.5, 2);
    const Vec3d origin = radius * impact * aside_of(d, dice) - dice.uniform(0.1, 10) * d;
    compare(verdict, Sphere<Real>{{}, static_cast<Real>(radius)}, ray_of<Real>(origin, d));
  }
  figure_in<Real>("A1", "grazing rays decided wrongly", static_cast<double>(verdict.miscounted), 0);
  figure_in<Real>("A1", "relative error of t", verdict.worst, kBound, "eps");
}

TEST(Hard, A1_SphereGraze) {
  graze<double>(46);
  graze<float>(20);
}

template <class Real>
void far_away(double distance) {
  Verdict<Real> verdict;
  Dice dice(2);
  for (std::size_t i = 0; i < rays(2000); ++i) {
    const Vec3d d = dice.direction();
    const Vec3d center = distance * d + dice.uniform(0, 1.1) * aside_of(d, dice);
    compare(verdict, Sphere<Real>{Vec3<Real>(center), Real(1)}, ray_of<Real>({}, d));
  }
  const std::string where = " at D/R = " + std::to_string(static_cast<long>(distance));
  figure_in<Real>("A2", "rays decided wrongly" + where, static_cast<double>(verdict.miscounted), 0);
  figure_in<Real>("A2", "relative error of t" + where, verdict.worst, kBound, "eps");
}

// A picture of 200 x 200 pixels around the unit sphere, whose rays set out from the eye, or, for an
// eye at infinity, side by side: cosines of a light with the normal; -1 for a miss.
template <class Real>
std::vector<double> picture(Real distance, bool orthographic) {
  std::vector<double> pixels;
  for (int i = 0; i < 200; ++i) {
    for (int j = 0; j < 200; ++j) {
      const Vec3<Real> aim{Real(2 * i - 199) / Real(180), Real(2 * j - 199) / Real(180), Real(0)};
      const Sphere<Real> sphere{{Real(0), Real(0), orthographic ? Real(4) : distance}, Real(1)};
      const Ray<Real> ray = orthographic ? Ray<Real>{aim, {Real(0), Real(0), Real(1)}}
                                         : Ray<Real>{{}, {aim.x, aim.y, distance}};
      const auto hits = crossings(sphere, ray, Departure());
      if (hits.size() == 0) {
        pixels.push_back(-1);
        continue;
      }
      const Vec3<Real> n = render::surface(sphere, ray, hits[0]).normal;
      pixels.push_back(larger(0.0, -dot(Vec3d(n), {0.48, 0.6, 0.64})));
    }
  }
  return pixels;
}

template <class Real>
void orthographic_limit(double distance) {
  const auto eye = picture(static_cast<Real>(distance), false),
             limit = picture<Real>(Real(1), true);
  double bad = 0;
  for (std::size_t i = 0; i < eye.size(); ++i)
    bad += std::abs(eye[i] - limit[i]) > 1.0 / 255 ? 1 : 0;
  figure_in<Real>("A2",
                  "pixels that differ from the view from infinity at D/R = " +
                      std::to_string(static_cast<long>(distance)),
                  bad, 0, "px", distance > 1e4 ? "a rounding of t is more than R / 100" : "");
}

TEST(Hard, A2_SmallFarSphere) {
  for (const double distance : {1e3, 1e6, 1e9}) {
    far_away<double>(distance);
    far_away<float>(distance);
  }
  for (const double distance : {1e4, 1e6, 1e9}) {
    orthographic_limit<double>(distance);
    orthographic_limit<float>(distance);
  }
}

template <class Real>
void on_the_ground(double radius, bool moved) {
  Verdict<Real> verdict;
  Dice dice(3);
  for (std::size_t i = 0; i < rays(2000); ++i) {
    const Vec3d up = i % 2 == 0 ? Vec3d{0, 1, 0} : dice.direction();
    // From straight down to the horizon.
    const double drop = std::ldexp(1.0, -dice.below(20)) * dice.uniform(0.5, 1);
    const Vec3d d = std::sqrt(1 - drop * drop) * aside_of(up, dice) - drop * up;
    const Vec3d eye = moved ? radius * dice.direction() : Vec3d{};
    const Vec3d center = eye - (radius + 2) * up;
    compare(verdict, Sphere<Real>{Vec3<Real>(center), static_cast<Real>(radius)},
            ray_of<Real>(eye, d));
  }
  std::string where = " on R = " + std::to_string(static_cast<long>(radius));
  if (moved) where += " away from 0";
  figure_in<Real>("A3", "rays decided wrongly" + where, static_cast<double>(verdict.miscounted), 0);
  if (moved) {
    figure_in<Real>("A3", "error of t over its condition" + where, verdict.worst_conditioned,
                    kBound, "eps");
  } else {
    figure_in<Real>("A3", "relative error of t" + where, verdict.worst, kBound, "eps",
                    radius > 1e6 ? "two words have 48 bits, c is below 2^-32 of its terms" : "");
  }
}

// Against the plane that the sphere is in the limit: the ground falls away by s^2 / 2R over a
// distance s, which the ray travels in s^2 / (2R sin a), or for an angle a that does not change
// over that distance, in no more than twice of it.
TEST(Hard, A3_GroundSphere) {
  for (const double radius : {1e6, 1e10, 1e12}) {
    on_the_ground<double>(radius, false);
    on_the_ground<float>(radius, false);
    on_the_ground<double>(radius, true);
    on_the_ground<float>(radius, true);
  }
  double worst = 0;
  const double radius = 1e12;
  Dice dice(4);
  for (std::size_t i = 0; i < rays(1000); ++i) {
    const double sine = dice.uniform(0.01, 1), flat = 2 / sine;
    const Ray<double> ray{{0, 2, 0}, {std::sqrt(1 - sine * sine), -sine, 0}};
    const auto hits = crossings(Sphere<double>{{0, -radius, 0}, radius}, ray, Departure());
    ASSERT_EQ(hits.size(), 2);
    worst = larger(worst, std::abs(hits[0].t - flat) / (flat * flat / (2 * radius * sine)));
  }
  figure("A3", "double", "distance from the plane of R = 1e12 over s^2 / (2 R sin a)", worst, 2);
}
#endif

}  // namespace
}  // namespace alhazen::hard

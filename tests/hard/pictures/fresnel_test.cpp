// tests/hard/pictures: C2 and C3, how much glass reflects, as kernels and as pictures.
#include "render/surface/fresnel.h"

#include <random>

#include "core/math/elementary.h"
#include "hard/pictures/support.h"

namespace alhazen::hard {
namespace {

using render::dielectric_interface;
using render::interface_from_cosines;

template <class Real>
constexpr Precision kPrecisionOf = sizeof(Real) == sizeof(float) ? Precision::float32
                                                                 : Precision::float64;

// Glass fills the space below y = 0, down to a floor that is black; above is a sky of 1. What the
// camera sees along `forward` from above is F, from within T.
double seen_at_interface(Precision p, double ior, Vec3d position, Vec3d forward) {
  SceneBuilder b;
  b.background(1);
  b.add(Plane{{0, 1, 0}, 0}, b.glass(ior));
  b.add(Plane{{0, 1, 0}, -2}, b.material(Black{}));
  return seen(b, position, forward, {-forward.y, forward.x, 0}, p);
}

template <class Real>
void published_values() {
  struct Published {
    double cosine, reflectance;
  };
  const Published table[] = {{1, 0.04},
                             {1 / std::sqrt(3.25), 0.073964497041420125},  // Brewster's angle
                             {0.5, 0.089186712802212783},
                             {cos_deg(80), 0.38770435469147268},
                             {cos_deg(89.999), 0.99989853636319713},
                             {0, 1}};
  const Precision p = kPrecisionOf<Real>;
  double kernel = 0, picture = 0;
  for (const auto& [cosine, reflectance] : table) {
    const Real value =
        dielectric_interface(static_cast<Real>(cosine), Real(1) / Real(1.5)).reflectance;
    kernel = std::max(kernel, std::abs(static_cast<double>(value) - reflectance));
    if (cosine == 0) continue;  // the camera would look along the surface
    const Vec3d down(std::sqrt((1 - cosine) * (1 + cosine)), -cosine, 0);
    const double in_picture = seen_at_interface(p, 1.5, {0, 1, 0}, down);
    picture = std::max(picture, std::abs(in_picture - reflectance));
  }
  figure("C2", name_of(p), "published values of F, n = 1.5", kernel / eps_of(p), 4, "eps");
  // The cosine of the ray in a picture has two roundings of its own, and |dF/dcos| < 6.
  figure("C2", name_of(p), "the same seen in pictures", picture / eps_of(p), 12, "eps");
}

template <class Real>
void identities() {
  const Precision p = kPrecisionOf<Real>;
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  double energy = 0, both_sides = 0;
  for (std::size_t i = 0; i < rays(200000); ++i) {
    // Indices of which the reciprocal is exact: what is left is the function's own rounding.
    const Real eta = static_cast<Real>(std::exp2(static_cast<double>(i % 5) - 2));
    const Real cosine = static_cast<Real>(unit(random));
    const auto there = dielectric_interface(cosine, eta);
    const Real sum = there.reflectance + there.transmittance;
    energy = std::max(energy, std::abs(static_cast<double>(sum) - 1));
    if (there.total_reflection) continue;
    const auto back = interface_from_cosines(there.cos_transmitted, cosine, 1 / eta);
    both_sides =
        std::max(both_sides, std::abs(static_cast<double>(there.reflectance - back.reflectance)));
  }
  figure("C2", name_of(p), "F + T - 1", energy / eps_of(p), 2, "eps");
  figure("C2", name_of(p), "F(n1, n2, i) - F(n2, n1, t)", both_sides / eps_of(p), 4, "eps");
}

TEST(Hard, C2_FresnelValues) {
  published_values<double>();
  published_values<float>();
  identities<double>();
  identities<float>();
}

#if ALHAZEN_HAS_QUAD
// From within glass onto its face, sin i = (1 -+ 2^-k) / n: the picture shows T. At k = `smooth`
// 2^-k is far above the rounding of sin i, and small.
template <class Real>
void total_reflection(int finest, int smooth) {
  const Precision p = kPrecisionOf<Real>;
  const double n = 1.5;
  int flips = 0, picture_flips = 0;
  double kernel = 0, step = 0, picture = 0;
  for (int k = 2; k <= finest; ++k) {
    double transmitted[2];
    for (const int outside : {0, 1}) {
      const double sine = (1 + (outside ? 1 : -1) * std::exp2(-k)) / n;
      const double cosine = std::sqrt((1 - sine) * (1 + sine));
      const Real given = static_cast<Real>(cosine);
      const auto value = dielectric_interface(given, Real(n));
      const auto oracle = dielectric_interface<Quad>(given, n);
      flips += value.total_reflection != oracle.total_reflection;
      const double error = static_cast<double>(absolute(value.reflectance - oracle.reflectance));
      kernel = error <= kernel ? kernel : error;
      const Vec3d up(sine, cosine, 0);
      const double seen_value = seen_at_interface(p, n, {0, -1, 0}, up);
      const double seen_in_quad = seen_at_interface(Precision::quad, n, {0, -1, 0}, up);
      // 1 - n^2 sin^2 is 2^(1-k), far above the rounding of the direction.
      picture_flips += (seen_value > 0) != (seen_in_quad > 0);
      // T goes with the root of 2^-k, and so its error with one over it.
      const double seen_error = std::abs(seen_value - seen_in_quad) * std::exp2(-k / 2.0);
      picture = seen_error <= picture ? picture : seen_error;
      transmitted[outside] = seen_value;
    }
    EXPECT_EQ(transmitted[1], 0) << k;
    if (k == smooth) step = transmitted[0] * std::exp2(k / 2.0);
  }
  figure("C3", name_of(p), "decisions unlike those of the oracle", flips, 0);
  figure("C3", name_of(p), "F near the critical angle", kernel / eps_of(p), 4, "eps");
  figure("C3", name_of(p), "pictures: decisions unlike those in quad", picture_flips, 0);
  // T = 4 a b / (a + b)^2 of a = n cos i or cos i / n, b = cos t = sqrt(2^(1-k)): to first order
  // 2 b (1/(n c) + n/c), at c = cos of the critical angle.
  const double c = std::sqrt(1 - 1 / (n * n));
  const double slope = 2 * std::sqrt(2.0) * (1 / (n * c) + n / c);
  figure("C3", name_of(p), "pictures: T / sqrt(2^-k) against its limit", std::abs(step / slope - 1),
         8 * std::exp2(-smooth / 2.0));
  // cos^2 t is known to 4 eps, so T to slope * 4 eps / sqrt(2^(1-k)) / 2.
  figure("C3", name_of(p), "pictures: |T - T in quad| sqrt(2^-k)", picture / eps_of(p), 32, "eps");
}

TEST(Hard, C3_TotalReflection) {
  total_reflection<double>(46, 30);
  total_reflection<float>(18, 12);
  EXPECT_FALSE(dielectric_interface(cos_deg(41.810314895778), 1.5).total_reflection);
  EXPECT_TRUE(dielectric_interface(cos_deg(41.810314895779), 1.5).total_reflection);
}
#else
TEST(Hard, C3_TotalReflection) {
  GTEST_SKIP() << "C3: this build has no __float128";
}
#endif

}  // namespace
}  // namespace alhazen::hard

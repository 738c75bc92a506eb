// tests: the sphere light against the closed form of its irradiance, on every scale.
#include "render/light/sphere_light.h"

#include <random>

#include "core/math/random.h"
#include "unit/render/measured.h"

namespace alhazen::render {
namespace {

using test::Worst;

// (0,2) samples leave an error of about N^-1 to N^-3/2 of a smooth integrand's spread: the bounds
// on irradiances are N^-1 of a part of it, 1e-4, and 10 times that where the horizon cuts.
constexpr int kSamples = 4096;

SphereLightKernel<double> sphere_light(Vec3d center, double radius) {
  return {SphereLight{center, radius, Rgbd(1), kSamples}, Vec3d()};
}

double irradiance(const SphereLightView<double>& view, Vec3d normal, std::uint64_t seed) {
  double sum = 0;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const Sample2d s = sample_2d(seed, i);
    const auto sample = view.sample(unit_real<double>(s.x), unit_real<double>(s.y));
    sum += sample.weight.r * larger(0.0, dot(normal, sample.direction));
  }
  return sum;
}

// L pi (r/d)^2 cos where the whole sphere is above the horizon.
TEST(SphereLight, IrradianceAboveTheHorizon) {
  Worst worst("sphere light: irradiance / closed form - 1, 4096 samples", 1e-4);
  for (const double tilt : {0.0, 20.0, 50.0}) {
    for (const double ratio : {0.6, 0.1, 1e-3, 1e-6, 1e-9, 1e-12}) {
      const Vec3d normal(0, 1, 0), axis(sin_deg(tilt), cos_deg(tilt), 0);
      const SphereLightView<double> view(sphere_light((1 / ratio) * axis, 1), {});
      const double expected = pi<double>() * ratio * ratio * cos_deg(tilt);
      worst.add(std::fabs(irradiance(view, normal, 1) / expected - 1));
    }
  }
}

// Also in pieces, the single weight times the count is the exact solid angle: 2 pi (1 - cos), which
// for a speck is pi (r/d)^2 (1 + (r/d)^2 / 4 + ...).
TEST(SphereLight, SolidAngleOfASpeck) {
  for (const double ratio : {1e-5, 1e-8, 1e-20, 1e-100}) {
    const SphereLightView<double> view(sphere_light({0, 1 / ratio, 0}, 1), {});
    const double solid_angle = view.sample(0.5, 0.5).weight.r * kSamples;
    EXPECT_NEAR(solid_angle / (pi<double>() * ratio * ratio) - 1, ratio * ratio / 4, 1e-15);
  }
}

// From inside the light comes from everywhere: pi. On the surface, from the half facing it: pi.
TEST(SphereLight, FromInsideAndFromItsSurface) {
  const Vec3d up(0, 1, 0);
  for (const double height : {0.0, 0.5, 0.999, 1.0}) {
    const SphereLightView<double> view(sphere_light({0, height, 0}, 1), {});
    EXPECT_NEAR(irradiance(view, up, 2), pi<double>(), 1e-3 * pi<double>()) << height;
  }
}

TEST(SphereLight, SamplesLieOnTheNearSurface) {
  Worst worst("sphere light: distance of samples from the surface / r", 1e-13);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 10000; ++i) {
    const double d = i % 3 == 0 ? unit(random) : 1 + 20 * unit(random) * unit(random);
    const Vec3d center(0.6 * d, -0.8 * d, 0);
    const SphereLightView<double> view(sphere_light(center, 1), {});
    const auto sample = view.sample(unit(random), unit(random));
    const Vec3d hit = sample.distance * sample.direction;
    ASSERT_NEAR(length(sample.direction), 1, 1e-15);
    ASSERT_GE(sample.distance, 0);
    worst.add(std::fabs(length(hit - center) - 1));
    ASSERT_TRUE(d < 1 || dot(hit - center, -center) > -1e-7);  // the half that faces the point
  }
}

// From far away the near surface is at d - r, tiny or huge.
TEST(SphereLight, DistanceOfExtremeSpheres) {
  const SphereLightView<double> near_huge(sphere_light({0, 1e10 + 1, 0}, 1e10), {});
  EXPECT_NEAR(near_huge.sample(0, 0.3).distance, 1, 1e-5);
  const SphereLightView<double> speck(sphere_light({0, 1e10, 0}, 1e-10), {});
  EXPECT_EQ(speck.sample(0.7, 0.3).distance, 1e10);
}

// Lengths times 2^k: the same directions and weights, distances times 2^k, in bits (F1).
TEST(SphereLight, ScalesByPowersOfTwo) {
  const Vec3d center(1, 3, -2), point(0.1, -0.2, 0.3);
  const SphereLightView<double> one(sphere_light(center, 0.7), point);
  for (const int k : {-300, -10, 1, 10, 300}) {
    const double s = std::exp2(k);
    const SphereLightView<double> scaled(sphere_light(s * center, s * 0.7), s * point);
    for (const double u : {0.0, 0.3, 0.9}) {
      const auto a = one.sample(u, 0.7), b = scaled.sample(u, 0.7);
      EXPECT_EQ(a.direction, b.direction);
      EXPECT_EQ(a.weight, b.weight);
      EXPECT_EQ(a.distance * s, b.distance);
    }
  }
}

// The flux through spheres around the light: pi L times its area.
TEST(SphereLight, SendsTheSameFluxThroughEverySphere) {
  for (const double distance : {1.5, 3.0, 100.0}) {
    const SphereLightView<double> view(sphere_light({0, distance, 0}, 1), {});
    const double flux = 4 * pi<double>() * distance * distance * irradiance(view, {0, 1, 0}, 3);
    EXPECT_NEAR(flux / (4 * pi<double>() * pi<double>()), 1, 1e-4) << distance;
  }
}

}  // namespace
}  // namespace alhazen::render

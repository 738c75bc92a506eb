// tests: Snell's law, and rays through slabs and prisms (docs/numerics.md C1, C4).
#include "render/surface/refract.h"

#include <random>

#include "render/surface/absorption.h"
#include "unit/render/measured.h"

namespace alhazen::render {
namespace {

using test::Worst;

Vec3d random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return normalized(Vec3d(normal(random), normal(random), normal(random)));
}

// Refracts at a plane whose normal points to either side; the ray must go through.
Vec3d refracted_at(Vec3d direction, Vec3d normal, double eta) {
  if (dot(direction, normal) > 0) normal = -normal;
  const auto interface = dielectric_interface(-dot(direction, normal), eta);
  EXPECT_FALSE(interface.total_reflection);
  return refracted(direction, normal, eta, interface);
}

TEST(Refract, AnIndexOfOneLeavesTheBitsAlone) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) {
    const Vec3d d = random_direction(random), n = random_direction(random);
    ASSERT_EQ(refracted_at(d, n, 1.0), d);
  }
  EXPECT_EQ(refracted_at({1, 0, 0}, {0, 1, 0}, 1.0), Vec3d(1, 0, 0));  // tangent
}

TEST(Refract, ASmallStepOfIndexBendsByASmallAngle) {
  // The deviation is (eta - 1) tan i to first order; i = 45 degrees.
  const Vec3d d = normalized(Vec3d(1, -1, 0));
  for (int k = 20; k <= 50; k += 5) {
    const Vec3d t = refracted_at(d, {0, 1, 0}, 1 + std::exp2(-k));
    EXPECT_NEAR((cross(d, t).z) / std::exp2(-k), 1, std::exp2(2 - k) + std::exp2(k - 52)) << k;
  }
}

TEST(Refract, SnellAndUnitLength) {
  Worst snell("|n1 sin i - n2 sin t| / n1", 8, "eps"),
      unit_length("(|t| - 1) / max(1, eta)", 8, "eps");
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 100000; ++i) {
    const Vec3d d = random_direction(random);
    Vec3d n = random_direction(random);
    if (dot(d, n) > 0) n = -n;
    const double eta = std::exp2(2 * unit(random) - 1);
    const auto interface = dielectric_interface(-dot(d, n), eta);
    if (interface.total_reflection) continue;
    const Vec3d t = refracted(d, n, eta, interface);
    snell.add(length(eta * cross(d, n) - cross(t, n)) / larger(1.0, eta) / 0x1p-53);
    unit_length.add(std::fabs(length(t) - 1) / larger(1.0, eta) / 0x1p-53);
  }
}

// A normal whose length is off by 2 eps, as normalized() may leave it, turns that into 8 eps of the
// result; the rest is the rounding of the sums.
TEST(Refract, ReflectionTurnsTheNormalComponent) {
  Worst unit_length("| |r| - 1 |", 12, "eps"), turned("r.n + d.n", 12, "eps");
  std::mt19937_64 random(3);
  for (int i = 0; i < 100000; ++i) {
    const Vec3d d = random_direction(random), n = random_direction(random);
    const Vec3d r = reflected(d, n);
    turned.add(std::fabs(dot(r, n) + dot(d, n)) / 0x1p-53);
    EXPECT_EQ(r, reflected(d, -n));
    unit_length.add(std::fabs(length(r) - 1) / 0x1p-53);
  }
  EXPECT_EQ(reflected(Vec3d(0.6, -0.8, 0), Vec3d(0, 1, 0)), Vec3d(0.6, 0.8, 0));
}

TEST(Refract, ASlabGivesBackTheDirectionAndShiftsTheRay) {
  // Leaving, the error of cos i is that of cos^2 over cos i: the bound is 8 eps / cos i.
  Worst direction("slab: |exit - entry| cos i", 8, "eps"), shift("slab: shift", 16, "eps");
  const double n = 1.5, thickness = 1;
  for (int tenth = 0; tenth < 895; ++tenth) {
    const double angle = tenth / 10.0, sine = sin_deg(angle), cosine = cos_deg(angle);
    const Vec3d d(sine, -cosine, 0), normal(0, 1, 0);
    const Vec3d inside = refracted_at(d, normal, 1 / n);
    const Vec3d out = refracted_at(inside, normal, n);
    direction.add(length(out - d) * cosine / 0x1p-53);
    const Vec3d through = (thickness / -inside.y) * inside;
    const double measured = std::fabs(through.x * d.y - through.y * d.x);
    const double expected = thickness * sine * (1 - cosine / std::sqrt(n * n - sine * sine));
    shift.add(std::fabs(measured - expected) / 0x1p-53);
  }
}

TEST(Refract, APrismDeviatesLeastWhenPassedSymmetrically) {
  const double n = 1.5, apex = 60;
  const double sine = n * sin_deg(apex / 2);                   // of the symmetric incidence
  const Vec3d left(-cos_deg(apex / 2), sin_deg(apex / 2), 0);  // outward normals
  const Vec3d right(cos_deg(apex / 2), sin_deg(apex / 2), 0);
  const auto deviation = [&](double incidence_deg) {
    // Incoming from below the left normal.
    const double direction_deg = -apex / 2 + incidence_deg;
    const Vec3d d(cos_deg(direction_deg), sin_deg(direction_deg), 0);
    return acos_deg(dot(d, refracted_at(refracted_at(d, left, 1 / n), right, n)));
  };
  const double symmetric = asin_deg(sine);
  EXPECT_NEAR(deviation(symmetric), 2 * symmetric - apex, 1e-12);
  EXPECT_NEAR(deviation(symmetric), 37.180755781458, 1e-11);
  for (const double off : {-5.0, -1.0, 1.0, 5.0})
    EXPECT_GT(deviation(symmetric + off), deviation(symmetric) + 1e-4);
}

TEST(Absorption, BeerAndLambert) {
  const Rgbd half = transmitted_share(Rgbd(1, 2, 0), std::log(2.0));
  EXPECT_NEAR(half.r, 0.5, 2e-16);
  EXPECT_NEAR(half.g, 0.25, 1e-16);
  EXPECT_EQ(half.b, 1);
  const Rgbd far = transmitted_share(Rgbd(1, 2, 0), infinity<double>());
  EXPECT_EQ(far, Rgbd(0, 0, 1));
  // Two halves of a path absorb what the whole does.
  const Rgbd once = transmitted_share(Rgbd(0.3), 2.0), twice = transmitted_share(Rgbd(0.3), 1.0);
  EXPECT_NEAR(once.r, twice.r * twice.r, 2e-16);
}

}  // namespace
}  // namespace alhazen::render

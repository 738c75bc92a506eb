// tests: the rectangle light against Lambert's formula for the irradiance of a polygon.
#include "render/light/rectangle_light.h"

#include <array>
#include <random>

#include "core/math/elementary.h"
#include "core/math/random.h"
#include "unit/render/measured.h"

namespace alhazen::render {
namespace {

using test::Worst;

// (0,2) samples leave an error of about N^-1 to N^-3/2 of a smooth integrand's spread: the bounds
// on irradiances are N^-1 of a part of it, 1e-4.
constexpr int kSamples = 4096;

struct Corners {
  Vec3d corner, edge_u, edge_v;
};

RectangleLightKernel<double> kernel_of(const Corners& c) {
  return {RectangleLight{c.corner, c.edge_u, c.edge_v, Rgbd(1), kSamples}, Vec3d()};
}

// J. H. Lambert 1760: half the sum over the edges of the angle they subtend times the cosine of the
// normal with the plane of edge and point; the polygon wholly above the horizon.
double lambert_irradiance(const Corners& c, Vec3d normal) {
  const std::array<Vec3d, 4> p{c.corner, c.corner + c.edge_u, c.corner + c.edge_u + c.edge_v,
                               c.corner + c.edge_v};
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3d a = p[i], b = p[(i + 1) % 4], across = cross(a, b);
    const double angle = 2 * pi<double>() * atan2_turns(length(across), dot(a, b));
    sum += angle * dot(normal, across) / length(across);
  }
  return std::fabs(sum) / 2;
}

double irradiance(const RectangleLightView<double>& view, Vec3d normal, std::uint64_t seed) {
  double sum = 0;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const Sample2d s = sample_2d(seed, i);
    const auto sample = view.sample(unit_real<double>(s.x), unit_real<double>(s.y));
    sum += sample.weight.r * larger(0.0, dot(normal, sample.direction));
  }
  return sum;
}

// Shining down: cross(edge_u, edge_v) points to -y.
Corners ceiling(double height, double x, double z, double width, double depth) {
  return {{x, height, z}, {width, 0, 0}, {0, 0, depth}};
}

TEST(RectangleLight, IrradianceIsLamberts) {
  Worst worst("rectangle: irradiance / Lambert - 1, 4096 samples", 1e-4);
  const Vec3d up(0, 1, 0), tilted = normalized(Vec3d(0.1, 1, -0.2));
  const Corners cases[] = {ceiling(1, -1, -1, 2, 2),           ceiling(1, 3, -0.5, 2, 1),
                           ceiling(0.2, -1, -1, 2, 2),         ceiling(10, 0, 0, 1, 1),
                           ceiling(1e6, 5, 5, 1, 2),           ceiling(1, -0.1, -50, 0.2, 100),
                           {{-1, 2, -1}, {2, 0, 0}, {1, 0, 2}}};  // the last a parallelogram
  for (const Corners& c : cases) {
    const auto kernel = kernel_of(c);
    const RectangleLightView<double> view(kernel, {});
    worst.add(std::fabs(irradiance(view, up, 1) / lambert_irradiance(c, up) - 1));
    if (c.corner.y > 0.5 && std::fabs(c.edge_v.z) < 10)
      worst.add(std::fabs(irradiance(view, tilted, 2) / lambert_irradiance(c, tilted) - 1));
  }
}

// The sum of the weights is the solid angle. Seen from d above the middle of a rectangle with half
// sides a and b it is 4 atan(ab / (d sqrt(a^2 + b^2 + d^2))).
double solid_angle(const Corners& c) {
  const auto kernel = kernel_of(c);
  const RectangleLightView<double> view(kernel, {});
  double sum = 0;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const Sample2d s = sample_2d(5, i);
    sum += view.sample(unit_real<double>(s.x), unit_real<double>(s.y)).weight.r;
  }
  return sum;
}

TEST(RectangleLight, SolidAngleOnEveryScale) {
  // 0.01 away almost half of the sky is filled, 1e9 away 1e-18 of it.
  Worst near_light("rectangle: solid angle / closed form - 1, close by", 1e-13);
  Worst far_light("rectangle: the same, sampled by area", 1e-7);
  for (const double d : {1e-12, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e6, 1e9}) {
    const double a = 0.5, b = 1;
    const double above = a * b, below = d * std::sqrt(a * a + b * b + d * d);
    const double expected = 4 * 2 * pi<double>() * atan2_turns(above, below);
    (d > 2 ? far_light : near_light)
        .add(std::fabs(solid_angle(ceiling(d, -0.5, -1, 1, 2)) / expected - 1));
  }
}

TEST(RectangleLight, SamplesLieOnTheRectangle) {
  Worst off_plane("rectangle: samples off their plane / distance", 1e-13);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const double height = std::exp2(8 * unit(random) - 6);
    const Corners c =
        ceiling(height, 4 * unit(random) - 3, 4 * unit(random) - 3, 1 + unit(random), 2);
    const auto kernel = kernel_of(c);
    const RectangleLightView<double> view(kernel, {});
    const auto sample = view.sample(unit(random), unit(random));
    const Vec3d hit = sample.distance * sample.direction;
    const double tolerance = 1e-12 * sample.distance;
    off_plane.add(std::fabs(hit.y - height) / sample.distance);
    ASSERT_GE(hit.x, c.corner.x - tolerance);
    ASSERT_LE(hit.x, c.corner.x + c.edge_u.x + tolerance);
    ASSERT_GE(hit.z, c.corner.z - tolerance);
    ASSERT_LE(hit.z, c.corner.z + c.edge_v.z + tolerance);
  }
}

// Evenly in solid angle: the left part of the light gets its share of the samples.
TEST(RectangleLight, SamplesAreEvenInSolidAngle) {
  const auto kernel = kernel_of(ceiling(0.5, -0.3, -1, 2, 2));
  const RectangleLightView<double> view(kernel, {});
  const double whole = solid_angle(ceiling(0.5, -0.3, -1, 2, 2));
  for (const double part : {0.25, 0.5, 0.75}) {
    int in_left = 0, in_near = 0;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
      const Sample2d s = sample_2d(7, i);
      const auto sample = view.sample(unit_real<double>(s.x), unit_real<double>(s.y));
      const Vec3d hit = sample.distance * sample.direction;
      in_left += hit.x < -0.3 + 2 * part;
      in_near += hit.z < -1 + 2 * part;
    }
    // The left border is a line in u, of error at most one sample in each stratum of it; the near
    // border a curve through (0,2) samples.
    const double left = solid_angle(ceiling(0.5, -0.3, -1, 2 * part, 2)) / whole;
    const double near_share = solid_angle(ceiling(0.5, -0.3, -1, 2, 2 * part)) / whole;
    EXPECT_NEAR(in_left / double{kSamples}, left, 2.0 / kSamples);
    EXPECT_NEAR(in_near / double{kSamples}, near_share, 16.0 / kSamples);
  }
}

// Close to the plane of the light, in it, and behind it (docs/numerics.md B5).
TEST(RectangleLight, CloseToTheLight) {
  Worst close("rectangle: irradiance / Lambert - 1, close to the light", 1e-4);
  const Vec3d up(0, 1, 0);
  for (const double height : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    const auto above = kernel_of(ceiling(height, -1, -0.5, 2, 1));
    close.add(std::fabs(irradiance(RectangleLightView<double>(above, {}), up, 3) /
                            lambert_irradiance(ceiling(height, -1, -0.5, 2, 1), up) -
                        1));
    const auto behind = kernel_of(ceiling(-height, -1, -0.5, 2, 1));
    EXPECT_TRUE(is_black(RectangleLightView<double>(behind, {}).sample(0.3, 0.4).weight));
    // Beside the rectangle, where its plane hides it.
    const auto beside = kernel_of(ceiling(height, 1, -0.5, 2, 1));
    const auto sample = RectangleLightView<double>(beside, {}).sample(0.3, 0.4);
    EXPECT_TRUE(is_finite(sample.direction) && is_finite(sample.weight.r));
  }
  const auto level = kernel_of(ceiling(0, -1, -1, 2, 2));
  EXPECT_TRUE(is_black(RectangleLightView<double>(level, {}).sample(0.5, 0.5).weight));
}

TEST(RectangleLight, ScalesByPowersOfTwo) {
  for (const Corners& c : {ceiling(1, -1, -1, 2, 3), ceiling(9, -1, -1, 2, 3)}) {
    const auto one = kernel_of(c);
    for (const int k : {-150, -10, 1, 10, 150}) {
      const double s = std::exp2(k);
      const auto scaled = kernel_of({s * c.corner, s * c.edge_u, s * c.edge_v});
      const RectangleLightView<double> a(one, {0.25, 0, 0.5});
      const RectangleLightView<double> b(scaled, {s * 0.25, 0, s * 0.5});
      const auto x = a.sample(0.3, 0.8), y = b.sample(0.3, 0.8);
      EXPECT_EQ(x.direction, y.direction);
      EXPECT_EQ(x.weight, y.weight);
      EXPECT_EQ(x.distance * s, y.distance);
    }
  }
}

}  // namespace
}  // namespace alhazen::render

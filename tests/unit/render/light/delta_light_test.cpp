// tests: lights without extent: inverse square, cones, and points that see nothing.
#include <random>

#include "render/light/directional_light.h"
#include "render/light/spot_light.h"
#include "unit/render/measured.h"

namespace alhazen::render {
namespace {

using test::Worst;

PointLightKernel<double> point_light(Vec3d position, Falloff falloff = Falloff::inverse_square) {
  return {PointLight{position, Rgbd(3, 2, 1), falloff}, Vec3d()};
}

TEST(PointLight, FallsOffWithTheSquareOfTheDistance) {
  for (int k = -200; k <= 200; k += 20) {
    const double d = std::exp2(k);
    const auto sample = point_light({0, d, 0}).sample({0, 0, 0});
    EXPECT_EQ(sample.weight, Rgbd(3, 2, 1) / (d * d));
    EXPECT_EQ(sample.distance, d);
    EXPECT_EQ(sample.direction, Vec3d(0, 1, 0));
  }
}

TEST(PointLight, WithoutFalloffIsTheSameEverywhere) {
  EXPECT_EQ(point_light({0, 1e9, 0}, Falloff::none).sample({1, 2, 3}).weight, Rgbd(3, 2, 1));
}

// The flux through a sphere around the light, of any radius and off the centre: 4 pi I.
TEST(PointLight, SendsTheSameFluxThroughEverySphere) {
  Worst worst("point light: flux / (4 pi I) - 1", 1e-12);
  for (const double radius : {0.5, 1.0, 7.0}) {
    for (const double off : {0.0, 0.3, 0.45}) {
      const auto light = point_light({0, 0, off * radius});
      const double flux = test::integral(-1, 1, 32, [&](double mu) {
        const Vec3d n(std::sqrt(1 - mu * mu), 0, mu);
        const auto sample = light.sample(radius * n);
        return 2 * pi<double>() * radius * radius * sample.weight.r * -dot(n, sample.direction);
      });
      worst.add(std::fabs(flux / (4 * pi<double>() * 3) - 1));
    }
  }
}

// A light a hair above a surface, on it, and behind it (docs/numerics.md B5).
TEST(PointLight, CloseToTheSurface) {
  const auto above = point_light({0, 1e-12, 0});
  const Vec3d point(1e-12, 0, 0);
  const auto sample = above.sample(point);
  const double irradiance = sample.weight.r * dot(sample.direction, Vec3d(0, 1, 0));
  EXPECT_NEAR(irradiance / (3 / 2e-24 / std::sqrt(2)), 1, 1e-15);
  const auto on = point_light({1, 2, 3}).sample({1, 2, 3});
  EXPECT_TRUE(is_black(on.weight));
  EXPECT_TRUE(is_finite(on.direction));
  const auto behind = point_light({0, -1e-12, 0}).sample({0, 0, 0});
  EXPECT_LT(behind.direction.y, 0);
}

TEST(PointLight, RebasingIsExactForRepresentableDifferences) {
  const Vec3d origin(0x1p40, -0x1p40, 0x1p39);
  const PointLight far{origin + Vec3d(1, 2, 3), Rgbd(1), Falloff::inverse_square};
  EXPECT_EQ(PointLightKernel<float>(far, origin).position, Vec3<float>(1, 2, 3));
}

TEST(DirectionalLight, ShinesAgainstItsDirection) {
  const DirectionalLightKernel<double> light(DirectionalLight{{0, -1, 0}, Rgbd(2)});
  EXPECT_EQ(light.sample().direction, Vec3d(0, 1, 0));
  EXPECT_EQ(light.sample().distance, infinity<double>());
  EXPECT_EQ(light.sample().weight, Rgbd(2));
}

SpotLightKernel<double> spot(double inner, double outer) {
  return {SpotLight{{0, 0, 0}, {0, -1, 0}, Rgbd(1), inner, outer, Falloff::none}, Vec3d()};
}
double spot_weight(const SpotLightKernel<double>& light, double angle_deg) {
  return light.sample({sin_deg(angle_deg), -cos_deg(angle_deg), 0}).weight.r;
}

TEST(SpotLight, IsFullInsideAndDarkOutside) {
  const auto light = spot(30, 45);
  for (const double angle : {0.0, 10.0, 29.999999})
    EXPECT_EQ(spot_weight(light, angle), 1);
  for (const double angle : {45.000001, 60.0, 90.0, 180.0})
    EXPECT_EQ(spot_weight(light, angle), 0);
}

TEST(SpotLight, IsASmoothstepInTheCosine) {
  const auto light = spot(30, 45);
  const double middle = (cos_deg(30) + cos_deg(45)) / 2;
  EXPECT_NEAR(light.share(middle), 0.5, 1e-15);
  const double quarter = cos_deg(45) + (cos_deg(30) - cos_deg(45)) / 4;
  EXPECT_NEAR(light.share(quarter), (3 - 0.5) / 16, 1e-15);
}

TEST(SpotLight, EqualAnglesMakeAHardEdge) {
  const auto light = spot(60, 60);
  EXPECT_EQ(light.share(0.5), 1);
  EXPECT_EQ(light.share(std::nextafter(0.5, 0.0)), 0);
  EXPECT_EQ(spot_weight(spot(0, 90), 90.1), 0);
}

}  // namespace
}  // namespace alhazen::render

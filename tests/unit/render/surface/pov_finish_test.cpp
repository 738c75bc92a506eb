// tests: POV-Ray's surface model against values worked out by hand (docs/pov_ray.md).
#include "render/surface/pov_finish.h"

#include <gtest/gtest.h>

#include "render/surface/fresnel.h"

namespace alhazen::render {
namespace {

// A few roundings of numbers near 1.
constexpr double kRounding = 4e-16;

const Vec3d kNormal(0, 0, 1);
// At 60 degrees from the normal on either side: each is the other's mirror image.
const Vec3d kView(0.8660254037844386, 0, 0.5), kMirrored(-0.8660254037844386, 0, 0.5);

PovSurface<double> surface_of(const PovFinish& finish) {
  return make_pov_surface<double>(finish);
}

TEST(PovFinish, OpacityIsInWhatTheSurfaceShowsItself) {
  PovFinish m;
  m.filter = 0.25;
  m.transmit = 0.5;
  m.diffuse = 2;
  m.ambient = Rgbd(0.5, 1, 0);
  m.emission = Rgbd(1, 0, 2);
  const auto s = surface_of(m);
  EXPECT_EQ(s.glow, Rgbd(0.375, 0.25, 0.5));
  EXPECT_EQ(pov_diffuse(s.shading, Rgbd(1, 0.5, 0), 0.5), Rgbd(0.25, 0.125, 0));
}

TEST(PovFinish, BrillianceIsAPowerOfTheCosine) {
  PovFinish m;
  m.diffuse = 1;
  m.brilliance = 3;
  EXPECT_NEAR(pov_diffuse(surface_of(m).shading, Rgbd(1), 0.5).r, 0.125, kRounding);
}

TEST(PovFinish, PhongIsAPowerOfTheCosineWithTheMirroredView) {
  PovFinish m;
  m.phong = 0.75;
  m.phong_size = 3;
  const auto s = surface_of(m);
  EXPECT_NEAR(pov_highlights(s.shading, Rgbd(1), kNormal, kView, kMirrored).r, 0.75, kRounding);
  // Light from straight above: 60 degrees from the mirrored view.
  EXPECT_NEAR(pov_highlights(s.shading, Rgbd(1), kNormal, kView, kNormal).r, 0.75 / 8, kRounding);
  // Light from where one looks: 120 degrees from it.
  EXPECT_EQ(pov_highlights(s.shading, Rgbd(1), kNormal, kView, kView), Rgbd());
}

// cos = 2^-12 is below POV-Ray's bound of 0.0008, which it heeds from size 60 on.
TEST(PovFinish, SharpPhongHasAnEnd) {
  const double cosine = 0x1p-12, sine = std::sqrt((1 - cosine) * (1 + cosine));
  PovFinish m;
  m.phong = 1;
  m.phong_size = 60;
  EXPECT_EQ(pov_highlights(surface_of(m).shading, Rgbd(1), kNormal, kNormal, {sine, 0, cosine}),
            Rgbd());
  m.phong_size = 59;
  const double left =
      pov_highlights(surface_of(m).shading, Rgbd(1), kNormal, kNormal, {sine, 0, cosine}).r;
  EXPECT_NEAR(left / std::pow(cosine, 59), 1, 59 * kRounding);
}

TEST(PovFinish, SpecularIsAPowerOfTheCosineOfTheHalfVector) {
  PovFinish m;
  m.specular = 0.5;
  m.roughness = 0.25;
  const auto s = surface_of(m);
  EXPECT_NEAR(pov_highlights(s.shading, Rgbd(1), kNormal, kView, kMirrored).r, 0.5, kRounding);
  // Both along one direction at 60 degrees: the half vector is there too.
  EXPECT_NEAR(pov_highlights(s.shading, Rgbd(1), kNormal, kView, kView).r, 0.5 / 16, kRounding);
}

TEST(PovFinish, MetallicTintsTowardsTheColourAndNotAtGrazingAngles) {
  const Rgbd gold(1, 0.5, 0);
  EXPECT_EQ(pov_metal_tint(0.0, gold, 0.3), Rgbd(1));
  // From straight above F = 0.014567225 / 1.12^2 - 0.011612903 = -4e-10, which counts as 0.
  const Rgbd above = pov_metal_tint(1.0, gold, 1.0);
  EXPECT_EQ(above.g, 0.5);
  EXPECT_EQ(above.b, 0);
  EXPECT_EQ(above.r, 1);
  // At 90 degrees F is 1 to 1e-8, and never above 1.
  EXPECT_NEAR(pov_metal_tint(1.0, gold, 0.0).b, 1, 1e-6);
  EXPECT_LE(pov_metal_tint(1.0, gold, 0.0).b, 1);
  // 60 degrees: x = 2/3.
  const double f60 = 0.014567225 / ((2 / 3. - 1.12) * (2 / 3. - 1.12)) - 0.011612903;
  EXPECT_NEAR(pov_metal_tint(0.5, gold, 0.5).b, 1 - 0.5 * (1 - f60), 1e-15);
}

TEST(PovFinish, ReflectionGoesFromMinToMax) {
  PovFinish m;
  m.reflection = {Rgbd(0.1, 0.2, 0), Rgbd(0.9, 0.2, 1), 2, false, 0};
  const auto s = surface_of(m);
  EXPECT_EQ(pov_reflectance(s.mirror, Rgbd(1), 1.0, 0.0), Rgbd(0.1, 0.2, 0));
  EXPECT_NEAR(pov_reflectance(s.mirror, Rgbd(1), 0.0, 0.0).r, 0.9, kRounding);
  EXPECT_NEAR(pov_reflectance(s.mirror, Rgbd(1), 0.5, 0.0).r, 0.1 + 0.25 * 0.8, kRounding);
  EXPECT_EQ(pov_reflectance(s.mirror, Rgbd(1), 0.5, 0.0).g, 0.2);
  m.reflection.falloff = 0;
  EXPECT_EQ(pov_reflectance(surface_of(m).mirror, Rgbd(1), 1.0, 0.0).b, 1);
  m.reflection.fresnel = true;
  EXPECT_NEAR(pov_reflectance(surface_of(m).mirror, Rgbd(1), 1.0, 0.04).b, 0.04, kRounding);
}

// POV-Ray's formula, F = ((g - c) / (g + c))^2 / 2 (1 + ((c (g + c) - 1) / (c (g - c) + 1))^2) with
// g^2 = n^2 + c^2 - 1, is that of fresnel.h.
TEST(PovFinish, FresnelIsTheExactFormula) {
  for (const double n : {1.01, 1.5, 2.4, 0.8}) {
    for (const double c : {1.0, 0.9, 0.7, 0.65}) {
      const double g = std::sqrt(n * n + c * c - 1);
      const double s = (g - c) / (g + c), p = (c * (g + c) - 1) / (c * (g - c) + 1);
      const double want = s * s / 2 * (1 + p * p);
      EXPECT_NEAR(dielectric_interface(c, 1 / n).reflectance, want, 1e-14) << n << " " << c;
    }
  }
}

TEST(PovFinish, FilterTakesTheColourAndTransmitDoesNot) {
  PovFinish m;
  m.filter = 0.5;
  m.transmit = 0.25;
  EXPECT_EQ(pov_passed(surface_of(m).passage, Rgbd(1, 0.5, 0)), Rgbd(0.75, 0.5, 0.25));
}

TEST(PovFinish, FadesByAPowerOrExponentially) {
  PovFinish m;
  m.fade_distance = 2;
  m.fade_power = 2;
  m.fade_color = Rgbd(0, 0.5, 1);
  const Rgbd at_distance = pov_fade(surface_of(m).fading, 2.0);
  EXPECT_NEAR(at_distance.r, 0.5, kRounding);
  EXPECT_NEAR(at_distance.g, 0.75, kRounding);
  EXPECT_EQ(at_distance.b, 1);
  EXPECT_NEAR(pov_fade(surface_of(m).fading, 4.0).r, 0.2, kRounding);
  EXPECT_EQ(pov_fade(surface_of(m).fading, 0.0).r, 1);
  m.fade_power = 1000;
  EXPECT_NEAR(pov_fade(surface_of(m).fading, 4.0).r, std::exp(-2.0), kRounding);
  EXPECT_NEAR(pov_fade(surface_of(m).fading, 4.0).g, std::exp(-1.0), kRounding);
  EXPECT_EQ(pov_fade(surface_of(m).fading, 4.0).b, 1);
  m.fade_power = 999;  // hardly less than the step that it would be at infinity
  EXPECT_NEAR(pov_fade(surface_of(m).fading, 1.9).r, 1, 1e-15);
  EXPECT_NEAR(pov_fade(surface_of(m).fading, 2.1).g, 0.5, 1e-15);
}

TEST(PovFinish, NoLessThanNothingIsLeftToPass) {
  EXPECT_EQ(pov_rest(Rgbd(0.25, 1, 1.5)), Rgbd(0.75, 0, 0));
}

}  // namespace
}  // namespace alhazen::render

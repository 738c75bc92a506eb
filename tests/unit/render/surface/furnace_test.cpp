// tests: the white furnace, material by material: in light of radiance 1 from everywhere a surface
// sends out reflected + transmitted = 1 - absorbed, at every angle.
#include "render/surface/coat.h"
#include "render/surface/fresnel.h"
#include "render/surface/highlight.h"
#include "unit/render/measured.h"

namespace alhazen::render {
namespace {

using test::Worst;

// From grazing to head on, on every scale.
template <class Check>
void at_every_angle(Check check) {
  for (int k = 0; k <= 40; ++k)
    check(std::exp2(-k));
  for (int i = 1; i < 100; ++i)
    check(i / 100.0);
}

TEST(WhiteFurnace, GlassReflectsOrTransmitsEverything) {
  Worst worst("glass: reflected + transmitted - 1", 0x1p-53);
  for (const double eta : {1 / 1.5, 1.5, 1 / 2.4, 2.4, 1.0}) {
    at_every_angle([&](double cosine) {
      const auto top = dielectric_interface(cosine, eta);
      worst.add(std::fabs(top.reflectance + top.transmittance - 1));
    });
  }
}

// Through a slab of clear glass with all reflections inside: R + T = 1 with
// R = F + (1-F)^2 F / (1 - F^2), T = (1-F)^2 / (1 - F^2) (docs/numerics.md C5).
TEST(WhiteFurnace, ASlabOfGlassLosesNothing) {
  Worst worst("slab: all orders summed - 1", 8 * 0x1p-53);
  at_every_angle([&](double cosine) {
    const auto top = dielectric_interface(cosine, 1 / 1.5);
    const double f = top.reflectance, t = top.transmittance;
    // 1 - F^2 = T (1 + F), where 1 - F may be small.
    const double through = t / (1 + f);
    worst.add(std::fabs(f + through * f + through - 1));
  });
  const auto head_on = dielectric_interface(1.0, 1 / 1.5);
  EXPECT_NEAR(head_on.transmittance / (1 + head_on.reflectance), 0.92307692307692308, 1e-15);
}

TEST(WhiteFurnace, MetalReflectsTheRestOfWhatItAbsorbs) {
  const Rgbd n(0.143, 0.375, 1.442), k(3.983, 2.386, 1.603);  // gold
  at_every_angle([&](double cosine) {
    const Rgbd r = conductor_reflectance(cosine, n, k, 1.0);
    for (const double channel : {r.r, r.g, r.b}) {
      EXPECT_GT(channel, 0);
      EXPECT_LT(channel, 1);
    }
  });
}

TEST(WhiteFurnace, ACoatGivesBackAllButWhatItsBaseAbsorbs) {
  Worst white("coat, white base: mirror + diffuse - 1", 8 * 0x1p-53);
  for (const double ior : {1.33, 1.5, 2.0}) {
    const auto layer = make_coat_layer<double>({ior, Rgbd(0), 0});
    at_every_angle([&](double cosine) {
      const double mirror = coat_mirror_reflectance(layer, cosine);
      white.add(std::fabs(mirror + coat_diffuse_albedo(layer, Rgbd(1), cosine).r - 1));
      EXPECT_EQ(coat_diffuse_albedo(layer, Rgbd(0), cosine), Rgbd(0));
    });
  }
}

TEST(WhiteFurnace, AnAbsorbingCoatLosesWhatItTakes) {
  for (const double ior : {1.33, 1.5, 2.0}) {
    for (const double tau : {1e-6, 0.1, 3.0}) {
      const auto layer = make_coat_layer<double>({ior, Rgbd(tau), 0});
      at_every_angle([&](double cosine) {
        const double sent =
            coat_mirror_reflectance(layer, cosine) + coat_diffuse_albedo(layer, Rgbd(1), cosine).r;
        EXPECT_LE(sent, 1);
        if (cosine > 1e-3) {  // closer to grazing next to nothing enters the layer
          EXPECT_LT(sent, 1);
        }
      });
    }
  }
}

// albedo + strength <= 1, the highlight holds at most its strength (highlight_test), so the sum is
// at most 1; here with the lobe's albedo along the normal, its largest.
TEST(WhiteFurnace, DiffuseWithAHighlight) {
  const double albedo = 0.75, strength = 0.25;
  for (const HighlightModel model : {HighlightModel::phong, HighlightModel::blinn}) {
    const auto lobe = make_highlight_lobe<double>({model, Rgbd(strength), 8});
    const Vec3d normal(0, 0, 1);
    const double sent = test::integral(0, 1, 16, [&](double mu) {
      const Vec3d light(std::sqrt(1 - mu * mu), 0, mu);
      return 2 * pi<double>() * mu *
             (albedo / pi<double>() + highlight_value(lobe, normal, normal, light).r);
    });
    EXPECT_NEAR(sent, 1, 1e-12);
  }
}

}  // namespace
}  // namespace alhazen::render

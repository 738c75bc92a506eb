// F1, F2, F6: a picture does not know how large the scene is.
#include <fmt/format.h>

#include "hard/relations/pictures.h"
#include "hard/relations/scenes.h"
#include "support/busy_scene.h"

namespace alhazen::hard {
namespace {

using testing::busy_scene;

Scene small_busy_scene(double scale) {
  Scene scene = busy_scene(scale);
  scene.settings.width = 25;
  scene.settings.height = 19;
  return scene;
}

// All lengths times 2^k, absorption times 2^-k, intensities times 4^k. Everything that nearly every
// stage does is in this scene.
TEST(Hard, F1_ScaleByPowersOfTwo) {
  const Picture plain = picture_of(small_busy_scene(1));
  double worst = 0;
  for (const int k : {-300, -100, -10, -1, 1, 10, 100, 300}) {
    const Picture scaled = picture_of(small_busy_scene(std::ldexp(1, k)));
    worst = std::max(worst, different_bits(scaled.rgb, plain.rgb));
  }
  figure("F1", "double", "values with other bits, k = +-1, +-10, +-100, +-300", worst, 0);
  for (const NamedScene& scene : kScenes) {
    const Picture base = decisions_of(scene.at({}));
    double flips = 0;
    for (const int k : {-300, 300}) {
      const Picture scaled = decisions_of(scene.at({std::ldexp(1, k)}));
      flips += scaled.signature == base.signature && scaled.margin == base.margin ? 0 : 1;
    }
    figure("F1", "double", fmt::format("{}: pictures with other decisions, k = +-300", scene.name),
           flips, 0);
  }
}

TEST(Hard, F1_ScaleByPowersOfTwoInFloat) {
  const render::RenderOptions options{.precision = Precision::float32};
  const Picture plain = picture_of(small_busy_scene(1), options);
  for (const int k : {1, 10, 25, 50, 64}) {
    double worst = 0;
    for (const int exponent : {-k, k}) {
      const Picture scaled = picture_of(small_busy_scene(std::ldexp(1, exponent)), options);
      worst = std::max(worst, different_bits(scaled.rgb, plain.rgb));
    }
    const std::string what = fmt::format("values with other bits, k = +-{}", k);
    if (k <= 50) {
      figure("F1", "float", what, worst, 0);
    } else {
      figure_beyond("F1", "float", what, worst, 0, "",
                    "a light's intensity times 4^64 is no float");
    }
  }
}

// Numbers that are rounded differently: the same decisions, and the same light to 1e-9, wherever
// the margin of the plain picture allows to ask for it.
TEST(Hard, F2_ScaleByPowersOfTen) {
  for (const NamedScene& scene : kScenes) {
    const Picture plain = decisions_of(scene.at({}));
    Certified worst;
    for (int k = -12; k <= 12; ++k) {
      const Certified now =
          compare_certified(plain, decisions_of(scene.at({std::pow(10, k)})), 1e-9);
      worst.flips = std::max(worst.flips, now.flips);
      worst.largest_error = std::max(worst.largest_error, now.largest_error);
      worst.pixels = now.pixels;
    }
    EXPECT_GT(worst.pixels, 0.9 * static_cast<double>(plain.margin.size())) << scene.name;
    figure("F2", "double", fmt::format("{}: flips in certified pixels, k = -12..12", scene.name),
           worst.flips, 0);
    figure("F2", "double", fmt::format("{}: largest difference, k = -12..12", scene.name),
           worst.largest_error, 1e-9);
  }
}

// A thing of 1e-6 in the middle of a room of 1e6, the camera close to it, is the thing alone: the
// room is black and only stands around.
TEST(Hard, F6_TeapotInAStadium) {
  const auto picture = [](bool room) {
    PlacedScene s({1e-6});
    auto& b = s.materials();
    b.background(0);
    s.sphere({-0.5, 0, 0}, 1, b.diffuse(0.6));
    s.cylinder({0.5, -1, 0.25}, {1, 1, 0.25}, 0.5, s.glass(1.5, 0.25));
    s.cone({0, -1, -1}, {0, 0, -1}, 0.5, b.mirror(0.875));
    s.quad({-3, -1, 3}, {6, 0.25, 1}, {0, 4, -0.5}, b.diffuse(0.4));
    s.point_light({4, 6, -4}, 90);
    s.look({0.015625, 0.53125, -5}, 45);
    Scene scene = s.finish();
    if (room) {
      const double half = 1e6;
      scene.materials.push_back({Black{}, {}, false, "", {}});
      const auto black = static_cast<MaterialId>(scene.materials.size() - 1);
      scene.shapes.push_back({Box{Vec3d(-half, -half, -half), Vec3d(half, half, half)},
                              std::nullopt,
                              black,
                              kNoId,
                              "",
                              {}});
    }
    return picture_of(scene);
  };
  const Picture alone = picture(false);
  EXPECT_GT(*std::max_element(alone.rgb.begin(), alone.rgb.end()), 0.1);
  figure("F6", "double", "largest difference from the thing alone",
         largest_difference(picture(true).rgb, alone.rgb), 1e-9);
}

}  // namespace
}  // namespace alhazen::hard

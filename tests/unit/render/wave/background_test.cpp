// Where rays meet nothing: the colour by direction.
#include "render/wave/background.h"

#include <gtest/gtest.h>

#include "core/math/elementary.h"
#include "unit/render/lanes_agree.h"

namespace alhazen::render {
namespace {

Rgbd seen(const Background& background, const std::vector<ImagePixels>& images, Vec3d direction) {
  const BackgroundRadiance<double> radiance(background, images);
  return images.empty() ? radiance.plain(direction) : radiance.picture(direction);
}

TEST(Background, GradientIsLinearInTheHeightOfTheDirection) {
  const Background gradient{GradientBackground{{{-1, Rgbd(0)}, {0, Rgbd(1)}, {1, Rgbd(3)}}}, {}};
  EXPECT_EQ(seen(gradient, {}, {0, -1, 0}), Rgbd(0));
  EXPECT_EQ(seen(gradient, {}, {0.8, -0.6, 0}).r, 1 - 0.6);
  EXPECT_EQ(seen(gradient, {}, {1, 0, 0}), Rgbd(1));
  EXPECT_EQ(seen(gradient, {}, {0, 0.5, 0.8660254037844386}).r, 2);
  EXPECT_EQ(seen(gradient, {}, {0, 1, 0}), Rgbd(3));
}

// A picture of 4 x 2 pixels that are all different: each is seen at its centre.
TEST(Background, PictureLiesAsSceneCameraSays) {
  ImagePixels image{4, 2, {}};
  for (int i = 0; i < 8; ++i)
    image.rgb.insert(image.rgb.end(), {static_cast<float>(i), 0.0F, 1.0F});
  const auto at = [&](double azimuth_deg, double elevation_deg, double rotation_deg = 0) {
    const Background picture{EnvironmentBackground{0, rotation_deg, 2}, {}};
    const double c = cos_deg(elevation_deg);
    return seen(picture, {image},
                {c * sin_deg(azimuth_deg), sin_deg(elevation_deg), c * cos_deg(azimuth_deg)})
        .r;
  };
  // Columns are centred at azimuths -135, -45, 45 and 135 degrees from +z towards +x.
  EXPECT_NEAR(at(-135, 45), 2 * 0, 1e-12);
  EXPECT_NEAR(at(-45, 45), 2 * 1, 1e-12);
  EXPECT_NEAR(at(45, 45), 2 * 2, 1e-12);
  EXPECT_NEAR(at(135, -45), 2 * 7, 1e-12);
  EXPECT_NEAR(at(0, 45), 2 * 1.5, 1e-12);     // between two columns
  EXPECT_NEAR(at(180, 45), 2 * 1.5, 1e-12);   // across the seam: 3 and 0
  EXPECT_NEAR(at(45, 45, 90), 2 * 1, 1e-12);  // turned by a column
}

// Every kind of background, on lanes as for single directions.
TEST(Background, LanesSeeWhatSingleRaysSee) {
  ImagePixels image{5, 3, {}};
  for (int i = 0; i < 45; ++i)
    image.rgb.push_back(static_cast<float>(i));
  const std::vector<Background> backgrounds{
      {SolidBackground{{1, 2, 3}}, {}},
      {GradientBackground{{{-1, Rgbd(0)}, {0, Rgbd(1)}, {0, Rgbd(2)}, {1, Rgbd(3)}}}, {}},
      {EnvironmentBackground{0, 77, 0.3}, {}}};
  for (const Background& background : backgrounds) {
    expect_all_lanes_agree<3>(
        [](int i, int j) {
          return drawn_from({-1, 0, -0.0, 1e-9, 1}, i, j);
        },
        [&](auto& out, const auto& in) {
          using Real = std::decay_t<decltype(in[0])>;
          const BackgroundRadiance<ScalarOf<Real>> radiance(background, {image});
          const Vec3<Real> direction(in[0], in[1], in[2]);
          const bool is_picture = background.source.index() == 2;
          put(out, is_picture ? radiance.picture(direction) : radiance.plain(direction));
        },
        1000);
  }
}

}  // namespace
}  // namespace alhazen::render

// F3, F4, F5: nor where it stands, nor which way it is turned, nor who computes it.
#include <fmt/format.h>

#include "hard/relations/pictures.h"
#include "hard/relations/scenes.h"
#include "support/busy_scene.h"

namespace alhazen::hard {
namespace {

TEST(Hard, F3_RepresentableTranslations) {
  for (const NamedScene& scene : kScenes) {
    const Picture plain = picture_of(scene.at({}));
    double worst = 0;
    for (const int k : {10, 20, 30, 40}) {
      const double t = std::ldexp(1, k);
      const Picture moved = picture_of(scene.at({1, Vec3d(t, -t, 2 * t)}));
      worst = std::max(worst, different_bits(moved.rgb, plain.rgb));
    }
    figure("F3", "double",
           fmt::format("{}: values with other bits, moved by 2^10 .. 2^40", scene.name), worst, 0);
  }
}

TEST(Hard, F4_MirrorImage) {
  for (const NamedScene& scene : kScenes) {
    const Picture plain = picture_of(scene.at({}));
    const Picture mirrored =
        picture_of(scene.at({1, {}, {Vec3d(-1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)}}));
    // The camera's right is mirrored as well, so what it sees is the same picture.
    figure("F4", "double", fmt::format("{}: values with other bits, x -> -x", scene.name),
           different_bits(mirrored.rgb, plain.rgb), 0);
  }
}

// A scene that is its own mirror image, seen by a camera that is not mirrored: the picture is.
TEST(Hard, F4_SymmetricScene) {
  const auto scene = [](double side) {
    PlacedScene s({});
    auto& b = s.materials();
    s.box({-8, -2, -8}, {8, -1.03125, 8}, b.diffuse(0.7));
    s.sphere({side * 1.25, 0, 1}, 1, s.glass(1.5, 0.25));
    s.sphere({side * -1, 0.25, 2}, 0.875, b.mirror(0.75));
    s.point_light({side * 4, 6, -4}, 90);
    s.look({0, 0.53125, -5}, 50);
    return picture_of(s.finish());
  };
  figure("F4", "double", "values with other bits, right against left",
         different_bits(flipped(scene(1)), scene(-1).rgb), 0);
}

TEST(Hard, F4_OrderOfShapesAndLights) {
  for (const NamedScene& scene : kScenes) {
    const Picture plain = picture_of(scene.at({}));
    Place place;
    place.shapes_reversed = true;
    figure("F4", "double", fmt::format("{}: values with other bits, shapes reversed", scene.name),
           different_bits(picture_of(scene.at(place)).rgb, plain.rgb), 0);
    // A sum of up to 15 lights in another order: as many roundings of numbers below 1.
    place.lights_reversed = true;
    figure("F4", "double", fmt::format("{}: difference, lights reversed too", scene.name),
           largest_difference(picture_of(scene.at(place)).rgb, plain.rgb), 15 * 0x1p-53);
  }
}

// A box's faces have other numbers after a turn, so signatures differ; what counts is the light.
TEST(Hard, F4_QuarterTurns) {
  using Axes = std::array<Vec3d, 3>;
  const Vec3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  for (const NamedScene& scene : kScenes) {
    const Picture plain = decisions_of(scene.at({}));
    double worst = 0;
    for (const Axes& axes : {Axes{y, -x, z}, Axes{-z, y, x}, Axes{x, z, -y}}) {
      const Picture turned = decisions_of(scene.at({1, {}, axes}));
      worst = std::max(worst, compare_certified(plain, turned, 1e-9).largest_error);
    }
    figure("F4", "double",
           fmt::format("{}: largest difference in certified pixels, turned", scene.name), worst,
           1e-12);
  }
}

TEST(Hard, F4_SplitUnions) {
  GTEST_SKIP() << "F4, split unions: there are no solids made of others yet";
}

// Compilers, optimisation levels and instruction sets: tools/same-bits, as the long test
// Long.same_bits.
TEST(Hard, F5_ThreadsAndTiles) {
  const Scene scene = testing::busy_scene();
  for (const Precision precision : {Precision::float64, Precision::float32}) {
    const char* scalar = precision == Precision::float64 ? "double" : "float";
    const Picture one = picture_of(scene, {.precision = precision, .threads = 1});
    double worst = 0;
    for (const int threads : {2, 16}) {
      const Picture many = picture_of(scene, {.precision = precision, .threads = threads});
      worst = std::max(worst, different_bits(many.rgb, one.rgb));
    }
    figure("F5", scalar, "values with other bits, 1, 2 and 16 threads", worst, 0);
    // Tiles are 16 pixels wide, from the corner of the crop on: here each begins elsewhere.
    std::vector<double> pieces(one.rgb.size());
    for (const render::PixelRect crop :
         {render::PixelRect{0, 0, 7, 38}, {7, 0, 43, 13}, {7, 13, 43, 25}}) {
      const Picture piece = picture_of(scene, {.precision = precision, .crop = crop});
      for (int row = 0; row < crop.height; ++row) {
        std::copy_n(&piece.rgb[static_cast<std::size_t>(3 * row * crop.width)], 3 * crop.width,
                    &pieces[static_cast<std::size_t>(3 * ((crop.y + row) * 50 + crop.x))]);
      }
    }
    figure("F5", scalar, "values with other bits, other tiles", different_bits(pieces, one.rgb), 0);
  }
}

}  // namespace
}  // namespace alhazen::hard

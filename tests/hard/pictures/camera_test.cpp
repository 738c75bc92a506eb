// tests/hard/pictures: E1 to E4, cameras.
#include "core/math/elementary.h"
#include "hard/pictures/support.h"
#include "support/front_end.h"

namespace alhazen::hard {
namespace {

// A ball aside of the axis that fills a third of the picture; 0 where the pixel's centre misses it,
// 1 where it hits, in closed form: the ray hits when its angle to the centre's direction is at most
// asin(R/D).
struct FovCase {
  Vec3d center;
  double radius;
  bool hits(int x, int y, int side, double fov_deg) const {
    const double half = tan_deg(fov_deg / 2);
    const long double px = ((x + 0.5L) / side * 2 - 1) * half;
    const long double py = (1 - (y + 0.5L) / side * 2) * half;
    const long double cx = center.x, cy = center.y, cz = center.z;
    // |p x c|^2 <= R^2 |p|^2, and in front.
    const long double mx = py * cz - cy, my = cx - px * cz, mz = px * cy - py * cx;
    const long double along = px * cx + py * cy + cz;
    return along > 0 && mx * mx + my * my + mz * mz <=
                            static_cast<long double>(radius) * radius * (px * px + py * py + 1);
  }
};

TEST(Hard, E1_ExtremeFieldsOfView) {
  for (const Precision p : kScalars) {
    int off = 0, not_numbers = 0;
    for (const double fov : {1e-6, 1e-3, 1.0, 60.0, 120.0, 170.0, 179.0, 179.9, 179.99}) {
      const double half = tan_deg(fov / 2);
      // Seen around (0.4, 0.2) of the way to the edge; the size in the picture is that of the view.
      FovCase ball{8 * normalized(Vec3d(0.4 * half, 0.2 * half, 1)), 0};
      const Vec3d edge = 8 * normalized(Vec3d(0.8 * half, 0.2 * half, 1));
      ball.radius = length(edge - ball.center) / 2;
      const int side = side_for(80);
      SceneBuilder b;
      b.add(Sphere{ball.center, ball.radius}, b.material(Black{}, Rgbd(1)));
      set_size(b, side);
      b.look({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, fov);
      const std::vector<double> rgb = pixels(b.scene, p);
      int seen_pixels = 0;
      for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
          const double value =
              rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
                       static_cast<std::size_t>(x))];
          not_numbers += std::isnan(value);
          const bool expected = ball.hits(x, y, side, fov);
          seen_pixels += expected;
          // Within a pixel of the silhouette either is right.
          bool at_edge = false;
          for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx)
              at_edge = at_edge || ball.hits(x + dx, y + dy, side, fov) != expected;
          }
          off += !at_edge && (value > 0) != expected;
        }
      }
      EXPECT_GT(seen_pixels, 20) << fov;
    }
    figure("E1", name_of(p), "pixels off the silhouette, 1e-6 to 179.99 degrees", off, 0);
    figure("E1", name_of(p), "NaNs", not_numbers, 0);
  }
}

TEST(Hard, E2_CamerasWithoutADirection) {
  const char* texts[] = {
      "#scn 1\ncamera perspective { position <1, 2, 3>  look_at <1, 2, 3> }\n",
      "#scn 1\ncamera perspective { position <0, 5, 0>  look_at <0, 0, 0>  up <0, 1, 0> }\n",
      "#scn 1\ncamera perspective { position <0, 5, 0>  look_at <0, 0, 0>  up <0, 0, 0> }\n",
      "#scn 1\ncamera orthographic { position <0, 5, 0>  look_at <0, 0, 0>  up <0, -3, 0> }\n"};
  int without_error = 0;
  for (const char* text : texts) {
    const test::FrontEnd checked = test::check("camera.scn", text, {});
    const std::string errors = checked.errors();
    without_error += errors.find("camera.scn:2:") == std::string::npos;
    EXPECT_NE(errors, "") << text;
  }
  figure("E2", "double", "cameras without a direction and without an error at their line",
         without_error, 0);
}

// A picture that is its own mirror image, and one that becomes the other when the scene does.
SceneBuilder lopsided(double sign) {
  SceneBuilder b;
  b.scene.background.source = GradientBackground{{{-1, Rgbd(0.1)}, {1, Rgbd(0.3, 0.5, 0.9)}}};
  b.add(Plane{{0, 1, 0}, -1}, b.diffuse(0.8));
  b.add(Sphere{{-1.2 * sign, 0, 1}, 1}, b.glass(1.5, Rgbd(0.1, 0.3, 0.6)));
  b.add(Sphere{{1.3 * sign, 0, 1.5}, 1}, b.mirror(0.9));
  const double left = 0.1 * sign, right = 0.7 * sign;
  b.add(Box{{std::min(left, right), -1, -0.5}, {std::max(left, right), -0.3, 0.2}}, b.diffuse(0.5));
  b.add(Cylinder{{2.2 * sign, -1, 0}, {2.2 * sign, 1, 0}, 0.3, true}, b.diffuse(0.6));
  b.light(PointLight{{4 * sign, 6, -4}, Rgbd(90), Falloff::inverse_square});
  b.scene.settings.max_depth = 6;
  set_size(b, side_for(48));
  b.look({0, 0.5, -6}, {0, 0, 1}, {0, 1, 0}, 50);
  return b;
}

std::vector<double> flipped(const std::vector<double>& rgb, int side) {
  std::vector<double> result = rgb;
  const auto row = static_cast<std::size_t>(side);
  for (std::size_t y = 0; y < row; ++y) {
    for (std::size_t x = 0; x < row; ++x) {
      for (std::size_t c = 0; c < 3; ++c)
        result[3 * (y * row + x) + c] = rgb[3 * (y * row + row - 1 - x) + c];
    }
  }
  return result;
}

int unequal(const std::vector<double>& a, const std::vector<double>& b) {
  int count = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    count += !(a[i] == b[i]);
  return count;
}

TEST(Hard, E3_MirrorImages) {
  for (const Precision p : kScalars) {
    const SceneBuilder here = lopsided(1), there = lopsided(-1);
    const int side = here.scene.settings.width;
    figure("E3", name_of(p), "values of a mirrored scene unlike those of the mirrored picture",
           unequal(pixels(there.scene, p), flipped(pixels(here.scene, p), side)), 0);
    SceneBuilder even;
    even.background(0.3);
    even.add(Plane{{0, 1, 0}, -1}, even.diffuse(0.8));
    even.add(Sphere{{0, 0, 0.5}, 1}, even.glass(1.5));
    even.add(Sphere{{-1.7, 0, 2}, 1}, even.mirror(0.9));
    even.add(Sphere{{1.7, 0, 2}, 1}, even.mirror(0.9));
    even.light(PointLight{{0, 6, -4}, Rgbd(90), Falloff::inverse_square});
    set_size(even, side_for(49));
    even.look({0, 0.5, -6}, {0, 0, 1}, {0, 1, 0}, 50);
    const std::vector<double> picture = pixels(even.scene, p);
    figure("E3", name_of(p), "values of a symmetric scene unlike their mirror images",
           unequal(picture, flipped(picture, even.scene.settings.width)), 0);
  }
}

// Crops whose tiles lie across those of the whole picture; resuming is rendering another crop.
// What was interrupted is gone on with by crops of what is missing; the program has no other way.
TEST(Hard, E4_CropsAreThePicture) {
  for (const Precision p : kScalars) {
    SceneBuilder b = lopsided(1);
    b.scene.settings.samples = 3;
    b.scene.settings.filter = {FilterKind::mitchell, 2};
    const int side = b.scene.settings.width;
    const std::vector<double> whole = pixels(b.scene, p);
    const int cuts[] = {0, 7, 8, 31, side};
    int different = 0;
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) {
        render::RenderOptions options;
        options.precision = p;
        options.threads = 1 + (i + j) % 3;
        options.crop = {cuts[i], cuts[j], cuts[i + 1] - cuts[i], cuts[j + 1] - cuts[j]};
        const std::vector<double> part = rendered(b.scene, options).picture.rgb;
        for (int y = 0; y < options.crop.height; ++y) {
          for (int x = 0; x < 3 * options.crop.width; ++x) {
            const int from = 3 * ((options.crop.y + y) * side + options.crop.x) + x;
            different += part[static_cast<std::size_t>(3 * y * options.crop.width + x)] !=
                         whole[static_cast<std::size_t>(from)];
          }
        }
      }
    }
    figure("E4", name_of(p), "values of crops unlike those of the whole picture", different, 0);
    int unlike = 0;
    for (const int tile_size : {1, 3, 16, 100}) {
      render::RenderOptions options;
      options.precision = p;
      options.limits.tile_size = tile_size;
      unlike += rendered(b.scene, options).picture.rgb != whole;
    }
    figure("E4", name_of(p), "tile sizes that give another picture", unlike, 0);
  }
}

}  // namespace
}  // namespace alhazen::hard

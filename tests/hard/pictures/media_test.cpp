// tests/hard/pictures: C7 and C8, which solid is where: faces that meet, solids that overlap, a
// camera inside.
#include "hard/pictures/support.h"

namespace alhazen::hard {
namespace {

SceneBuilder in_open_air(double s) {
  SceneBuilder b;
  b.scene.background.source = GradientBackground{{{-1, Rgbd(0.2, 0.1, 0)}, {1, Rgbd(0.4, 0.7, 1)}}};
  b.scene.settings.max_depth = 6;
  set_size(b, side_for(24));
  const Vec3d forward = normalized(Vec3d(0.4, -0.3, 1));
  const Vec3d up = normalized(cross(forward, cross(Vec3d(0, 1, 0), forward)));
  b.look(-4 * s * forward, forward, up, 45);
  return b;
}

std::vector<double> boxes(Precision p, double s, int parts, double turned_deg) {
  SceneBuilder b = in_open_air(s);
  const MaterialId glass = b.glass(1.5, (1 / s) * Rgbd(0.2, 0.1, 0.4));
  const double cuts[] = {-1, 0.25, 1};
  const auto add = [&](Vec3d min, Vec3d max) {
    const auto turn = [&](Shape& shape) {
      shape.world_from_object = rotation(normalized(Vec3d(1, 2, 3)), turned_deg);
    };
    const ShapeId box = b.add(Box{s * min, s * max}, glass);
    if (turned_deg != 0) b.change(box, turn);
  };
  if (parts == 1) add({-1, -1, -1}, {1, 1, 1});
  if (parts == 2) {
    for (int x = 0; x < 2; ++x)
      add({cuts[x], -1, -1}, {cuts[x + 1], 1, 1});
  }
  if (parts == 8) {
    for (int i = 0; i < 8; ++i) {
      const int x = i % 2, y = i / 2 % 2, z = i / 4;
      add({cuts[x], cuts[y], cuts[z]}, {cuts[x + 1], cuts[y + 1], cuts[z + 1]});
    }
  }
  return pixels(b.scene, p);
}

// Water behind a pane: up to the pane, or into it, where the glass has the higher priority.
std::vector<double> water_behind_glass(Precision p, double s, double reach) {
  SceneBuilder b = in_open_air(s);
  b.add(Box{s * Vec3d(-1, -1, -1), s * Vec3d(1, 1, -0.5)}, b.glass(1.5, {}, 1));
  b.add(Box{s * Vec3d(-0.8, -0.8, -0.5 - reach), s * Vec3d(0.8, 0.8, 1)}, b.glass(1.33, {}, 0));
  return pixels(b.scene, p);
}

TEST(Hard, C7_SolidsThatMeet) {
  for (const Precision p : kScalars) {
    int boxes_bad = 0, turned_bad = 0, water_bad = 0;
    for (const double s : sizes(p)) {
      for (const int parts : {2, 8}) {
        boxes_bad += bad_pixels(boxes(p, s, parts, 0), boxes(p, s, 1, 0));
        turned_bad += bad_pixels(boxes(p, s, parts, 29), boxes(p, s, 1, 29));
      }
      water_bad += bad_pixels(water_behind_glass(p, s, 0.2), water_behind_glass(p, s, 0));
    }
    figure("C7", name_of(p), "bad pixels, two and eight boxes against one, all sizes", boxes_bad,
           0);
    figure("C7", name_of(p), "the same, the boxes turned", turned_bad, 0);
    figure("C7", name_of(p), "bad pixels, water into glass against up to glass", water_bad, 0);
  }
}

#if ALHAZEN_HAS_QUAD
// The camera in a ball within a ball, of a common index; a metal ball in sight.
render::Picture inside_of_glass(Precision p, double ior, double k, double sky) {
  SceneBuilder b;
  b.background(sky);
  b.add(Sphere{{0, 0, 0}, 3}, b.glass(ior));
  b.add(Sphere{{0.2, 0.1, 0}, 2}, b.glass(1.5));
  b.add(Sphere{{0.1, 0.2, 1.2}, 0.4}, b.material(Metal{Rgbd(0.2, 1, 1.5), Rgbd(k)}));
  b.scene.settings.max_depth = 3;
  set_size(b, 12);
  b.look({0.05, 0, -0.3}, {0, 0, 1}, {0, 1, 0}, 100);
  render::RenderOptions options;
  options.precision = p;
  return rendered(b.scene, options).picture;
}

TEST(Hard, C8_CameraInsideOfGlass) {
  for (const Precision p : kScalars) {
    double worst = 0;
    int outside_of_range = 0;
    for (const double ior : {1 + 1e-12, 1e-3, 1e6, 1.33}) {
      for (const double k : {0.0, 3.0, 1e6}) {
        const std::vector<double> value = inside_of_glass(p, ior, k, 1).rgb;
        worst = std::max(worst,
                         worst_difference(value, inside_of_glass(Precision::quad, ior, k, 1).rgb));
        for (const double v : value)
          outside_of_range += !(v >= 0 && v <= 1 + 8 * eps_of(p));
      }
    }
    figure("C8", name_of(p), "values outside of [0, 1] in a sky of 1", outside_of_range, 0);
    if (p == Precision::float64) {
      figure("C8", name_of(p), "difference from the picture in quad", worst, 1e-9);
    } else {
      figure_beyond("C8", name_of(p), "difference from the picture in quad", worst, 1e-9, "",
                    "a rounding of float is 6e-8");
    }
  }
}
#else
TEST(Hard, C8_CameraInsideOfGlass) {
  GTEST_SKIP() << "C8: this build has no __float128";
}
#endif

}  // namespace
}  // namespace alhazen::hard

// tests/hard/pictures: B2, the shadow of a ball where it stands on the floor.
#include "hard/pictures/support.h"

namespace alhazen::hard {
namespace {

constexpr double kShadowRadius = 1.118033988749895;  // sqrt(5) / 2, of a light at height 10

SceneBuilder ball_on_floor(double s) {
  SceneBuilder b;
  b.add(Plane{{0, 1, 0}, 0}, b.diffuse(1));
  b.add(Sphere{{0, s, 0}, s}, b.diffuse(1));
  b.light(PointLight{{0, 10 * s, 0}, Rgbd(1), Falloff::none});
  return b;
}

// From above: pixels of the floor that are lit a pixel within the disc, or dark a pixel beyond it.
int wrong_around_the_disc(Precision p, double s) {
  const int side = side_for(101);
  const double pixel = 4.0 / side;
  SceneBuilder b = ball_on_floor(s);
  set_size(b, side);
  b.look({0, 50 * s, 0}, {0, -1, 0}, {0, 0, 1}, 60);
  b.scene.camera.projection = OrthographicCamera{4 * s};
  render::RenderOptions options;
  options.precision = p;
  options.aovs.object_ids = true;
  const render::Picture picture = rendered(b.scene, options).picture;
  int wrong = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
                      static_cast<std::size_t>(x);
      if (picture.objects[at][0].id != 0) continue;
      const double distance = std::hypot((x + 0.5) * pixel - 2, (y + 0.5) * pixel - 2);
      const bool lit = picture.rgb[3 * at] > 0;
      wrong += lit ? distance < kShadowRadius - pixel : distance > kShadowRadius + pixel;
    }
  }
  return wrong;
}

// Through the wedge between ball and floor at the point where they touch: `zoom` times closer than
// the first of these pictures. All of it is in the shadow, so every lit pixel is a leak.
int lit_at_the_contact(Precision p, double s, double zoom) {
  SceneBuilder b = ball_on_floor(s);
  set_size(b, side_for(61));
  const double away = 0.4 / zoom;  // the ball is away^2 / 2 above the floor here
  const Vec3d eye(0, away * away / 4, -away);
  const Vec3d forward = normalized(Vec3d(0, -eye.y, away));
  b.look(s * eye, forward, cross(forward, Vec3d(1, 0, 0)), 60);
  int lit = 0;
  const std::vector<double> rgb = pixels(b.scene, p);
  for (std::size_t i = 0; i < rgb.size(); i += 3)
    lit += !(rgb[i] == 0);
  return lit;
}

TEST(Hard, B2_ContactShadow) {
  for (const Precision p : kScalars) {
    int wrong = 0, leaks = 0;
    for (const double s : sizes(p)) {
      wrong += wrong_around_the_disc(p, s);
      for (const double zoom : {1.0, 10.0, 100.0})
        leaks += lit_at_the_contact(p, s, zoom);
    }
    figure("B2", name_of(p), "pixels on the wrong side of the shadow's edge, all sizes", wrong, 0);
    figure("B2", name_of(p), "lit pixels at the contact, all sizes", leaks, 0);
  }
}

}  // namespace
}  // namespace alhazen::hard

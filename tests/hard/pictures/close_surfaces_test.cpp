// tests/hard/pictures: B3 and B4, surfaces that nearly or exactly coincide.
#include "core/math/elementary.h"
#include "hard/pictures/support.h"
#include "render/surface/fresnel.h"

namespace alhazen::hard {
namespace {

constexpr double kGaps[] = {1e-1, 1e-3, 9e-5, 1e-5, 1e-8, 1e-10, 1e-12, 1e-14};

// Pixels that are not exactly 1024 / 2^8 behind four shells that each halve the light twice.
int wrong_behind_shells(Precision p, double s, double gap) {
  SceneBuilder b;
  b.background(1024);
  PovFinish half;
  half.color = b.color(Rgbd(1));
  half.transmit = 0.5;
  half.ambient = Rgbd(0);
  half.diffuse = 0;
  const MaterialId worn = b.material(half);
  for (int i = 0; i < 4; ++i)
    b.add(Sphere{{0, 0, 0}, s * (1 - i * gap)}, worn);
  set_size(b, side_for(24));
  b.look({0, 0, -4 * s}, {0, 0, 1}, {0, 1, 0}, 12);  // within 0.6 of the centre: through all four
  int wrong = 0;
  for (const double value : pixels(b.scene, p))
    wrong += value != 4;
  return wrong;
}

TEST(Hard, B3_FourShells) {
  for (const Precision p : kScalars) {
    const double ulp = 2 * eps_of(p);  // of the radius 1
    int apart = 0, merged = 0, count = 0;
    for (const double s : sizes(p)) {
      for (const double gap : kGaps) {
        if (gap >= 16 * ulp) apart += wrong_behind_shells(p, s, gap);
      }
      apart += wrong_behind_shells(p, s, 16 * ulp);
      merged += wrong_behind_shells(p, s, ulp) + wrong_behind_shells(p, s, 0);
      ++count;
    }
    figure("B3", name_of(p), "values that are not exactly 4, gaps from 16 ulp to 0.1", apart, 0);
    figure_beyond("B3", name_of(p), "share of wrong values, gaps of one ulp and of none",
                  merged / (2.0 * count * 3 * side_for(24) * side_for(24)), 0, "",
                  "the start of a ray is off its shell by as much, and may lie behind the next");
  }
}

// Pixels that a box of index 1, a gap above the floor, changes.
int changed_by_invisible_box(Precision p, double s, double gap, double turned_deg) {
  const auto picture = [=](bool with_box) {
    SceneBuilder b;
    b.background(0.5);
    b.add(Plane{{0, 1, 0}, 0}, b.diffuse(0.9));
    if (with_box) {
      const ShapeId box = b.add(Box{s * Vec3d(-1, gap, -1), s * Vec3d(1, 1, 1)}, b.glass(1));
      const auto turn = [&](Shape& shape) {
        shape.world_from_object = rotation({0, 1, 0}, turned_deg);
      };
      if (turned_deg != 0) b.change(box, turn);
    }
    b.light(PointLight{s * Vec3d(1, 5, -2), s * s * Rgbd(20), Falloff::inverse_square});
    set_size(b, side_for(48));
    b.look(s * Vec3d(0, 2, -5), normalized(Vec3d(0, -0.3, 1)), normalized(Vec3d(0, 1, 0.3)), 50);
    return pixels(b.scene, p);
  };
  return bad_pixels(picture(true), picture(false));
}

TEST(Hard, B4_BoxOverFloor) {
  for (const Precision p : kScalars) {
    int bad = 0, turned = 0;
    for (const double s : sizes(p)) {
      for (const double gap : kGaps) {
        bad += changed_by_invisible_box(p, s, gap, 0);
      }
      bad += changed_by_invisible_box(p, s, 0, 0);
      turned += changed_by_invisible_box(p, s, 0, 17) + changed_by_invisible_box(p, s, 1e-14, 33.3);
    }
    figure("B4", name_of(p), "bad pixels over a floor, gaps from 0 to 0.1, all sizes", bad, 0);
    figure("B4", name_of(p), "the same, the box turned about the floor's normal", turned, 0);
  }
}

// A red ball glows in a glass that is a gap larger. Every ray that meets the glass meets the ball,
// which reflects nothing: the picture is 1 - F of the angle on the glass.
double worst_of_ball_in_glass(Precision p, double s, double gap, int& bad) {
  SceneBuilder b;
  b.add(Sphere{{0, 0, 0}, s * (1 + gap)}, b.glass(1.5));
  b.add(Sphere{{0, 0, 0}, s}, b.material(Black{}, Rgbd(1, 0, 0)));
  const int side = side_for(33);
  const double width = 2 * (1 + gap);
  set_size(b, side);
  b.look({0, 0, -4 * s}, {0, 0, 1}, {0, 1, 0}, 60);
  b.scene.camera.projection = OrthographicCamera{width * s};
  const std::vector<double> rgb = pixels(b.scene, p);
  double worst = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double sine = 2 * std::hypot((x + 0.5) / side - 0.5, (y + 0.5) / side - 0.5);
      if (sine > 0.99) continue;  // near the rim F turns the rounding of the angle into much more
      const double cosine = std::sqrt((1 - sine) * (1 + sine));
      const double expected = render::dielectric_interface(cosine, 1 / 1.5).transmittance;
      const double error =
          std::abs(rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
                            static_cast<std::size_t>(x))] -
                   expected);
      bad += !(error <= 1.0 / 255);
      worst = error <= worst ? worst : error;
    }
  }
  return worst;
}

TEST(Hard, B4_RedBallInGlass) {
  for (const Precision p : kScalars) {
    // Gaps of which the scalar type knows: an ulp of the ball's distance, 4, is 8 eps.
    const double smallest = 64 * eps_of(p);
    int bad = 0, merged = 0;
    double worst = 0;
    for (const double s : sizes(p)) {
      for (const double gap : {1e-2, 4e-5, 1e-8, 1e-12, 1e-14}) {
        if (gap >= smallest) worst = std::max(worst, worst_of_ball_in_glass(p, s, gap, bad));
      }
      worst_of_ball_in_glass(p, s, 0, merged);
    }
    figure("B4", name_of(p), "bad pixels of a red ball in glass, gaps from 64 eps to 0.01", bad, 0);
    // dF/dcos is below 4 up to here, and the cosine, at least 0.14, is known to 2 eps / 0.14.
    figure("B4", name_of(p), "the same: difference from 1 - F", worst / eps_of(p), 64, "eps");
    figure_beyond(
        "B4", name_of(p), "the same without a gap: share of bad pixels",
        static_cast<double>(merged) / static_cast<double>(sizes(p).size()) /
            (side_for(33) * side_for(33)),
        0, "", "of two equal curved surfaces a ray that starts on one may be inside of the other");
  }
}

}  // namespace
}  // namespace alhazen::hard

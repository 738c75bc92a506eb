// tests: glossy lobes: their albedo by quadrature, and what happens when view and light change
// places.
#include "render/surface/highlight.h"

#include <random>

#include "unit/render/measured.h"

namespace alhazen::render {
namespace {

using test::Worst;

Vec3d direction(double polar_deg, double turns) {
  const SinCos<double> turn = sin_cos_of_turns(turns);
  return {sin_deg(polar_deg) * turn.cos, sin_deg(polar_deg) * turn.sin, cos_deg(polar_deg)};
}

Vec3d in_frame(Vec3d axis, double cosine, double turns) {
  const Vec3d side = normalized(cross(axis, Vec3d(0.3, 0.9, -0.31)));
  const SinCos<double> turn = sin_cos_of_turns(turns);
  const double sine = std::sqrt((1 - cosine) * (1 + cosine));
  return cosine * axis + sine * turn.cos * side + sine * turn.sin * cross(axis, side);
}

// The integral of f cos by the midpoint rule in variables that follow the lobe: the cosine of its
// angle is distributed as cos^m, around the mirrored view for Phong and as half vectors for Blinn.
double directional_albedo(HighlightModel model, double m, double view_deg) {
  constexpr int kSteps = 250;
  const Vec3d normal(0, 0, 1), view = direction(view_deg, 0.1);
  const auto lobe = make_highlight_lobe<double>({model, Rgbd(1), m});
  const Vec3d mirrored(-view.x, -view.y, view.z);
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double cosine = std::pow((i + 0.5) / kSteps, 1 / (m + 1));
    const double density = (m + 1) / (2 * pi<double>()) * std::pow(cosine, m);
    for (int j = 0; j < kSteps; ++j) {
      const double turns = (j + 0.5) / kSteps;
      Vec3d light;
      double jacobian = 1;
      if (model == HighlightModel::phong) {
        light = in_frame(mirrored, cosine, turns);
      } else {
        const Vec3d half = in_frame(normal, cosine, turns);
        jacobian = 4 * dot(view, half);
        if (jacobian <= 0) continue;
        light = 2 * dot(view, half) * half - view;
      }
      sum +=
          highlight_value(lobe, normal, view, light).r * larger(0.0, light.z) * jacobian / density;
    }
  }
  return sum / kSteps / kSteps;
}

TEST(Highlight, ReflectsAtMostItsStrength) {
  for (const HighlightModel model : {HighlightModel::phong, HighlightModel::blinn}) {
    const char* name = model == HighlightModel::phong ? "Phong" : "Blinn";
    // The midpoint rule with 250 x 250 steps is good to 2e-4 where the horizon cuts the lobe.
    Worst at_normal(std::string(name) + ": |albedo - 1| for a view along the normal", 2e-4);
    Worst excess(std::string(name) + ": albedo - 1 for any view", 2e-4);
    for (const double m : {1.0, 2.0, 3.5, 10.0, 40.0, 1000.0}) {
      at_normal.add(std::fabs(directional_albedo(model, m, 0) - 1));
      for (const double view : {5.0, 15.0, 30.0, 45.0, 60.0, 75.0, 85.0, 89.5})
        excess.add(larger(0.0, directional_albedo(model, m, view) - 1));
    }
  }
}

TEST(Highlight, ViewAndLightMayChangePlaces) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal_deviate;
  const auto draw = [&] {
    return normalized(
        Vec3d(normal_deviate(random), normal_deviate(random), normal_deviate(random)));
  };
  for (const HighlightModel model : {HighlightModel::phong, HighlightModel::blinn}) {
    const auto lobe = make_highlight_lobe<double>({model, Rgbd(0.1, 0.2, 0.3), 7});
    int lit = 0;
    for (int i = 0; i < 10000; ++i) {
      const Vec3d n = draw(), a = draw(), b = draw();
      const Rgbd value = highlight_value(lobe, n, a, b);
      ASSERT_EQ(value, highlight_value(lobe, n, b, a));
      if (!is_black(value)) ++lit;
      const bool seen_by_both = dot(n, a) > 0 && dot(n, b) > 0;
      ASSERT_TRUE(seen_by_both || is_black(value));
    }
    EXPECT_GT(lit, 1000);
  }
}

TEST(Highlight, PeaksInTheMirrorDirection) {
  const Vec3d normal(0, 0, 1), view = direction(30, 0), mirrored(-view.x, -view.y, view.z);
  for (const HighlightModel model : {HighlightModel::phong, HighlightModel::blinn}) {
    const auto lobe = make_highlight_lobe<double>({model, Rgbd(0.5), 20});
    const double peak = highlight_value(lobe, normal, view, mirrored).r;
    EXPECT_NEAR(peak, lobe.scale.r, 1e-12);
    EXPECT_LT(highlight_value(lobe, normal, view, direction(31, 0.5)).r, peak);
  }
}

}  // namespace
}  // namespace alhazen::render

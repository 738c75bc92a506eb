// tests/hard/pictures: C4 to C6, slabs, prisms and balls of glass against their closed forms.
#include "core/math/elementary.h"
#include "hard/pictures/support.h"
#include "render/surface/refract.h"

namespace alhazen::hard {
namespace {

constexpr double kNormalReflectance = 0.04;  // ((1.5 - 1) / (1.5 + 1))^2

template <class Real>
constexpr Precision kPrecisionOf = sizeof(Real) == sizeof(float) ? Precision::float32
                                                                 : Precision::float64;

template <class Real>
Vec3<Real> refracted_at(Vec3<Real> direction, Vec3<Real> normal, Real eta) {
  if (dot(direction, normal) > 0) normal = -normal;
  const auto interface = render::dielectric_interface(-dot(direction, normal), eta);
  EXPECT_FALSE(interface.total_reflection);
  return render::refracted(direction, normal, eta, interface);
}

// Leaving, the error of cos i is that of cos^2 over cos i: errors are taken times cos i.
template <class Real>
void slab() {
  const Precision p = kPrecisionOf<Real>;
  double direction = 0, shift = 0;
  for (int tenth = 0; tenth < 895; ++tenth) {
    const double sine = sin_deg(tenth / 10.0), cosine = cos_deg(tenth / 10.0);
    const Vec3<Real> d(Vec3d(sine, -cosine, 0)), normal(Real(0), Real(1), Real(0));
    const Real n = Real(1.5);
    const Vec3<Real> inside = refracted_at(d, normal, 1 / n);
    const Vec3<Real> out = refracted_at(inside, normal, n);
    direction = std::max(direction, static_cast<double>(length(out - d)) * cosine);
    const Vec3d through = Vec3d(inside) / -static_cast<double>(inside.y);
    const double measured = std::abs(through.x * -cosine - through.y * sine);
    const double expected = sine * (1 - cosine / std::sqrt(2.25 - sine * sine));
    shift = std::max(shift, std::abs(measured - expected));
  }
  figure("C4", name_of(p), "slab: |exit - entry| cos i", direction / eps_of(p), 8, "eps");
  figure("C4", name_of(p), "slab: parallel shift", shift / eps_of(p), 8, "eps");
}

// The least deviation, of the symmetric path: 2 asin(n sin(A/2)) - A. It is stationary there, so
// only the rounding of the directions themselves is seen.
template <class Real>
void prism() {
  const Precision p = kPrecisionOf<Real>;
  const double apex = 60, symmetric = asin_deg(1.5 * sin_deg(apex / 2));
  const Vec3<Real> left(Vec3d(-cos_deg(apex / 2), sin_deg(apex / 2), 0));
  const Vec3<Real> right(Vec3d(cos_deg(apex / 2), sin_deg(apex / 2), 0));
  const double heading = symmetric - apex / 2;
  const Vec3<Real> d(Vec3d(cos_deg(heading), sin_deg(heading), 0));
  const Real n = Real(1.5);
  const Vec3<Real> out = refracted_at(refracted_at(d, left, 1 / n), right, n);
  const Vec3d expected(cos_deg(heading), -sin_deg(heading), 0);
  figure("C4", name_of(p), "prism: direction at least deviation",
         length(Vec3d(out) - expected) / eps_of(p), 8, "eps");
}

// The same in a picture: through a slab onto a ruler, a surface whose albedo is its x coordinate.
void slab_before_a_ruler(Precision p) {
  const auto value = [p](double angle_deg, bool ruler) {
    SceneBuilder b;
    b.light(AmbientLight{Rgbd(1)});
    b.add(Box{{-900, -1, -900}, {900, 0, 900}}, b.glass(1.5));
    b.scene.textures.push_back(
        {GradientPattern{{{0, Rgbd(ruler ? 0 : 1)}, {1, Rgbd(1)}}}, Mapping::world, Affined(), {}});
    const auto texture = static_cast<TextureId>(b.scene.textures.size() - 1);
    b.add(Plane{{0, 1, 0}, -1.25}, b.material(Diffuse{texture, {}}));
    b.scene.settings.max_depth = 2;
    const Vec3d forward(sin_deg(angle_deg), -cos_deg(angle_deg), 0);
    // From where the path without the slab would end at x = 1.
    const Vec3d target(1, -1.25, 0);
    return seen(b, target - 2 / cos_deg(angle_deg) * forward, forward, {-forward.y, forward.x, 0},
                p);
  };
  double worst = 0;
  for (int degrees = 0; degrees < 60; degrees += 3) {
    const double sine = sin_deg(degrees), cosine = cos_deg(degrees);
    const double shift = sine * (1 - cosine / std::sqrt(2.25 - sine * sine));
    const double expected = 1 - shift / cosine;  // the shift is across the ray
    worst = std::max(worst, std::abs(value(degrees, true) / value(degrees, false) - expected));
  }
  // Coordinates up to 4 times the ruler's length add up.
  figure("C4", name_of(p), "slab seen in pictures: shift on a ruler", worst / eps_of(p), 32, "eps");
}

TEST(Hard, C4_SlabAndPrism) {
  slab<double>();
  slab<float>();
  prism<double>();
  prism<float>();
  for (const Precision p : kScalars)
    slab_before_a_ruler(p);
}

// Along the axis of a ball each face reflects R. What leaves forward after 2 m reflections inside
// adds (1 - R)^2 R^(2m); with a sky that is 1 ahead and 0 behind, that is the picture.
TEST(Hard, C5_ThroughTheCentre) {
  for (const Precision p : kScalars) {
    double worst = 0;
    for (const double absorption : {0.0, 0.35}) {
      for (const int depth : {1, 2, 3, 4, 8, 16, 40}) {
        SceneBuilder b;
        b.scene.background.source = GradientBackground{{{-1, Rgbd(0)}, {1, Rgbd(1)}}};
        b.add(Sphere{{0, 0, 0}, 1}, b.glass(1.5, Rgbd(absorption)));
        b.scene.settings.max_depth = depth;
        const double r = kNormalReflectance, once = std::exp(-2 * absorption);
        double expected = 0, inside = (1 - r) * once;
        for (int meeting = 2; meeting <= depth; ++meeting) {
          if (meeting % 2 == 0) expected += inside * (1 - r);
          inside *= r * once;
        }
        const double value = seen(b, {0, -5, 0}, {0, 1, 0}, {0, 0, 1}, p);
        worst = std::max(worst, std::abs(value - expected));
        if (depth == 40 && absorption == 0) {
          worst = std::max(worst, std::abs(value - 0.92307692307692308));
        }
      }
    }
    if (p == Precision::float64) {
      figure("C5", name_of(p), "partial sums, T = (1-F)/(1+F), Beer's law", worst, 1e-14);
    } else {
      figure("C5", name_of(p), "partial sums, T = (1-F)/(1+F), Beer's law", worst / eps_of(p), 16,
             "eps");
    }
  }
}

// A ball of glass in an even sky of 1: all of its light comes back but what is inside after the
// last meeting, (1 - F) F^(N-1), of the angle at which the pixel's ray meets it.
double worst_in_furnace(Precision p, int depth) {
  SceneBuilder b;
  b.background(1);
  b.add(Sphere{{0, 0, 0}, 1}, b.glass(1.5));
  b.scene.settings.max_depth = depth;
  const int side = side_for(32);
  set_size(b, side);
  b.look({0, 0, -4}, {0, 0, 1}, {0, 1, 0}, 60);
  b.scene.camera.projection = OrthographicCamera{2.5};
  const std::vector<double> rgb = pixels(b.scene, p);
  double worst = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double sine = 2.5 * std::hypot((x + 0.5) / side - 0.5, (y + 0.5) / side - 0.5);
      double expected = 1;
      if (sine < 1) {
        const auto top = render::dielectric_interface(std::sqrt((1 - sine) * (1 + sine)), 1 / 1.5);
        expected -= top.transmittance * std::pow(top.reflectance, depth - 1);
      }
      const double error =
          std::abs(rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
                            static_cast<std::size_t>(x))] -
                   expected);
      worst = error <= worst ? worst : error;
    }
  }
  return worst;
}

TEST(Hard, C6_WhiteFurnace) {
  for (const Precision p : kScalars) {
    double worst = 0;
    for (const int depth : {2, 8, 200})
      worst = std::max(worst, worst_in_furnace(p, depth));
    SceneBuilder b;
    b.background(1);
    b.add(Sphere{{0, 0, 0}, 1}, b.mirror(1));
    b.add(Sphere{{2, 0.3, 0.5}, 1}, b.mirror(1));
    b.scene.settings.max_depth = 200;
    set_size(b, side_for(32));
    b.look({1, 0, -5}, {0, 0, 1}, {0, 1, 0}, 50);
    double mirrors = 0;
    for (const double value : pixels(b.scene, p))
      mirrors = std::max(mirrors, std::abs(value - 1));
    figure("C6", name_of(p), "mirrors in an even sky", mirrors, 0);
    if (p == Precision::float64) {
      figure("C6", name_of(p), "glass in an even sky against 1 - the truncated tail", worst, 1e-12);
    } else {
      figure_beyond("C6", name_of(p), "glass in an even sky against 1 - the truncated tail", worst,
                    1e-12, "", "a rounding of float is 6e-8");
    }
  }
}

}  // namespace
}  // namespace alhazen::hard

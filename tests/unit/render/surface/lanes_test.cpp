// tests: what surfaces do to light, on lanes and for single numbers: the same bits.
#include "render/surface/absorption.h"
#include "render/surface/coat.h"
#include "render/surface/fresnel.h"
#include "render/surface/highlight.h"
#include "render/surface/pov_finish.h"
#include "render/surface/refract.h"
#include "unit/render/lanes_agree.h"

namespace alhazen::render {
namespace {

// Grazing, normal, rounded beyond normal.
const std::vector<double> kCosines{0, 1e-300, 1e-20, 1e-9, 0.5, 1.0000000000000002, 1};
// No step of index, steps of a rounding, total reflection, extreme ones.
const std::vector<double> kEtas{0.3, 1, 0.9999999999999999, 1.0000000000000002, 1.5, 1e-6, 3};

template <class Real>
Vec3<Real> unit_vector(Real z, Real u) {
  const SinCos<Real> turn = sin_cos_of_turns(u);
  const Real sine = square_root(larger(Real(0), (1 - z) * (1 + z)));
  return {sine * turn.cos, sine * turn.sin, z};
}

const auto kCosineAndEta = [](int i, int j) { return drawn_from(j == 0 ? kCosines : kEtas, i, j); };

TEST(SurfaceLanes, Dielectric) {
  expect_all_lanes_agree<2>(kCosineAndEta, [](auto& out, const auto& in) {
    const auto met = dielectric_interface(in[0], in[1]);
    for (const auto x : {met.reflectance, met.transmittance, met.cos_transmitted, met.bend})
      put(out, x);
    put_mask(out, met.total_reflection);
  });
}

TEST(SurfaceLanes, Conductor) {
  const std::vector<double> indices{0, 1e-20, 1, 0.2, 4}, absorptions{0, 1e-20, 3, 7};
  expect_all_lanes_agree<3>(
      [&](int i, int j) {
        return drawn_from(j == 0 ? kCosines : j == 1 ? indices : absorptions, i, j);
      },
      [](auto& out, const auto& in) { put(out, conductor_reflectance(in[0], in[1], in[2])); });
}

TEST(SurfaceLanes, Absorption) {
  const std::vector<double> lengths{0, 1e-300, infinity<double>(), 1, 50};
  const std::vector<double> absorptions{0, 1e-300, 1, 0, 4};
  expect_all_lanes_agree<4>(
      [&](int i, int j) {
        return j == 0 ? std::fabs(drawn_from(lengths, i, j)) : drawn_from(absorptions, i, j);
      },
      [](auto& out, const auto& in) {
        put(out, transmitted_share({in[1], in[2], in[3]}, in[0]));
      });
}

TEST(SurfaceLanes, MirroredAndRefracted) {
  expect_all_lanes_agree<6>([](int i, int j) { return j < 2 ? kCosineAndEta(i, j) : drawn(i, j); },
                            [](auto& out, const auto& in) {
                              const auto normal = unit_vector(2 * in[2] - 1, in[3]);
                              const auto direction = unit_vector(2 * in[4] - 1, in[5]);
                              const auto met = dielectric_interface(in[0], in[1]);
                              put(out, reflected(direction, normal));
                              put(out, refracted(direction, normal, in[1], met));
                            });
}

// Three layers, one of them clear, so that lanes disagree about what has to be computed.
template <class L>
CoatLayer<L> some_layer(const L& which) {
  using T = ScalarOf<L>;
  const auto layer = [](double ior, Rgbd absorption) {
    Coat coat;
    coat.ior = ior;
    coat.absorption = absorption;
    return make_coat_layer<T>(coat);
  };
  static const std::vector<CoatLayer<T>> layers{layer(1.5, {}), layer(1.33, {0.1, 0, 2}),
                                                layer(2, {1, 1, 1})};
  return gathered<L, CoatLayer>(layers.data(), static_cast<IntOf<L>>(which));
}

TEST(SurfaceLanes, Coat) {
  expect_all_lanes_agree<6>(
      [](int i, int j) {
        if (j == 0) return std::floor(3 * drawn(i, j));
        return j < 3 ? drawn_from({1e-9, 0.5, 1}, i, j) : drawn_from({0, 1}, i, j);
      },
      [](auto& out, const auto& in) {
        const auto layer = some_layer(in[0]);
        put(out, coat_mirror_reflectance(layer, in[1]));
        put(out, coat_diffuse_value(layer, {in[3], in[4], in[5]}, in[1], in[2]));
        put(out, coat_diffuse_albedo(layer, {in[3], in[4], in[5]}, in[1]));
      });
}

template <class L>
HighlightLobe<L> some_lobe(const L& which) {
  using T = ScalarOf<L>;
  const auto lobe = [](HighlightModel model, double exponent) {
    return make_highlight_lobe<T>({model, Rgbd(0.1, 0.2, 0.3), exponent});
  };
  static const std::vector<HighlightLobe<T>> lobes{
      lobe(HighlightModel::phong, 1), lobe(HighlightModel::blinn, 20),
      lobe(HighlightModel::phong, 300), lobe(HighlightModel::blinn, 0.5)};
  return gathered<L, HighlightLobe>(lobes.data(), static_cast<IntOf<L>>(which));
}

TEST(SurfaceLanes, Highlight) {
  expect_all_lanes_agree<7>(
      [](int i, int j) {
        return j == 0 ? std::floor(4 * drawn(i, j)) : drawn_from({0, 1}, i, j);
      },
      [](auto& out, const auto& in) {
        put(out,
            highlight_value(some_lobe(in[0]), unit_vector(2 * in[1] - 1, in[2]),
                            unit_vector(2 * in[3] - 1, in[4]), unit_vector(2 * in[5] - 1, in[6])));
      });
}

// Finishes that differ in everything that is asked of them.
std::vector<PovFinish> finishes() {
  PovFinish plain, shiny, clear;
  shiny.phong = 0.7;
  shiny.phong_size = 80;
  shiny.specular = 0.4;
  shiny.roughness = 0.02;
  shiny.metallic = 1;
  shiny.brilliance = 2.5;
  shiny.reflection.min = Rgbd(0.1);
  shiny.reflection.max = Rgbd(0.9);
  shiny.reflection.falloff = 3;
  shiny.reflection.metallic = 0.5;
  clear.filter = 0.9;
  clear.phong = 0.3;
  clear.reflection.max = Rgbd(1);
  clear.reflection.fresnel = true;
  clear.fade_distance = 2;
  clear.fade_power = 2;
  clear.fade_color = {1, 0.5, 0.2};
  PovFinish exponential = clear;
  exponential.fade_power = 1000;
  return {plain, shiny, clear, exponential};
}

template <class L>
PovSurface<L> some_finish(const L& which) {
  using T = ScalarOf<L>;
  static const std::vector<PovSurface<T>> surfaces = [] {
    std::vector<PovSurface<T>> made;
    for (const PovFinish& finish : finishes())
      made.push_back(make_pov_surface<T>(finish));
    return made;
  }();
  return gathered<L, PovSurface>(surfaces.data(), static_cast<IntOf<L>>(which));
}

TEST(SurfaceLanes, PovFinish) {
  expect_all_lanes_agree<10>(
      [](int i, int j) {
        return j == 0 ? std::floor(4 * drawn(i, j)) : drawn_from({0, 1}, i, j);
      },
      [](auto& out, const auto& in) {
        using Real = std::decay_t<decltype(in[0])>;
        const auto surface = some_finish(in[0]);
        const Rgb<Real> color(in[1], in[2], in[3]);
        const Vec3<Real> normal(Real(0), Real(0), Real(1));
        put(out, pov_diffuse(surface.shading, color, in[4]));
        put(out, pov_highlights(surface.shading, color, normal, unit_vector(in[5], in[6]),
                                unit_vector(in[4], in[7])));
        put(out, pov_reflectance(surface.mirror, color, in[4], in[8]));
        put(out, pov_rest(pov_reflectance(surface.mirror, color, in[4], in[8])));
        put(out, pov_passed(surface.passage, color));
        put(out, select(surface.passage.fades != Real(0), pov_fade(surface.fading, 5 * in[9]),
                        Rgb<Real>()));
      });
}

}  // namespace
}  // namespace alhazen::render

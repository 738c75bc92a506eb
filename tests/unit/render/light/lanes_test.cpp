// tests: lights on lanes and for single points: the same bits, from every side of every light.
#include "render/light/directional_light.h"
#include "render/light/point_light.h"
#include "render/light/rectangle_light.h"
#include "render/light/sphere_light.h"
#include "render/light/spot_light.h"
#include "unit/render/lanes_agree.h"

namespace alhazen::render {
namespace {

template <class Real>
void put_sample(Numbers<Real>& to, const LightSample<Real>& sample) {
  put(to, sample.direction);
  to.push_back(sample.distance);
  put(to, sample.weight);
}

// Points around the origin, often exactly on it or on a plane of the axes; then u and v.
double argument(int i, int j) {
  if (j < 3) return drawn_from({-2, 0, 1, 0, 1e-9, -1e-9, 100, -100, 2}, i, j);
  return drawn_from({0, 0.5, 0.99999994}, i, j);
}

// Checks sample(point) of a kernel in every scalar type, as `make<T>()` makes it.
template <class Make>
void expect_point_samples_agree(const Make& make) {
  expect_all_lanes_agree<3>(argument, [&](auto& out, const auto& in) {
    using Real = std::decay_t<decltype(in[0])>;
    const auto kernel = make(ScalarOf<Real>());
    put_sample(out, kernel.sample(Vec3<Real>(in[0], in[1], in[2])));
  });
}

TEST(LightLanes, Points) {
  for (const Falloff falloff : {Falloff::none, Falloff::inverse_square}) {
    expect_point_samples_agree([falloff](auto zero) {
      return PointLightKernel<decltype(zero)>({{0, 0, 0}, {3, 2, 1}, falloff}, {});
    });
  }
}

TEST(LightLanes, Spots) {
  for (const double inner : {10.0, 30.0}) {  // a soft edge and a hard one
    expect_point_samples_agree([inner](auto zero) {
      const SpotLight light{{0, 0, 0}, {0, -1, 0}, {3, 2, 1}, inner, 30, Falloff::inverse_square};
      return SpotLightKernel<decltype(zero)>(light, {});
    });
  }
}

TEST(LightLanes, Directionals) {
  const DirectionalLightKernel<float> light(DirectionalLight{{0.6, -0.8, 0}, {1, 2, 3}});
  const auto one = light.sample();
  const auto all = light.sample<Lanes<float, 8>>();
  for (int lane = 0; lane < 8; ++lane) {
    EXPECT_EQ(all.direction.x[lane], one.direction.x);
    EXPECT_EQ(all.distance[lane], one.distance);
    EXPECT_EQ(all.weight.b[lane], one.weight.b);
  }
}

// Checks samples of a light seen from points; `make` gives its kernel.
template <template <class> class View, class Make>
void expect_area_samples_agree(const Make& make) {
  expect_all_lanes_agree<5>(argument, [&](auto& out, const auto& in) {
    using Real = std::decay_t<decltype(in[0])>;
    const auto kernel = make(ScalarOf<Real>());
    const View<Real> view(kernel, {in[0], in[1], in[2]});
    put_sample(out, view.sample(in[3], in[4]));
  });
}

TEST(LightLanes, SpheresFromOutsideAndInside) {
  for (const double radius : {0.5, 1.0, 1e-12, 50.0}) {
    expect_area_samples_agree<SphereLightView>([radius](auto zero) {
      SphereLight light;
      light.center = {0, 0, 0};
      light.radius = radius;
      light.radiance = {1, 2, 3};
      light.samples = 3;
      return SphereLightKernel<decltype(zero)>(light, {});
    });
  }
}

TEST(LightLanes, RectanglesNearAndFarInFrontAndBehind) {
  // The last two are no rectangles and lie askew.
  const std::vector<std::pair<Vec3d, Vec3d>> edges{{{2, 0, 0}, {0, 0, 1}},
                                                   {{0, 0, 3}, {4, 0, 0}},
                                                   {{2, 0, 1}, {0, 0, 1}},
                                                   {{1, 1, 0}, {0, 1, 2}}};
  for (const auto& [u, v] : edges) {
    expect_area_samples_agree<RectangleLightView>([&](auto zero) {
      RectangleLight light;
      light.corner = {-0.5, 0, -0.5};
      light.edge_u = u;
      light.edge_v = v;
      light.radiance = {1, 2, 3};
      light.samples = 5;
      return RectangleLightKernel<decltype(zero)>(light, {});
    });
  }
}

// What is known of a light at one point can be handed to lanes that draw several of its samples.
TEST(LightLanes, SightsAreDealtOut) {
  using L = Lanes<double, 4>;
  RectangleLight light;
  light.corner = {-0.5, 1, -0.5};
  light.edge_u = {1, 0, 0};
  light.edge_v = {0, 0, 1};
  light.radiance = {1, 2, 3};
  const RectangleLightKernel<double> kernel(light, {});
  const std::array<double, 4> heights{0, 0.5, 3, -20};
  const L height = L::load(heights.data());
  const RectangleLightView<L> views(kernel, {L(0.1), height, L(0.2)});
  IntOf<L> from = 0;
  from.set(1, 2);
  from.set(2, 2);
  from.set(3, 3);
  const DealtRecords sights(views.sight());
  const auto dealt = RectangleLightView<L>::of(kernel, sights.to(from));
  const LightSample<L> samples = dealt.sample(L(0.25), L(0.75));
  for (int lane = 0; lane < 4; ++lane) {
    const Vec3d point(0.1, heights[static_cast<std::size_t>(from[lane])], 0.2);
    const auto one = RectangleLightView<double>(kernel, point).sample(0.25, 0.75);
    EXPECT_EQ(samples.direction.x[lane], one.direction.x);
    EXPECT_EQ(samples.distance[lane], one.distance);
    EXPECT_EQ(samples.weight.r[lane], one.weight.r);
  }
}

}  // namespace
}  // namespace alhazen::render

// tests: area lights in float and double against their quadruple-precision oracle, sample by
// sample.
#include <random>

#include "render/light/rectangle_light.h"
#include "render/light/sphere_light.h"
#include "unit/render/measured.h"

namespace alhazen::render {
namespace {

#if ALHAZEN_HAS_QUAD
using test::Worst;

template <class Real, template <class> class Kernel, template <class> class View, class Light>
void expect_oracle_samples(const char* name, const Light& light, double bound) {
  const double u = static_cast<double>(ScalarTraits<Real>::unit_roundoff());
  Worst direction(std::string(name) + ": direction", bound, "u");
  Worst weight(std::string(name) + ": weight", bound, "u");
  const Kernel<Real> kernel(light, Vec3d());
  const Kernel<Quad> oracle_kernel(light, Vec3d());
  std::mt19937_64 random(1);
  for (int i = 0; i < 500; ++i) {
    // 24 bits, which every precision holds.
    const auto draw = [&] { return static_cast<double>(random() >> 40) * 0x1p-24; };
    const Vec3d point(draw() - 0.5, 0.25 * draw(), draw() - 0.5);
    const double s = draw(), t = draw();
    const View<Real> view(kernel, Vec3<Real>(point));
    const View<Quad> oracle(oracle_kernel, Vec3<Quad>(point));
    const auto a = view.sample(static_cast<Real>(s), static_cast<Real>(t));
    const auto b = oracle.sample(static_cast<Quad>(s), static_cast<Quad>(t));
    direction.add(static_cast<double>(length(Vec3<Quad>(a.direction) - b.direction)) / u);
    weight.add(static_cast<double>(absolute((Quad(a.weight.r) - b.weight.r) / b.weight.r)) / u);
  }
}

// A light that fills a good part of the sky: the angles of the construction carry the rounding of
// numbers around 1, here magnified by at most ten or so.
TEST(AreaLight, SamplesAgreeWithTheOracle) {
  const SphereLight sphere{{0, 2, 0}, 0.5, Rgbd(1), 1};
  const RectangleLight near_by{{-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, Rgbd(1), 1};
  const RectangleLight far{{-1, 64, -1}, {2, 0, 0}, {0, 0, 2}, Rgbd(1), 1};
  expect_oracle_samples<double, SphereLightKernel, SphereLightView>("sphere, double", sphere, 16);
  expect_oracle_samples<float, SphereLightKernel, SphereLightView>("sphere, float", sphere, 16);
  expect_oracle_samples<double, RectangleLightKernel, RectangleLightView>("rectangle, double",
                                                                          near_by, 16);
  expect_oracle_samples<float, RectangleLightKernel, RectangleLightView>("rectangle, float",
                                                                         near_by, 16);
  expect_oracle_samples<double, RectangleLightKernel, RectangleLightView>("far, double", far, 16);
  expect_oracle_samples<float, RectangleLightKernel, RectangleLightView>("far, float", far, 16);
}
#endif

}  // namespace
}  // namespace alhazen::render

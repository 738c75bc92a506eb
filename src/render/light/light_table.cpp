// render/light: building the table of lights.
#include "render/light/light_table.h"

#include "core/base/overloaded.h"

namespace alhazen::render {

template <class Real>
LightTable<Real>::LightTable(std::span<const Light> lights, Vec3d rebased_origin) {
  kernels_.reserve(lights.size());
  for (const Light& light : lights) {
    kernels_.push_back(std::visit(
        Overloaded{
            [&](const PointLight& l) -> Kernel {
              return PointLightKernel<Real>(l, rebased_origin);
            },
            [&](const DirectionalLight& l) -> Kernel { return DirectionalLightKernel<Real>(l); },
            [&](const SpotLight& l) -> Kernel { return SpotLightKernel<Real>(l, rebased_origin); },
            [&](const SphereLight& l) -> Kernel {
              return SphereLightKernel<Real>(l, rebased_origin);
            },
            [&](const RectangleLight& l) -> Kernel {
              return RectangleLightKernel<Real>(l, rebased_origin);
            },
            [&](const AmbientLight& l) -> Kernel {
              ambient_ += Rgb<Real>(l.radiance);
              return std::monostate{};
            }},
        light.source));
  }
}

template <class Real>
int LightTable<Real>::samples(LightId id) const {
  return std::visit(
      Overloaded{[](const SphereLightKernel<Real>& l) { return l.samples; },
                 [](const RectangleLightKernel<Real>& l) { return l.samples; },
                 [](const std::monostate&) { return 0; }, [](const auto&) { return 1; }},
      kernels_[id]);
}

template <class Real>
LightView<Real> LightTable<Real>::view(LightId id, Vec3<Real> point) const {
  using View = LightView<Real>;
  return std::visit(
      Overloaded{
          [&](const SphereLightKernel<Real>& l) { return View(SphereLightView<Real>(l, point)); },
          [&](const RectangleLightKernel<Real>& l) {
            return View(RectangleLightView<Real>(l, point));
          },
          [](const DirectionalLightKernel<Real>& l) { return View(l.sample()); },
          [](const std::monostate&) { return View(LightSample<Real>{}); },
          [&](const auto& l) { return View(l.sample(point)); }},
      kernels_[id]);
}

template class LightTable<float>;
template class LightTable<double>;
#if ALHAZEN_HAS_QUAD
template class LightTable<Quad>;
#endif

}  // namespace alhazen::render

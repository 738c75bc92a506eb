#include "app/povray/cutoff.h"

#include <algorithm>

#include "core/base/overloaded.h"
#include "core/scene/live.h"

namespace alhazen {
namespace {

bool is_grey(Rgbd c) {
  return c.r == c.g && c.g == c.b;
}
bool is_grey(const std::optional<Rgbd>& solid) {
  return solid && is_grey(*solid);
}

bool differs(const PovFinish& m, const std::optional<Rgbd>& color) {
  const PovReflection& r = m.reflection;
  const bool reflects = !is_black(r.min) || !is_black(r.max);
  const bool evenly = r.min == r.max && is_grey(r.max) && r.metallic == 0;
  const bool passes_grey = m.filter == 0 || is_grey(color);
  return (reflects && !evenly) || !passes_grey;
}

}  // namespace

std::optional<SourceSpan> cutoff_difference(const Scene& scene) {
  if (scene.settings.cutoff == 0) return std::nullopt;
  const SolidColors solid = solid_colors(scene);
  const auto found = std::ranges::find_if(scene.materials, [&](const Material& material) {
    return std::visit(
        Overloaded{[](const Diffuse&) { return false; }, [](const Black&) { return false; },
                   [&](const Mirror& m) { return !is_grey(solid[m.reflectance]); },
                   [](const Glass& m) { return !is_black(m.absorption); },
                   [&](const PovFinish& m) { return differs(m, solid[m.color]); },
                   [](const auto&) { return true; }},
        material.scattering);
  });
  if (found == scene.materials.end()) return std::nullopt;
  return found->span;
}

}  // namespace alhazen

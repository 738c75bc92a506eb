#include "app/povray/nesting.h"

#include <algorithm>
#include <utility>

#include "app/povray/bounds.h"
#include "core/base/overloaded.h"

namespace alhazen {
namespace {

bool overlap(const Bounds& a, const Bounds& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.high[i] < b.low[i] || b.high[i] < a.low[i]) return false;
  }
  return true;
}

bool is_see_through(const Material& material) {
  return std::visit(Overloaded{[](const Glass&) { return true; },
                               [](const PovFinish& m) {
                                 return m.filter + m.transmit > 0 && m.reflection.fresnel;
                               },
                               [](const auto&) { return false; }},
                    material.scattering);
}

struct Solid {
  Bounds bounds;
  MaterialId material;
  SourceSpan span;
  bool found = false;
};

}  // namespace

std::vector<SourceSpan> solids_within_solids(const Scene& scene) {
  std::vector<Solid> solids;
  const auto add = [&](const Shape& shape) {
    if (!is_see_through(scene.materials[shape.material])) return;
    solids.push_back({world_bounds(shape), shape.material, shape.span});
  };
  const SceneShapes& shapes = scene.shapes;
  for (const Shape& shape : shapes.singles())
    add(shape);
  std::vector<std::vector<ShapeId>> candidates(shapes.prototypes().size());
  for (std::size_t p = 0; p < candidates.size(); ++p) {
    for (ShapeId n = 0; n < shapes.prototypes()[p].size(); ++n) {
      const MaterialId material = shapes.prototypes()[p][n].material;
      if (material == kNoId || is_see_through(scene.materials[material])) {
        candidates[p].push_back(n);
      }
    }
  }
  for (InstanceId id = 0; id < shapes.instance_count(); ++id) {
    for (const ShapeId n : candidates[shapes.prototype_of(id)])
      add(shapes[shapes.index().first(id) + n]);
  }
  // Along x only those are compared that overlap there.
  std::ranges::stable_sort(solids, {}, [](const Solid& s) { return s.bounds.low.x; });
  std::vector<SourceSpan> found;
  for (auto a = solids.begin(); a != solids.end(); ++a) {
    for (auto b = a + 1; b != solids.end() && b->bounds.low.x <= a->bounds.high.x; ++b) {
      if ((a->found && b->found) || a->material == b->material || !overlap(a->bounds, b->bounds))
        continue;
      for (Solid* solid : {&*a, &*b}) {
        if (std::exchange(solid->found, true)) continue;
        if (std::ranges::find(found, solid->span) == found.end()) found.push_back(solid->span);
      }
    }
  }
  return found;
}

}  // namespace alhazen

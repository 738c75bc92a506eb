#include "app/povray/reach.h"

#include <algorithm>
#include <cmath>

#include "app/povray/bounds.h"
#include "core/scene/effect.h"

namespace alhazen {
namespace {

// POV-Ray sees nothing beyond.
constexpr double kFarthest = 1e7;
// It takes hits nearer than 1e-4 to 1e-3 to a ray's beginning for the surface that the ray left.
constexpr double kSmallest = 1e-3;

double reach_of_shadows(const Scene& scene) {
  const bool parallel = std::ranges::any_of(scene.lights, [](const Light& light) {
    return std::holds_alternative<DirectionalLight>(light.source) && light.casts_shadows &&
           shines(light);
  });
  return parallel ? kFarAway : kFarthest;
}

// From the eye to the farthest corner.
double farthest(const Bounds& bounds, Vec3d eye) {
  Vec3d corner;
  for (int i = 0; i < 3; ++i)
    corner[i] = std::max(std::fabs(bounds.low[i] - eye[i]), std::fabs(bounds.high[i] - eye[i]));
  return length(corner);
}

}  // namespace

std::vector<SourceSpan> shapes_out_of_reach(const Scene& scene) {
  const double reach = reach_of_shadows(scene);
  std::vector<SourceSpan> found;
  for (const Shape& shape : scene.shapes) {
    if (std::holds_alternative<Plane>(shape.geometry)) continue;
    const Bounds world = world_bounds(shape);
    const double size = std::min(extent(world), extent(object_bounds(shape.geometry)));
    if (size < kSmallest || farthest(world, scene.camera.frame.position) > reach) {
      found.push_back(shape.span);
    }
  }
  return found;
}

}  // namespace alhazen

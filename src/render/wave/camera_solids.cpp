#include "render/wave/camera_solids.h"

#include <algorithm>

namespace alhazen::render {
namespace {

template <class Real>
bool reaches(const ShapeBounds<Real>& bounds, Vec3d half) {
  const double slack = static_cast<double>(bounds.reach) * largest_coordinate(half);
  for (int i = 0; i < 3; ++i) {
    if (static_cast<double>(bounds.min[i]) - slack > half[i] ||
        static_cast<double>(bounds.max[i]) + slack < -half[i]) {
      return false;
    }
  }
  return true;
}

// Of the shapes of a prototype that have an inside if their material has.
struct Solids {
  bool any = false;
  bool bounded = true;
  ShapeBounds<double> bounds{};  // around them, if they are bounded
};

template <class Real>
Solids solids_of(const ShapeList& prototype, const ShapeTable<Real>& table) {
  Solids solids;
  for (ShapeId n = 0; n < prototype.size(); ++n) {
    if (!is_closed(prototype[n].geometry)) continue;
    const auto own = table.bounds(n);
    const Vec3d min = own ? Vec3d(own->min) : Vec3d(), max = own ? Vec3d(own->max) : Vec3d();
    if (!solids.any) solids.bounds = {min, max, 0};
    solids.any = true;
    solids.bounded = solids.bounded && own && is_finite(min) && is_finite(max);
    if (!solids.bounded) continue;
    for (int i = 0; i < 3; ++i) {
      solids.bounds.min[i] = smaller(solids.bounds.min[i], min[i]);
      solids.bounds.max[i] = larger(solids.bounds.max[i], max[i]);
    }
    solids.bounds.reach = larger(solids.bounds.reach, static_cast<double>(own->reach));
  }
  return solids;
}

}  // namespace

Vec3d reach_of_starts(const Scene& scene) {
  const CameraFrame& frame = scene.camera.frame;
  double across = 0, upward = 0;
  if (const auto* parallel = std::get_if<OrthographicCamera>(&scene.camera.projection)) {
    const RenderSettings& settings = scene.settings;
    const double pixel = parallel->width / settings.width;
    across = pixel * (settings.width / 2.0 + settings.filter.radius);
    upward = pixel * (settings.height / 2.0 + settings.filter.radius);
  } else if (const auto& lens = std::get<PerspectiveCamera>(scene.camera.projection).lens) {
    across = upward = lens->aperture_radius;
  }
  Vec3d half;
  for (int i = 0; i < 3; ++i) {
    half[i] = 2 * (across * absolute(frame.right[i]) + upward * absolute(frame.up[i]));
  }
  return half;
}

// Only of a half-space and a single point is more known than of their bounds.
bool may_hold_start(const WorldShapes<double>& shapes, ShapeId solid, Vec3d half) {
  if (half == Vec3d()) return shapes.contains(solid, half);
  const auto bounds = shapes.bounds(solid);
  if (bounds) return reaches(*bounds, half);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d start(corner & 1 ? -half.x : half.x, corner & 2 ? -half.y : half.y,
                      corner & 4 ? -half.z : half.z);
    if (shapes.contains(solid, start)) return true;
  }
  return false;
}

template <class Real>
std::vector<ShapeId> clear_solids(const Scene& scene, const WorldShapes<Real>& shapes) {
  std::vector<ShapeId> found;
  const auto add = [&](const Shape& shape, ShapeId id) {
    const Scattering& scattering = scene.materials[shape.material].scattering;
    const bool fills =
        std::holds_alternative<Glass>(scattering) || std::holds_alternative<PovFinish>(scattering);
    if (fills && is_closed(shape.geometry)) found.push_back(id);
  };
  for (ShapeId n = 0; n < scene.shapes.singles().size(); ++n)
    add(scene.shapes.singles()[n], shapes.index().id_of_single(n));
  if (!shapes.has_instances()) return found;
  std::vector<Solids> solids;
  for (std::size_t p = 0; p < shapes.prototypes().size(); ++p)
    solids.push_back(solids_of(scene.shapes.prototypes()[p], shapes.prototypes()[p]));
  const Vec3d half = reach_of_starts(scene);
  for (InstanceId instance = 0; instance < shapes.instance_count(); ++instance) {
    const Solids& own = solids[shapes.prototype_of(instance)];
    if (!own.any) continue;
    const Placement<Real>& place = shapes.placement(instance);
    const auto bounds = bounds_in_world(own.bounds, Affined(place.world_from_object),
                                        Affined(place.object_from_world));
    if (own.bounded && !reaches(bounds, half)) continue;
    const ShapeId first = shapes.index().first(instance);
    const std::size_t count = scene.shapes.prototypes()[shapes.prototype_of(instance)].size();
    for (ShapeId n = 0; n < count; ++n)
      add(scene.shapes[first + n], first + n);
  }
  std::sort(found.begin(), found.end());
  return found;
}

template std::vector<ShapeId> clear_solids(const Scene&, const WorldShapes<float>&);
template std::vector<ShapeId> clear_solids(const Scene&, const WorldShapes<double>&);
#if ALHAZEN_HAS_QUAD
template std::vector<ShapeId> clear_solids(const Scene&, const WorldShapes<Quad>&);
#endif

}  // namespace alhazen::render

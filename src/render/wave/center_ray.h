// render/wave: the geometry that the ray through the centre of a pixel meets: depth, position,
// normal and surface coordinates. They are not averaged, since the mean of two depths is nowhere.
#pragma once

#include "render/wave/world.h"

namespace alhazen::render {

// `pixel` is the index of (x, y) in the picture's planes.
template <class Real>
void write_center_geometry(const World<Real>& world, const AovRequest& aovs, const Camera& camera,
                           int x, int y, std::size_t pixel, Picture& picture) {
  const CameraRay<Real> start = world.camera.ray({x, y, Real(0), Real(0)}, Real(0.5), Real(0.5));
  const Ray<Real> ray{start.origin, start.direction};
  const auto hit = closest_hit(world.tree, ray, Source{}, infinity<Real>());
  if (!hit) {
    if (aovs.depth) picture.depth[pixel] = std::numeric_limits<float>::infinity();
    return;
  }
  const SurfacePoint<Real> point = world.shapes.surface(hit->shape, ray, hit->crossing());
  const Vec3<Real> position = point.position;
  const auto put = [pixel](std::vector<float>& plane, const auto& v) {
    plane[3 * pixel] = static_cast<float>(v.x);
    plane[3 * pixel + 1] = static_cast<float>(v.y);
    plane[3 * pixel + 2] = static_cast<float>(v.z);
  };
  if (aovs.depth) {
    picture.depth[pixel] = static_cast<float>(dot(position, Vec3<Real>(camera.frame.forward)));
  }
  if (aovs.position) put(picture.position, Vec3d(position) + world.world_offset);
  if (aovs.normal) {
    put(picture.normal, hit->enters ? point.shading_normal : -point.shading_normal);
  }
  if (aovs.uv) {
    picture.uv[2 * pixel] = static_cast<float>(point.u);
    picture.uv[2 * pixel + 1] = static_cast<float>(point.v);
  }
}

}  // namespace alhazen::render

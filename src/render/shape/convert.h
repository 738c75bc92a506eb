// render/shape: kernels from double to the scalar type of the run.
#pragma once

#include "render/shape/from_scene.h"

namespace alhazen::render {

template <class Real>
Sphere<Real> convert(const Sphere<double>& s) {
  return {Vec3<Real>(s.center), static_cast<Real>(s.radius)};
}
template <class Real>
Plane<Real> convert(const Plane<double>& p) {
  return {Vec3<Real>(p.normal), static_cast<Real>(p.offset),   Vec3<Real>(p.u_axis),
          Vec3<Real>(p.v_axis), static_cast<Real>(p.u_offset), static_cast<Real>(p.v_offset)};
}
template <class Real>
Box<Real> convert(const Box<double>& b) {
  return {Vec3<Real>(b.min), Vec3<Real>(b.max)};
}
template <class Real>
Disc<Real> convert(const Disc<double>& d) {
  return {frame_in<Real>(d.frame), static_cast<Real>(d.radius), static_cast<Real>(d.hole_radius)};
}
template <class Real>
Frustum<Real> convert(const Frustum<double>& f) {
  return {frame_in<Real>(f.frame),
          static_cast<Real>(f.height),
          static_cast<Real>(f.small_radius),
          static_cast<Real>(f.large_radius),
          static_cast<Real>(f.slope),
          f.capped,
          f.base_is_small};
}
template <class Real>
Triangle<Real> convert(const Triangle<double>& t) {
  Triangle<Real> result;
  for (int i = 0; i < 3; ++i) {
    result.corners[i] = Vec3<Real>(t.corners[i]);
    result.normals[i] = Vec3<Real>(t.normals[i]);
  }
  result.smooth = t.smooth;
  result.reversed = t.reversed;
  return result;
}
template <class Real>
Parallelogram<Real> convert(const Parallelogram<double>& p) {
  Parallelogram<Real> result;
  for (int i = 0; i < 4; ++i)
    result.corners[i] = Vec3<Real>(p.corners[i]);
  result.reversed = p.reversed;
  return result;
}

}  // namespace alhazen::render

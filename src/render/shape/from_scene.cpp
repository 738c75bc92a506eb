#include "render/shape/from_scene.h"

namespace alhazen::render {
namespace {

Frustum<double> frustum_between(Vec3d base, Vec3d top, double base_radius, double top_radius,
                                bool capped, Vec3d origin) {
  const bool base_is_small = base_radius <= top_radius;
  const Vec3d small = base_is_small ? base : top, large = base_is_small ? top : base;
  const Vec3d along = large - small;
  Frustum<double> frustum{};
  frustum.height = length(along);
  frustum.frame = frame_around(small - origin, along / frustum.height);
  frustum.small_radius = smaller(base_radius, top_radius);
  frustum.large_radius = larger(base_radius, top_radius);
  frustum.slope = (frustum.large_radius - frustum.small_radius) / frustum.height;
  frustum.capped = capped;
  frustum.base_is_small = base_is_small;
  return frustum;
}

// offset - dot(a, b), as if rounded once: the three can be large and their sum small.
double residue(double offset, Vec3d a, Vec3d b) {
  const DoubleWord<double> sum =
      two_product(a.x, b.x) + two_product(a.y, b.y) + two_product(a.z, b.z);
  return (-sum + offset).hi;
}

}  // namespace

Sphere<double> from_scene(const alhazen::Sphere& sphere, Vec3d origin) {
  return {sphere.center - origin, sphere.radius};
}

Box<double> from_scene(const alhazen::Box& box, Vec3d origin) {
  return {box.min - origin, box.max - origin};
}

Disc<double> from_scene(const alhazen::Disc& disc, Vec3d origin) {
  return {frame_around(disc.center - origin, disc.normal), disc.radius, disc.hole_radius};
}

Frustum<double> from_scene(const alhazen::Cylinder& c, Vec3d origin) {
  return frustum_between(c.base, c.top, c.radius, c.radius, c.capped, origin);
}

Frustum<double> from_scene(const alhazen::Cone& c, Vec3d origin) {
  return frustum_between(c.base, c.top, c.base_radius, c.top_radius, c.capped, origin);
}

Placed placed(Affined world_from_object, Vec3d origin) {
  for (int i = 0; i < 3; ++i)
    world_from_object.rows[i][3] -= origin[i];
  return {world_from_object, inverse(world_from_object).value_or(Affined()),
          determinant(world_from_object) < 0};
}

Plane<double> from_scene(const alhazen::Plane& plane, Vec3d origin) {
  const Frame<double> frame = frame_around({}, plane.normal);
  return {plane.normal,
          residue(plane.offset, plane.normal, origin),
          frame.x,
          frame.y,
          dot(frame.x, origin),
          dot(frame.y, origin)};
}

Plane<double> from_scene(const alhazen::Plane& plane, const Placed& place) {
  // dot(n, R p + s) = offset, with object = R world + s.
  const Affined& map = place.object_from_world;
  const Vec3d shift = map.point({});
  const Vec3d normal = map.transposed(plane.normal);
  const double size = length(normal);
  const Frame<double> frame = frame_around({}, plane.normal);
  return {normal / size,           residue(plane.offset, plane.normal, shift) / size,
          map.transposed(frame.x), map.transposed(frame.y),
          dot(frame.x, shift),     dot(frame.y, shift)};
}

Triangle<double> from_scene(const alhazen::Triangle& triangle, Vec3d origin) {
  Triangle<double> result;
  for (int i = 0; i < 3; ++i)
    result.corners[i] = triangle.corners[i] - origin;
  result.smooth = triangle.normals.has_value();
  if (result.smooth) result.normals = *triangle.normals;
  return result;
}

Triangle<double> from_scene(const alhazen::Triangle& triangle, const Placed& place) {
  Triangle<double> result = from_scene(triangle, Vec3d{});
  for (Vec3d& corner : result.corners)
    corner = place.world_from_object.point(corner);
  if (result.smooth) {
    for (Vec3d& n : result.normals)
      n = normalized(place.object_from_world.transposed(n));
  }
  result.reversed = place.mirrored;
  return result;
}

Parallelogram<double> from_scene(const Quad4& quad, Vec3d origin) {
  const Vec3d corner = quad.corner - origin;
  return {{corner, corner + quad.edge_u, corner + quad.edge_u + quad.edge_v, corner + quad.edge_v}};
}

Parallelogram<double> from_scene(const Quad4& quad, const Placed& place) {
  const Quad4 mapped{place.world_from_object.point(quad.corner),
                     place.world_from_object.vector(quad.edge_u),
                     place.world_from_object.vector(quad.edge_v)};
  Parallelogram<double> result = from_scene(mapped, Vec3d{});
  result.reversed = place.mirrored;
  return result;
}

}  // namespace alhazen::render

#include "app/povray/uv_frame.h"

#include <fmt/format.h>

#include "app/povray/pov_writer.h"
#include "core/base/overloaded.h"
#include "render/shape/frame.h"

namespace alhazen {
namespace {

Affined with_columns(Vec3d x, Vec3d y, Vec3d z, Vec3d origin) {
  Affined map;
  for (int row = 0; row < 3; ++row)
    map.rows[row] = {x[row], y[row], z[row], origin[row]};
  return map;
}

// u along `edge_u`, v along `edge_v` from `corner`. The edges are not parallel.
UvFrame flat(Vec3d corner, Vec3d edge_u, Vec3d edge_v) {
  UvFrame frame;
  const Vec3d normal = normalized(cross(edge_u, edge_v));
  frame.uv_from_object = inverse(with_columns(edge_u, edge_v, normal, corner));
  return frame;
}

// The distance of x, y, z from `origin` along `axis`.
std::string along(Vec3d axis, Vec3d origin) {
  return fmt::format("((x - {})*{} + (y - {})*{} + (z - {})*{})", pov_number(origin.x),
                     pov_number(axis.x), pov_number(origin.y), pov_number(axis.y),
                     pov_number(origin.z), pov_number(axis.z));
}

// The angle of (a, b) in turns from 0 to 1. select(s, A, B) is A where s < 0.
std::string turn(const std::string& a, const std::string& b) {
  return fmt::format("(atan2({1}, {0})/(2*pi) + select(atan2({1}, {0}), 1, 0))", a, b);
}

UvFrame of(const Sphere& s) {
  UvFrame frame;
  frame.u = turn(along({1, 0, 0}, s.center), along({0, 0, 1}, s.center));
  frame.v = fmt::format("(acos(min(1, max(-1, -{}/{})))/pi)", along({0, 1, 0}, s.center),
                        pov_number(s.radius));
  frame.warp = "spherical";
  frame.object_from_warped = translation(s.center) * scaling({s.radius, s.radius, s.radius});
  return frame;
}

UvFrame of(const Plane& plane) {
  const render::Frame<double> f = render::frame_around({}, plane.normal);
  return flat(plane.offset * plane.normal, f.x, f.y);
}

// The face is the one whose side of the box the point is nearest to; on it u and v are the other
// two coordinates.
UvFrame of(const Box& box) {
  const Vec3d half = (box.max - box.min) / 2.0, middle = (box.min + box.max) / 2.0;
  const char* const names[] = {"x", "y", "z"};
  std::string out[3], share[3];
  for (int i = 0; i < 3; ++i) {
    out[i] = fmt::format("abs(({} - {})/{})", names[i], pov_number(middle[i]), pov_number(half[i]));
    share[i] =
        fmt::format("(({} - {})/{})", names[i], pov_number(box.min[i]), pov_number(2 * half[i]));
  }
  UvFrame frame;
  frame.u =
      fmt::format("select({} - max({}, {}), {}, {})", out[0], out[1], out[2], share[0], share[1]);
  frame.v =
      fmt::format("select({} - max({}, {}), {}, {})", out[2], out[0], out[1], share[2], share[1]);
  return frame;
}

UvFrame of(const Disc& disc) {
  const render::Frame<double> f = render::frame_around(disc.center, disc.normal);
  const std::string a = along(f.x, f.origin), b = along(f.y, f.origin);
  UvFrame frame;
  frame.u = turn(a, b);
  frame.v = fmt::format("min(1, max(0, (sqrt({0}*{0} + {1}*{1}) - {2})/{3}))", a, b,
                        pov_number(disc.hole_radius), pov_number(disc.radius - disc.hole_radius));
  return frame;
}

UvFrame frustum(Vec3d base, Vec3d top, double base_radius, double top_radius, bool capped) {
  // The renderer's frame stands on the narrower end.
  const bool base_is_small = base_radius <= top_radius;
  const Vec3d small = base_is_small ? base : top, large = base_is_small ? top : base;
  const double height = length(large - small);
  const render::Frame<double> f = render::frame_around(small, (large - small) / height);
  const std::string a = along(f.x, f.origin), b = along(f.y, f.origin);
  const std::string up =
      fmt::format("({}/{})", along((top - base) / height, base), pov_number(height));
  UvFrame frame;
  frame.u = turn(a, b);
  frame.v = up;
  if (capped) {
    // On an end v goes from its middle to its rim. A point belongs to an end if it lies on it but
    // for POV-Ray's own tolerance.
    const auto end = [&](double radius) {
      return radius > 0 ? fmt::format("min(1, sqrt({0}*{0} + {1}*{1})/{2})", a, b, radius)
                        : std::string("0");
    };
    frame.v = fmt::format("select({0} - 1e-7, {1}, select(1 - 1e-7 - {0}, {2}, {0}))", up,
                          end(base_radius), end(top_radius));
  } else {
    frame.warp = "cylindrical";
    frame.object_from_warped = with_columns(f.x, top - base, f.y, base);
  }
  return frame;
}

UvFrame of(const Cylinder& c) {
  return frustum(c.base, c.top, c.radius, c.radius, c.capped);
}
UvFrame of(const Cone& c) {
  return frustum(c.base, c.top, c.base_radius, c.top_radius, c.capped);
}
UvFrame of(const Triangle& t) {
  return flat(t.corners[0], t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]);
}
UvFrame of(const Quad4& q) {
  return flat(q.corner, q.edge_u, q.edge_v);
}

}  // namespace

UvFrame uv_frame(const Geometry& geometry) {
  return std::visit([](const auto& g) { return of(g); }, geometry);
}

}  // namespace alhazen

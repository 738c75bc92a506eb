// app/nff: ear clipping (G. H. Meisters, "Polygons have ears", 1975) with exact orientations.
//
// Why the result is right: cutting off the corner b between a and c takes the boundary of the
// triangle abc from the boundary that is left. So the triangles' boundaries add up to the
// polygon's, and the number of triangles over a point, each counted by its orientation, is the
// number of times the polygon winds around the point. That is 0 or 1 everywhere if edges neither
// cross nor repeat; as only counterclockwise triangles are cut off, they cover each point of the
// inside once.
#include "app/nff/triangulate.h"

#include <algorithm>

#include "app/nff/direction.h"
#include "app/nff/orientation.h"

namespace alhazen {
namespace {

// Newell's normal, from the first corner so that distance from the origin costs no digits.
Vec3d average_normal(std::span<const Vec3d> corners) {
  Vec3d sum;
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum = sum + cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  return sum;
}

bool all_on_one_line(std::span<const Vec3d> corners) {
  const auto far = std::ranges::max_element(
      corners, {}, [&](Vec3d corner) { return length_squared(corner - corners[0]); });
  return std::ranges::none_of(corners,
                              [&](Vec3d corner) { return has_area(corners[0], *far, corner); });
}

// Seen from the front along the axis that is nearest to the normal: no rounding, and
// counterclockwise again.
std::vector<Point2> flattened(std::span<const Vec3d> corners, Vec3d normal) {
  const double ax = absolute(normal.x), ay = absolute(normal.y), az = absolute(normal.z);
  const int axis = ax > ay ? (ax > az ? 0 : 2) : (ay > az ? 1 : 2);
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  std::vector<Point2> points;
  points.reserve(corners.size());
  for (const Vec3d corner : corners)
    points.push_back({corner[u], corner[v]});
  return points;
}

bool boxes_meet(Point2 a, Point2 b, Point2 c, Point2 d) {
  return std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
         std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

// Whether the inner points of two segments cross; touching does not count.
bool segments_cross(Point2 a, Point2 b, Point2 c, Point2 d) {
  return boxes_meet(a, b, c, d) && orientation(a, b, c) * orientation(a, b, d) < 0 &&
         orientation(c, d, a) * orientation(c, d, b) < 0;
}

// Whether a piece of one segment is gone over again by the other in the same direction. (There and
// back is how a hole is joined to the rim.)
bool segments_repeat(Point2 a, Point2 b, Point2 c, Point2 d) {
  if (!boxes_meet(a, b, c, d) || orientation(a, b, c) != 0 || orientation(a, b, d) != 0) {
    return false;
  }
  if ((b.x > a.x && d.x > c.x) || (b.x < a.x && d.x < c.x)) {
    return std::max(std::min(a.x, b.x), std::min(c.x, d.x)) <
           std::min(std::max(a.x, b.x), std::max(c.x, d.x));
  }
  return ((b.y > a.y && d.y > c.y) || (b.y < a.y && d.y < c.y)) &&
         std::max(std::min(a.y, b.y), std::min(c.y, d.y)) <
             std::min(std::max(a.y, b.y), std::max(c.y, d.y));
}

bool edges_cross(const std::vector<Point2>& points) {
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      const Point2 a = points[i], b = points[i + 1], c = points[j], d = points[(j + 1) % n];
      if (segments_cross(a, b, c, d) || segments_repeat(a, b, c, d)) return true;
    }
  }
  return false;
}

// The corners that are left, in a ring, and which of them can be cut off.
class EarClipper {
 public:
  explicit EarClipper(const std::vector<Point2>& points)
      : points_(points), links_(points.size()), left_(points.size()) {
    const auto n = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = 0; i < n; ++i)
      links_[i] = {(i + n - 1) % n, (i + 1) % n, false, false};
    look_at_all();
  }

  // False if no corner can be cut off any more.
  bool run(std::vector<TriangleCorners>& triangles) {
    bool looked_at_all = true;
    for (std::uint32_t tried = 0; left_ >= 3;) {
      if (links_[at_].ear) {
        if (turn(at_) > 0) triangles.push_back({links_[at_].before, at_, links_[at_].after});
        cut_off(at_);
        tried = 0;
        looked_at_all = false;
      } else if (++tried <= left_) {
        at_ = links_[at_].after;
      } else if (!looked_at_all) {
        look_at_all();
        looked_at_all = true;
        tried = 0;
      } else if (cut_off_straight()) {
        tried = 0;
        looked_at_all = false;
      } else {
        return false;
      }
    }
    return true;
  }

 private:
  struct Link {
    std::uint32_t before, after;
    bool ear, gone;
  };

  int turn(std::uint32_t corner) const {
    return orientation(points_[links_[corner].before], points_[corner],
                       points_[links_[corner].after]);
  }

  // A corner is an ear if it is convex and no other lies in its triangle or on the cut. Corners at
  // the place of one of the three do not count, nor do those that only touch the outer edges. The
  // end of an edge there and back is one, too, but has no triangle.
  bool is_ear(std::uint32_t corner) const {
    const Point2 a = points_[links_[corner].before], b = points_[corner],
                 c = points_[links_[corner].after];
    const int turns = turn(corner);
    if (turns == 0) return turns_back(a, b, c);
    if (turns < 0) return false;
    const std::uint32_t last = links_[corner].before;
    for (std::uint32_t i = links_[links_[corner].after].after; i != last; i = links_[i].after) {
      const Point2 p = points_[i];
      if (p == a || p == b || p == c || !is_in_box(p, a, b, c)) continue;
      if (orientation(a, b, p) > 0 && orientation(b, c, p) > 0 && orientation(c, a, p) >= 0)
        return false;
    }
    return true;
  }
  // Whether c lies on the side of b where a lies, or two of them in one place. Precondition: all on
  // one line. The signs of differences are exact, so that of the sum is.
  static bool turns_back(Point2 a, Point2 b, Point2 c) {
    return a == b || b == c || (a.x - b.x) * (c.x - b.x) + (a.y - b.y) * (c.y - b.y) > 0;
  }
  static bool is_in_box(Point2 p, Point2 a, Point2 b, Point2 c) {
    return p.x >= std::min({a.x, b.x, c.x}) && p.x <= std::max({a.x, b.x, c.x}) &&
           p.y >= std::min({a.y, b.y, c.y}) && p.y <= std::max({a.y, b.y, c.y});
  }

  void look_at_all() {
    for (std::uint32_t i = 0; i < links_.size(); ++i) {
      if (!links_[i].gone) links_[i].ear = is_ear(i);
    }
  }

  // Goes on two corners further, so that the cuts do not all end in one corner.
  void cut_off(std::uint32_t corner) {
    const auto [before, after, ear, gone] = links_[corner];
    links_[corner].gone = true;
    links_[before].after = after;
    links_[after].before = before;
    --left_;
    links_[before].ear = is_ear(before);
    links_[after].ear = is_ear(after);
    at_ = links_[after].after;
  }

  // A corner amid a straight edge: cutting it off leaves the area as it is. Comes last, since such
  // a corner may still serve.
  bool cut_off_straight() {
    for (std::uint32_t i = 0; i < left_; ++i, at_ = links_[at_].after) {
      if (turn(at_) != 0) continue;
      cut_off(at_);
      return true;
    }
    return false;
  }

  const std::vector<Point2>& points_;
  std::vector<Link> links_;
  std::size_t left_;
  std::uint32_t at_ = 0;
};

}  // namespace

PolygonKind triangulate(std::span<const Vec3d> corners, std::vector<TriangleCorners>& triangles) {
  if (all_on_one_line(corners)) return PolygonKind::no_area;
  if (corners.size() == 3) {
    triangles.push_back({0, 1, 2});
    return PolygonKind::good;
  }
  const Vec3d normal = average_normal(corners);
  if (is_zero(normal)) return PolygonKind::edges_cross;
  const std::vector<Point2> points = flattened(corners, normal);
  std::vector<TriangleCorners> found;
  if (edges_cross(points) || !EarClipper(points).run(found)) return PolygonKind::edges_cross;
  for (const auto& [a, b, c] : found) {
    if (has_area(corners[a], corners[b], corners[c])) triangles.push_back({a, b, c});
  }
  return PolygonKind::good;
}

}  // namespace alhazen

#include "core/math/transform.h"

#include "core/math/elementary.h"

namespace alhazen {
namespace {

Vec3d column(const Affined& map, int j) {
  return {map.rows[0][j], map.rows[1][j], map.rows[2][j]};
}

}  // namespace

double determinant(const Affined& map) {
  return dot(column(map, 0), cross(column(map, 1), column(map, 2)));
}

std::optional<Affined> inverse(const Affined& b_from_a) {
  const Vec3d c0 = column(b_from_a, 0), c1 = column(b_from_a, 1), c2 = column(b_from_a, 2);
  const double det = determinant(b_from_a);
  // The determinant is trusted when it stands clear of the rounding of its six products, each of
  // at most |c0| |c1| |c2| in size.
  const double size = length(c0) * length(c1) * length(c2);
  const double bound = 8 * ScalarTraits<double>::unit_roundoff() * size;
  if (!is_finite(size) || !(absolute(det) > bound)) return std::nullopt;
  const Vec3d r0 = cross(c1, c2) / det, r1 = cross(c2, c0) / det, r2 = cross(c0, c1) / det;
  const Vec3d t = column(b_from_a, 3);
  Affined a_from_b({{{r0.x, r0.y, r0.z, -dot(r0, t)},
                     {r1.x, r1.y, r1.z, -dot(r1, t)},
                     {r2.x, r2.y, r2.z, -dot(r2, t)}}});
  for (const auto& row : a_from_b.rows) {
    for (const double entry : row) {
      if (!is_finite(entry)) return std::nullopt;
    }
  }
  return a_from_b;
}

Affined translation(Vec3d offset) {
  Affined map;
  for (int i = 0; i < 3; ++i)
    map.rows[i][3] = offset[i];
  return map;
}

Affined scaling(Vec3d factors) {
  Affined map;
  for (int i = 0; i < 3; ++i)
    map.rows[i][i] = factors[i];
  return map;
}

Affined rotation(Vec3d axis, double angle_deg) {
  // Rodrigues' formula. Left-handed rotation is the right-handed formula read in a left-handed
  // frame: the same matrix, so that rotate z by 90 degrees takes x to y.
  const Vec3d n = normalized(axis);
  const double c = cos_deg(angle_deg), s = sin_deg(angle_deg), k = 1 - c;
  return Affined({{{c + k * n.x * n.x, k * n.x * n.y - s * n.z, k * n.x * n.z + s * n.y, 0},
                   {k * n.y * n.x + s * n.z, c + k * n.y * n.y, k * n.y * n.z - s * n.x, 0},
                   {k * n.z * n.x - s * n.y, k * n.z * n.y + s * n.x, c + k * n.z * n.z, 0}}});
}

}  // namespace alhazen

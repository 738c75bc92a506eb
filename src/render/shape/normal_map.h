// render/shape: normals of an object frame in the world.
//
// A normal goes by the inverse transposed. Each of its rows is a cross product of two columns of
// the map, over the determinant, so the direction needs no inverse; and in two words it is right to
// a rounding where products and sum cancel, as they do on what is stretched and turned.
#pragma once

#include "core/math/error_free.h"
#include "core/math/transform.h"
#include "render/simd/lanes.h"

namespace alhazen::render {

// The plain sum is good enough where no more than a quarter of its terms has cancelled.
inline constexpr int kTermsToSum = 4;

// sum of n_i (column i + 1 x column i + 2), along one axis of the world: `j` and `k` are the rows
// of the two axes after it.
template <class Real>
inline DoubleWord<Real> two_word_normal(const std::array<Real, 4>& j, const std::array<Real, 4>& k,
                                        Vec3<Real> n) {
  const auto minor = [&](int a, int b) {
    return two_product(j[a], k[b]) - two_product(k[a], j[b]);
  };
  return minor(1, 2) * n.x + minor(2, 0) * n.y + minor(0, 1) * n.z;
}

// Of unit length.
template <class Real>
inline Vec3<Real> normal_in_world(const Affine<Real>& world_from_object,
                                  const Affine<Real>& object_from_world, Vec3<Real> n) {
  const Vec3<Real> plain = object_from_world.transposed(n);
  Real terms(0);
  for (int i = 0; i < 3; ++i) {
    const auto& row = object_from_world.rows[i];
    terms = terms + absolute(n[i]) * (absolute(row[0]) + absolute(row[1]) + absolute(row[2]));
  }
  const Real sum = absolute(plain.x) + absolute(plain.y) + absolute(plain.z);
  const MaskOf<Real> lost = Real(kTermsToSum) * (terms - sum) > terms;
  if (!any(lost)) return normalized(plain);
  const auto& rows = world_from_object.rows;
  const Vec3<Real> exact{two_word_normal(rows[1], rows[2], n).hi,
                         two_word_normal(rows[2], rows[0], n).hi,
                         two_word_normal(rows[0], rows[1], n).hi};
  // It has the determinant for a factor; its size may be beyond squaring.
  const Real size = larger(larger(absolute(exact.x), absolute(exact.y)), absolute(exact.z));
  const Real scale = select(dot(exact / size, plain) < Real(0), -size, size);
  return normalized(select(lost, exact / scale, plain));
}

}  // namespace alhazen::render

// render/accel: a ray made ready for the boxes of a tree.
//
// Slabs (Kay and Kajiya 1986) with one reciprocal per axis. Boxes are moved outward by `margin` by
// moving the origin instead: inward faces are seen from a point farther back. With u the unit
// roundoff, the moved origin, the difference, the reciprocal and the product have one rounding
// each, together less than 8u (|origin| + |box|) of length (after T. Ize, "Robust BVH ray
// traversal", JCGT 2(2), 2013, but as a length, not as a factor of t, so that an interval that
// begins behind the origin is covered too). Boxes and margin have that to spare
// (shape/bounds.h), so the computed interval holds the t of every hit.
//
// An axis along which the ray does not move, or so little that the reciprocal overflows, gets the
// reciprocal +infinity: then the interval is everything or nothing, or 0 * infinity, a NaN, for an
// origin on the very plane; the order of comparisons below passes over it.
#pragma once

#include "render/accel/tree_node.h"
#include "render/shape/crossing.h"

namespace alhazen::render {

template <class Real>
class TreeRay {
 public:
  TreeRay(const Ray<Real>& ray, Real margin) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Real o = ray.origin[static_cast<int>(axis)], d = ray.direction[static_cast<int>(axis)];
      const Real reciprocal = Real(1) / d;
      inverse_[axis] = is_finite(reciprocal) ? reciprocal : infinity<Real>();
      const bool backwards = inverse_[axis] < Real(0);
      near_side_[axis] = backwards ? TreeNode<Real>::kMax : TreeNode<Real>::kMin;
      near_origin_[axis] = backwards ? o - margin : o + margin;
      far_origin_[axis] = backwards ? o + margin : o - margin;
    }
  }

  // The parts of the line inside of the children's boxes that lie in [from, to]; empty where near >
  // far.
  struct Spans {
    typename TreeNode<Real>::Lanes near, far;
  };
  Spans spans(const TreeNode<Real>& node, Real from, Real to) const {
    Spans result;
    result.near.fill(from);
    result.far.fill(to);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& near_plane = node.planes[axis][near_side_[axis]];
      const auto& far_plane = node.planes[axis][1 - near_side_[axis]];
      for (std::size_t k = 0; k < kNodeWidth; ++k) {
        const Real near = (near_plane[k] - near_origin_[axis]) * inverse_[axis];
        const Real far = (far_plane[k] - far_origin_[axis]) * inverse_[axis];
        result.near[k] = near > result.near[k] ? near : result.near[k];
        result.far[k] = far < result.far[k] ? far : result.far[k];
      }
    }
    return result;
  }

 private:
  std::array<Real, 3> inverse_, near_origin_, far_origin_;
  std::array<std::size_t, 3> near_side_;
};

}  // namespace alhazen::render

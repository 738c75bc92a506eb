// render/accel: lanes of rays and the boxes of a tree: all boxes of a node at once for all rays
// together, then one box for each ray.
#pragma once

#include "render/accel/tree_approach.h"

namespace alhazen::render {

// Each ray against one box. The arithmetic of a lane is that of TreeRay but for the order in which
// bounds are taken.
template <class Float>
class EachRay {
 public:
  EachRay(Vec3<Float> origin, Vec3<Float> inverse, Float blur)
      : axes_(tree_axes(origin, inverse, blur)) {}

  // Which rays meet the box of a node's child before `to`.
  MaskOf<Float> meet(const TreeNode& node, std::size_t child, Float to) const {
    Float near(0), far = to;
    for (std::size_t i = 0; i < 3; ++i) {
      const TreeAxis<Float>& axis = axes_[i];
      const Float low =
          (Float(node.planes[i][TreeNode::kMin][child]) - axis.low_origin) * axis.inverse;
      const Float high =
          (Float(node.planes[i][TreeNode::kMax][child]) - axis.high_origin) * axis.inverse;
      near = larger(near, smaller(low, high));
      far = smaller(far, larger(low, high));
    }
    return near <= far;
  }
  const TreeAxis<Float>& axis(std::size_t i) const { return axes_[i]; }
  // The ray of a lane.
  TreeRay one(int lane) const {
    return TreeRay({TreeAxis<float>(axes_[0], lane), TreeAxis<float>(axes_[1], lane),
                    TreeAxis<float>(axes_[2], lane)});
  }

 private:
  TreeAxes<Float> axes_;
};

// All rays as one, whose origin and direction are intervals: what it misses none of them meets.
// Every bound is computed with the operations of EachRay from the ends of the intervals; rounding
// keeps the order of numbers, so no margin is needed.
//
// On an axis along which some rays run forwards and others backwards the reciprocals are no
// interval. There the rays' places between near and far bound them: a product t d, with roundings
// of 3u of itself, is short by less than 3u (|plane| + |origin|) where it counts.
class AllRays {
 public:
  template <class Float>
  AllRays(const EachRay<Float>& rays, MaskOf<Float> active) {
    for (std::size_t i = 0; i < 3; ++i) {
      const TreeAxis<Float>& axis = rays.axis(i);
      const float low_origin = greatest(axis.low_origin, active),
                  high_origin = least(axis.high_origin, active);
      least_inverse_[i] = least(axis.inverse, active);
      greatest_inverse_[i] = greatest(axis.inverse, active);
      const bool backwards = greatest_inverse_[i] < 0;
      mixed_[i] = !backwards && least_inverse_[i] < 0;
      near_side_[i] = backwards ? TreeNode::kMax : TreeNode::kMin;
      near_origin_[i] = backwards ? high_origin : low_origin;
      far_origin_[i] = backwards ? low_origin : high_origin;
      if (!mixed_[i]) continue;
      const Float direction = Float(1) / axis.inverse;
      near_origin_[i] = greatest(axis.low_origin, active);
      far_origin_[i] = least(axis.high_origin, active);
      least_inverse_[i] = least(direction, active);
      greatest_inverse_[i] = greatest(direction, active);
    }
  }

  // Whether the rays have no direction in common.
  bool scatter() const { return mixed_[0] && mixed_[1] && mixed_[2]; }

  struct Met {
    NodeLanes near;
    NodeLanes::Mask mask;
  };
  Met meet(const TreeNode& node, float to) const {
    NodeLanes near(0), far(to);
    for (std::size_t i = 0; i < 3; ++i) {
      if (mixed_[i]) continue;
      const auto& planes = node.planes[i];
      const NodeLanes low =
          NodeLanes::load(planes[near_side_[i]].data()) - NodeLanes(near_origin_[i]);
      const NodeLanes high =
          NodeLanes::load(planes[1 - near_side_[i]].data()) - NodeLanes(far_origin_[i]);
      const NodeLanes least(least_inverse_[i]), greatest(greatest_inverse_[i]);
      near = larger(near, smaller(low * least, low * greatest));
      far = smaller(far, larger(high * least, high * greatest));
    }
    NodeLanes::Mask mask = near <= far;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!mixed_[i]) continue;
      const auto& planes = node.planes[i];
      // From where the first ray may be to where the last may be.
      const NodeLanes first = NodeLanes(far_origin_[i]) + far * NodeLanes(least_inverse_[i]);
      const NodeLanes last = NodeLanes(near_origin_[i]) + far * NodeLanes(greatest_inverse_[i]);
      mask = mask && first <= NodeLanes::load(planes[TreeNode::kMax].data()) &&
             last >= NodeLanes::load(planes[TreeNode::kMin].data());
    }
    return {near, mask};
  }

 private:
  template <class Float>
  static float least(Float x, MaskOf<Float> active) {
    return least_of(select(active, x, Float(infinity<float>())));
  }
  template <class Float>
  static float greatest(Float x, MaskOf<Float> active) {
    return greatest_of(select(active, x, Float(-infinity<float>())));
  }

  std::array<float, 3> least_inverse_, greatest_inverse_;  // where mixed: of the direction itself
  std::array<float, 3> near_origin_, far_origin_;
  std::array<std::size_t, 3> near_side_;
  std::array<bool, 3> mixed_;
};

}  // namespace alhazen::render

// render/accel: a ray made ready for the boxes of a tree.
//
// First the ray meets the box around all, in its own precision: slabs (Kay and Kajiya 1986) with
// one reciprocal per axis. Boxes are moved outward by `margin` by moving the origin instead: inward
// faces are seen from a point farther back. With u the unit roundoff, the moved origin, the
// difference, the reciprocal and the product have one rounding each, together less than
// 8u (|origin| + |box|) of length (after T. Ize, "Robust BVH ray traversal", JCGT 2(2), 2013, but
// as a length, not as a factor of t, so that an interval that begins behind the origin is covered
// too). Boxes and margin have that to spare (shape/bounds.h), so the computed interval holds the t
// of every hit.
//
// Then it sets out anew from where it enters that box, however far away it came from, in the units
// of the tree and in single precision, with its direction's largest component as 1. On the line
// nothing is lost but roundings: of the new origin at most 2u |origin|, with u that of float from
// here on, of its move by the margin, of the difference and of the product u each, of the
// reciprocal 2u: together less than 8u (|origin| + |plane|) of length on each axis. The planes have
// 32u of themselves to spare (tree_box.h), and the margin gets 16u of the origin.
#pragma once

#include "render/accel/tree_node.h"
#include "render/shape/crossing.h"
#include "render/simd/lanes.h"

namespace alhazen::render {

// The numbers of the tree's own precision that go with a Real: a float, or as many lanes of it,
// but at least the four that every machine has registers for.
template <class Real>
struct TreeNumber {
  using Type = float;
};
template <class T, int W>
struct TreeNumber<Lanes<T, W>> {
  using Type = Lanes<float, (W < 4 ? 4 : W)>;
};
template <class Real>
using TreeNumberOf = typename TreeNumber<Real>::Type;

template <class Real>
inline float to_tree(Real x) {
  return static_cast<float>(x);
}
template <class T, int W>
inline TreeNumberOf<Lanes<T, W>> to_tree(Lanes<T, W> x) {
  using Float = TreeNumberOf<Lanes<T, W>>;
  if constexpr (std::same_as<Float, Lanes<T, W>>) {
    return x;
  } else if constexpr (Float::kWidth == W) {
    return Float(x);
  } else {
    std::array<float, static_cast<std::size_t>(Float::kWidth)> numbers{};
    for (int i = 0; i < W; ++i)
      numbers[static_cast<std::size_t>(i)] = static_cast<float>(x[i]);
    return Float::load(numbers.data());
  }
}

// A part of a line, empty where near > far, and 1 / direction on each axis.
template <class Real>
struct TreeSpan {
  Real near, far;
  Vec3<Real> reciprocal;
};

// The part in [from, to] that lies in the box, moved outward by the margin. An axis along which the
// ray does not move, or so little that the reciprocal overflows, gets the reciprocal +infinity:
// then the interval is everything or nothing, or 0 * infinity, a NaN, for an origin on the very
// plane; the order of comparisons below passes over it.
template <class Real>
inline TreeSpan<Real> span_in(Vec3<Real> min, Vec3<Real> max, const Ray<Real>& ray, Real margin,
                              Real from, Real to) {
  const Vec3<Real> d = ray.direction;
  TreeSpan<Real> span{from, to, {Real(1) / d.x, Real(1) / d.y, Real(1) / d.z}};
  for (int axis = 0; axis < 3; ++axis) {
    const Real o = ray.origin[axis], reciprocal = span.reciprocal[axis];
    const Real inverse = select(is_finite(reciprocal), reciprocal, Real(infinity<Real>()));
    const Real low = (min[axis] - (o + margin)) * inverse;
    const Real high = (max[axis] - (o - margin)) * inverse;
    const Real near = select(high < low, high, low), far = select(high < low, low, high);
    span.near = select(near > span.near, near, span.near);
    span.far = select(far < span.far, far, span.far);
  }
  return span;
}

// No way within the tree is longer: its largest coordinate is 1, as is the direction's.
inline constexpr float kLongestWay = 4;
// The reciprocal of a speed by which a ray moves by less than kNothing on the longest way.
inline constexpr float kStandstill = 16 / kNothing;

// Parameters of the shortened ray: t' = (t - start) * speed.
template <class Real>
struct TreeClock {
  Real start, speed;

  // Rounded so that no shape is left out that is met at t or before.
  auto until(Real t) const {
    const auto end = to_tree(smaller((t - start) * speed, Real(kLongestWay)));
    using Float = std::remove_const_t<decltype(end)>;
    return end + (Float(8 * kTreeRoundoff) * end + Float(kNothing));
  }
};

// The origin moved back and forth along an axis, and the reciprocal of the direction.
template <class Float>
struct TreeAxis {
  Float low_origin, high_origin;  // for the planes min and max
  Float inverse;

  // `blur` is the margin of the kernels.
  TreeAxis(Float origin, Float reciprocal, Float blur) {
    const Float by = blur + Float(16 * kTreeRoundoff) * (blur + absolute(origin)) + Float(kNothing);
    low_origin = origin + by;
    high_origin = origin - by;
    // A ray that all but stands still: as fast as this it does not get anywhere.
    inverse = select(absolute(reciprocal) <= Float(kStandstill), reciprocal, Float(kStandstill));
  }
  // That of one lane.
  template <class Lanes>
  TreeAxis(const TreeAxis<Lanes>& all, int lane)
      : low_origin(all.low_origin[lane]),
        high_origin(all.high_origin[lane]),
        inverse(all.inverse[lane]) {}
};

template <class Float>
using TreeAxes = std::array<TreeAxis<Float>, 3>;

template <class Float>
inline TreeAxes<Float> tree_axes(Vec3<Float> origin, Vec3<Float> reciprocal, Float blur) {
  return {TreeAxis<Float>(origin.x, reciprocal.x, blur),
          TreeAxis<Float>(origin.y, reciprocal.y, blur),
          TreeAxis<Float>(origin.z, reciprocal.z, blur)};
}

using NodeLanes = Lanes<float, static_cast<int>(kNodeWidth)>;

// One ray and the boxes of a node in lanes.
class TreeRay {
 public:
  explicit TreeRay(const TreeAxes<float>& axes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const TreeAxis<float>& from = axes[axis];
      const bool backwards = from.inverse < 0;
      inverse_[axis] = from.inverse;
      near_side_[axis] = backwards ? TreeNode::kMax : TreeNode::kMin;
      near_origin_[axis] = backwards ? from.high_origin : from.low_origin;
      far_origin_[axis] = backwards ? from.low_origin : from.high_origin;
    }
  }

  // Where the ray enters the children's boxes, and which of them it meets in [0, to].
  struct Met {
    NodeLanes near;
    NodeLanes::Mask mask;
  };
  Met meet(const TreeNode& node, float to) const {
    NodeLanes near(0), far(to);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& planes = node.planes[axis];
      const NodeLanes near_plane = NodeLanes::load(planes[near_side_[axis]].data());
      const NodeLanes far_plane = NodeLanes::load(planes[1 - near_side_[axis]].data());
      near = larger(near, (near_plane - near_origin_[axis]) * inverse_[axis]);
      far = smaller(far, (far_plane - far_origin_[axis]) * inverse_[axis]);
    }
    return {near, near <= far};
  }

 private:
  std::array<float, 3> inverse_, near_origin_, far_origin_;
  std::array<std::size_t, 3> near_side_;
};

}  // namespace alhazen::render

// render/accel: lanes of rays through a tree.
#pragma once

#include <algorithm>

#include "render/accel/lane_targets.h"
#include "render/accel/packet_ray.h"
#include "render/accel/shape_tree.h"
#include "render/accel/tree_walk.h"

namespace alhazen::render {

// Rays go on into a node alone where no more than one in so many of the packet's does; and from the
// start if they scatter, in a tree of more nodes than a few. Measured: docs/acceleration.md.
inline constexpr int kLonely = 4;
inline constexpr std::size_t kFewNodes = 8;

template <class L, class Query, class Targets>
class PacketWalk {
 public:
  using Real = ScalarOf<L>;
  using Mask = MaskOf<L>;
  using Int = IntOf<L>;
  using Float = TreeNumberOf<L>;
  using FloatMask = MaskOf<Float>;

  PacketWalk(const ShapeTree<Real>& tree, const Query& query, Targets& targets)
      : tree_(tree),
        query_(query),
        targets_(targets),
        // Shapes that a lane is not tested against on its way.
        left_(select(query.from.face == Int(kNoFace), Int(-1), query.from.shape)) {}

  void run() {
    leave();
    for (const ShapeId id : tree_.outside())
      consider(id, targets_.wanting());
    const std::span<const TreeNode> nodes = tree_.nodes();
    if (nodes.empty() || !any(targets_.wanting())) return;
    const auto way = approach(tree_.frame(), query_.ray, targets_.start(), targets_.limit());
    if (const Mask lost = way.lost && targets_.wanting(); any(lost)) {
      for (ShapeId id = 0; id < tree_.table().size(); ++id) {
        if (!tree_.table().twins().is_hidden(id)) consider(id, lost && targets_.wanting());
      }
    }
    if (any(way.enters && targets_.wanting())) descend(nodes, way);
  }

 private:
  // The shape that a ray departs from comes first: its kernel knows the root at the start. A ray
  // that goes above a face has left for good, for every shape is convex or flat.
  void leave() {
    const Mask own = targets_.wanting() && left_ != Int(-1) && left_ != query_.ignored &&
                     query_.from.side != Int(static_cast<int>(Side::kAbove));
    if (!any(own)) return;
    take(tree_.table().template own_crossings<L>(left_, query_.ray, query_.from.face,
                                                 query_.from.side, own),
         left_, own);
  }

  void consider(ShapeId id, Mask lanes) {
    const Int shape(static_cast<ScalarOf<Int>>(id));
    const Mask wanting = lanes && left_ != shape && query_.ignored != shape;
    if (any(wanting)) take(tree_.table().crossings(id, query_.ray), shape, wanting);
  }

  void take(const CrossingPair<L>& pair, const Int& shape, Mask lanes) {
    take(pair.near, shape, lanes && pair.has_near);
    take(pair.far, shape, lanes && pair.has_far);
  }
  void take(const Crossing<L>& crossing, const Int& shape, Mask exists) {
    const Mask wanted = exists && targets_.may_take(crossing.t);
    if (!any(wanted)) return;
    targets_.take(
        {crossing.t, shape, crossing.face, crossing.enters, query_.ahead(shape, crossing, wanted)});
  }

  // The lanes that are still under way, at the times by which they have to arrive.
  Float ends(const Approach<L>& way) const {
    const Float end = way.clock.until(targets_.limit());
    return select(FloatMask::from_bits((way.enters && targets_.wanting()).bits()), end, Float(-1));
  }
  void descend(std::span<const TreeNode> nodes, const Approach<L>& way) {
    struct Waiting {
      float near;
      std::uint32_t parent, place;
    };
    std::array<Waiting, (kNodeWidth - 1) * kDeepestSplit + kNodeWidth> stack;
    std::size_t waiting = 0;
    Float end = ends(way);
    float latest = greatest_of(end);
    const EachRay<Float> each(way.origin, way.inverse, way.blur);
    const AllRays all(each, end >= Float(0));
    const auto open = [&](std::uint32_t index) {
      const TreeNode& node = nodes[index];
      const AllRays::Met met = all.meet(node, latest);
      std::array<float, kNodeWidth> near;
      met.near.store(near.data());
      const std::size_t bottom = waiting;
      for_each_lane(met.mask, [&](int lane) {
        // The nearest on top.
        const auto k = static_cast<std::size_t>(lane);
        std::size_t at = waiting++;
        for (; at > bottom && stack[at - 1].near < near[k]; --at)
          stack[at] = stack[at - 1];
        stack[at] = {near[k], index, static_cast<std::uint32_t>(k)};
      });
    };
    if (all.scatter() && nodes.size() > kFewNodes) {
      const Mask lanes = Mask::from_bits((end >= Float(0)).bits());
      for_each_lane(lanes, [&](int lane) { go_alone(nodes, TreeChild::node(0), way, lane); });
      return;
    }
    open(0);
    while (waiting > 0) {
      const Waiting next = stack[--waiting];
      if (next.near > latest) continue;
      const TreeNode& parent = nodes[next.parent];
      const Mask lanes = Mask::from_bits(each.meet(parent, next.place, end).bits());
      if (!any(lanes)) continue;
      const TreeChild child = parent.children[next.place];
      if (child.is_shape()) {
        consider(child.index(), lanes);
      } else if (count(lanes) <= std::max(1, L::kWidth / kLonely)) {
        for_each_lane(lanes, [&](int lane) { go_alone(nodes, child, way, lane); });
      } else {
        open(child.index());
        continue;
      }
      end = ends(way);
      latest = greatest_of(end);
      if (latest < 0) return;
    }
  }

  void go_alone(std::span<const TreeNode> nodes, TreeChild root, const Approach<L>& way, int lane) {
    const Ray<Real> ray = one_ray(query_.ray, lane);
    const TreeRay tree_ray({way.origin.x[lane], way.origin.y[lane], way.origin.z[lane]},
                           {way.inverse.x[lane], way.inverse.y[lane], way.inverse.z[lane]},
                           way.blur[lane]);
    const TreeClock<Real> clock{way.clock.start[lane], way.clock.speed[lane]};
    typename Targets::One one(targets_, lane);
    const auto left = static_cast<ShapeId>(left_[lane]),
               ignored = static_cast<ShapeId>(query_.ignored[lane]);
    walk(nodes, root, tree_ray, clock, one.limit(), [&](ShapeId id) {
      if (id == left || id == ignored) return true;
      return for_each_hit(tree_.table(), ray, query_.source_of(lane), one.limit(), id,
                          [&](const Hit<Real>& hit) { return one.take(hit); });
    });
  }

  const ShapeTree<Real>& tree_;
  const Query& query_;
  Targets& targets_;
  Int left_;
};

template <class L, class SourceOf, class Targets>
inline void find(const ShapeTree<ScalarOf<L>>& tree, const LaneQuery<L, SourceOf>& query,
                 Targets& targets) {
  PacketWalk<L, LaneQuery<L, SourceOf>, Targets>(tree, query, targets).run();
}

}  // namespace alhazen::render

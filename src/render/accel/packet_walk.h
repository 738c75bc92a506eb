// render/accel: lanes of rays through a tree.
#pragma once

#include <algorithm>

#include "render/accel/bounds_tree.h"
#include "render/accel/lane_targets.h"
#include "render/accel/packet_ray.h"

namespace alhazen::render {

// Rays go on into a node alone where no more than one in so many of the packet's does; and from the
// start if they scatter, in a tree of more boxes than a few. Measured: docs/acceleration.md.
inline constexpr int kLonely = 4;
inline constexpr std::size_t kFewNodes = 64 / kNodeWidth;

// `items` are what the tree has boxes of: items.meet(item, lanes) tests one against several rays,
// items.alone(lane).meet(item, one) against the ray of a lane, until it is false.
template <class L, class Items, class Targets>
class PacketWalk {
 public:
  using Real = ScalarOf<L>;
  using Mask = MaskOf<L>;
  using Float = TreeNumberOf<L>;
  using FloatMask = MaskOf<Float>;

  // The rays in the frame of the tree, those of `among` only.
  PacketWalk(const BoundsTree<Real>& tree, const Ray<L>& ray, const Items& items, Targets& targets,
             Mask among = true)
      : tree_(tree), ray_(ray), items_(items), targets_(targets), among_(among) {}

  void run() {
    for (const std::uint32_t item : tree_.outside())
      items_.meet(item, wanting());
    const std::span<const TreeNode> nodes = tree_.nodes();
    if (nodes.empty() || !any(wanting())) return;
    const auto way = approach(tree_.frame(), ray_, targets_.start(), targets_.limit());
    if (const Mask lost = way.lost && wanting(); any(lost)) {
      tree_.for_each_inside([&](std::uint32_t item) {
        items_.meet(item, lost && wanting());
        return true;
      });
    }
    if (any(way.enters && wanting())) descend(nodes, way);
  }

 private:
  Mask wanting() const { return among_ && targets_.wanting(); }

  // The lanes that are still under way, at the times by which they have to arrive.
  Float ends(const Approach<L>& way) const {
    const Float end = way.clock.until(targets_.limit());
    return select(FloatMask::from_bits((way.enters && wanting()).bits()), end, Float(-1));
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
      for_each_lane(lanes,
                    [&](int lane) { go_alone(nodes, TreeChild::node(0), way.clock, each, lane); });
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
        items_.meet(child.index(), lanes);
      } else if (count(lanes) <= std::max(1, L::kWidth / kLonely)) {
        for_each_lane(lanes, [&](int lane) { go_alone(nodes, child, way.clock, each, lane); });
      } else {
        open(child.index());
        continue;
      }
      end = ends(way);
      latest = greatest_of(end);
      if (latest < 0) return;
    }
  }

  void go_alone(std::span<const TreeNode> nodes, TreeChild root, const TreeClock<L>& all,
                const EachRay<Float>& each, int lane) {
    const TreeClock<Real> clock{all.start[lane], all.speed[lane]};
    typename Targets::One one(targets_, lane);
    const auto alone = items_.alone(lane);
    walk(nodes, root, each.one(lane), clock, one.limit(),
         [&](std::uint32_t item) { return alone.meet(item, one); });
  }

  const BoundsTree<Real>& tree_;
  const Ray<L>& ray_;
  const Items& items_;
  Targets& targets_;
  Mask among_;
};

}  // namespace alhazen::render

// render/accel: packets of rays and the instances of a scene: rays that meet an instance's box go
// on in the frame of its prototype, together.
#pragma once

#include "render/accel/instance_hits.h"
#include "render/accel/shape_lanes.h"

namespace alhazen::render {

// For PacketWalk.
template <class L, class Query, class Targets>
class InstanceItems {
 public:
  using Real = ScalarOf<L>;

  InstanceItems(const WorldTree<Real>& tree, const Query& query, Targets& targets)
      : tree_(tree), query_(query), targets_(targets) {}

  void meet(InstanceId instance, MaskOf<L> lanes) const {
    const ShapeId first = tree_.shapes().index().first(instance);
    const Ray<L> own = convert<L>(tree_.shapes().placement(instance)).in_object(query_.ray);
    walk_shapes(tree_.prototype_of(instance), own, query_, targets_, lanes,
                [first](ShapeId number) { return first + number; });
  }

  struct Alone {
    const WorldTree<Real>& tree;
    Ray<Real> ray;
    Source source;
    Real start;
    ShapeId ignored;

    template <class One>
    bool meet(InstanceId instance, One& one) const {
      return for_each_hit_of_instance(tree, instance, ray, source, start, one.limit(), ignored,
                                      [&](const Hit<Real>& hit) { return one.take(hit); });
    }
  };
  Alone alone(int lane) const {
    return {tree_, one_ray(query_.ray, lane), query_.source_of(lane), targets_.start()[lane],
            static_cast<ShapeId>(query_.ignored[lane])};
  }

 private:
  const WorldTree<Real>& tree_;
  const Query& query_;
  Targets& targets_;
};

// Out of line: a scene without instances is not to carry it along.
template <class L, class Query, class Targets>
[[gnu::noinline]] void find_among_instances(const WorldTree<ScalarOf<L>>& tree, const Query& query,
                                            Targets& targets) {
  leave<L>(query, targets);
  walk_shapes(tree.singles(), query.ray, query, targets, MaskOf<L>(true),
              [&tree](ShapeId number) { return tree.id_of_single(number); });
  if (!any(targets.wanting())) return;
  using Items = InstanceItems<L, Query, Targets>;
  const Items items(tree, query, targets);
  PacketWalk<L, Items, Targets>(tree.instances(), query.ray, items, targets).run();
}

template <class L, class Query, class Targets>
inline void find(const WorldTree<ScalarOf<L>>& tree, const Query& query, Targets& targets) {
  if (tree.shapes().has_instances()) {
    find_among_instances<L>(tree, query, targets);
  } else {
    find<L>(tree.singles(), query, targets);
  }
}

template <class Real>
inline const ShapeTable<Real>& shapes_of(const ShapeTree<Real>& tree) {
  return tree.table();
}
template <class Real>
inline const WorldShapes<Real>& shapes_of(const WorldTree<Real>& tree) {
  return tree.shapes();
}

}  // namespace alhazen::render

// render/accel: packets of rays and the shapes of one tree.
#pragma once

#include "render/accel/packet_walk.h"
#include "render/accel/shape_hits.h"
#include "render/accel/shape_tree.h"

namespace alhazen::render {

// The ids of a table's shapes where they are those of the scene.
struct SameIds {
  ShapeId operator()(ShapeId number) const { return number; }
};

// Of a table, for PacketWalk. The rays are in the table's frame; the query's are those that were
// asked about. id_of(number) gives a shape's id.
template <class L, class Query, class Targets, class IdOf>
class ShapeItems {
 public:
  using Real = ScalarOf<L>;

  ShapeItems(const ShapeTable<Real>& table, const Ray<L>& ray, const Query& query, Targets& targets,
             IdOf id_of)
      : table_(table), ray_(ray), query_(query), targets_(targets), id_of_(id_of) {}

  void meet(ShapeId number, MaskOf<L> lanes) const {
    const ShapeId id = id_of_(number);
    const MaskOf<L> asking = query_.asking(id, lanes);
    if (!any(asking)) return;
    query_.give(table_.crossings(number, ray_), IntOf<L>(static_cast<ScalarOf<IntOf<L>>>(id)),
                asking, targets_);
  }

  struct Alone {
    const ShapeItems& items;
    int lane;
    Ray<Real> own;
    ShapeId left, ignored;

    template <class One>
    bool meet(ShapeId number, One& one) const {
      const ShapeId id = items.id_of_(number);
      if (id == left || id == ignored) return true;
      for (const Crossing<Real>& c : items.table_.crossings(number, own, Departure())) {
        if (!(c.t <= one.limit())) continue;
        if (c.t == Real(0) && !items.query_.is_ahead(lane, id, c)) continue;
        if (!one.take(Hit<Real>{c.t, id, c.face, c.enters})) return false;
      }
      return true;
    }
  };
  Alone alone(int lane) const {
    return {*this, lane, one_ray(ray_, lane), static_cast<ShapeId>(query_.left[lane]),
            static_cast<ShapeId>(query_.ignored[lane])};
  }

 private:
  const ShapeTable<Real>& table_;
  const Ray<L>& ray_;
  const Query& query_;
  Targets& targets_;
  IdOf id_of_;
};

template <class L, class Query, class Targets, class IdOf>
inline void walk_shapes(const ShapeTree<ScalarOf<L>>& tree, const Ray<L>& ray, const Query& query,
                        Targets& targets, MaskOf<L> among, IdOf id_of) {
  using Items = ShapeItems<L, Query, Targets, IdOf>;
  const Items items(tree.table(), ray, query, targets, id_of);
  PacketWalk<L, Items, Targets>(tree, ray, items, targets, among).run();
}

// The shape that a ray departs from comes first: its kernel knows the root at the start. A ray that
// goes above a face has left for good, for every shape is convex or flat.
template <class L, class Query, class Targets>
inline void leave(const Query& query, Targets& targets) {
  using Int = IntOf<L>;
  const MaskOf<L> own = targets.wanting() && query.left != Int(-1) && query.left != query.ignored &&
                        query.from.side != Int(static_cast<int>(Side::kAbove));
  if (!any(own)) return;
  query.give(query.shapes.template own_crossings<L>(query.left, query.ray, query.from.face,
                                                    query.from.side, own),
             query.left, own, targets);
}

template <class L, class Query, class Targets>
inline void find(const ShapeTree<ScalarOf<L>>& tree, const Query& query, Targets& targets) {
  leave<L>(query, targets);
  walk_shapes(tree, query.ray, query, targets, MaskOf<L>(true), SameIds());
}

}  // namespace alhazen::render

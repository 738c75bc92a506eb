#include "render/accel/shape_tree.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/base/parallel.h"
#include "render/accel/shape_hits.h"
#include "render/accel/tree_build.h"
#include "render/accel/tree_walk.h"
#include "render/accel/twin_hits.h"

namespace alhazen::render {
namespace {

// A shape whose reach is more roundings than this (a cone, a map that nearly is singular) is kept
// from making every other box larger: its own is grown for all rays that start within the tree's
// radius. A choice of cost alone: either way the boxes hold every hit.
constexpr int kCommonRoundings = 4096;
constexpr std::size_t kShapesAtOnce = 4096;  // whose bounds one thread computes

template <class Real>
constexpr Real kCommonReach = Real(kCommonRoundings) * ScalarTraits<Real>::unit_roundoff();

template <class Real>
Real size_of(const ShapeBounds<Real>& bounds) {
  return larger(largest_coordinate(bounds.min), largest_coordinate(bounds.max));
}

// Nothing where they serve for no box.
template <class Real>
std::optional<ShapeBounds<Real>> useful_bounds(const ShapeTable<Real>& table, ShapeId id) {
  auto bounds = table.bounds(id);
  if (bounds && is_finite(bounds->min) && is_finite(bounds->max) && bounds->reach < Real(1) &&
      is_ordinary(size_of(*bounds))) {
    return bounds;
  }
  return std::nullopt;
}

// What has to be known of all shapes before the first box.
template <class Real>
struct Survey {
  Real start_radius = 0;
  Real near_reach = Real(8) * ScalarTraits<Real>::unit_roundoff(), far_reach = 0;
  std::vector<ShapeId> outside;
  std::size_t inside = 0;

  void add(ShapeId id, const std::optional<ShapeBounds<Real>>& bounds) {
    if (!bounds) {
      outside.push_back(id);
      return;
    }
    ++inside;
    start_radius = larger(start_radius, size_of(*bounds));
    far_reach = larger(far_reach, bounds->reach);
    if (bounds->reach <= kCommonReach<Real>) near_reach = larger(near_reach, bounds->reach);
  }
  void add(const Survey& other) {
    start_radius = larger(start_radius, other.start_radius);
    near_reach = larger(near_reach, other.near_reach);
    far_reach = larger(far_reach, other.far_reach);
    outside.insert(outside.end(), other.outside.begin(), other.outside.end());
    inside += other.inside;
  }
};

// Calls work(k, first, last) for each run of shapes [first, last), the k-th.
template <class Work>
void for_runs(int threads, ShapeId shapes, const Work& work) {
  const std::size_t runs = (shapes + kShapesAtOnce - 1) / kShapesAtOnce;
  in_parallel(threads, runs, [&](std::size_t k) {
    const std::size_t first = k * kShapesAtOnce;
    work(k, static_cast<ShapeId>(first),
         static_cast<ShapeId>(std::min<std::size_t>(first + kShapesAtOnce, shapes)));
  });
}

}  // namespace

template <class Real>
ShapeTree<Real>::ShapeTree(const ShapeTable<Real>& table, int threads) : table_(&table) {
  std::vector<Survey<Real>> surveys(table.size() / kShapesAtOnce + 1);
  for_runs(threads, table.size(), [&](std::size_t k, ShapeId first, ShapeId last) {
    for (ShapeId id = first; id < last; ++id) {
      if (!table.twins().is_hidden(id)) surveys[k].add(id, useful_bounds(table, id));
    }
  });
  Survey<Real> all;
  std::vector<std::size_t> inside_before;
  for (const Survey<Real>& survey : surveys) {
    inside_before.push_back(all.inside);
    all.add(survey);
  }
  outside_ = std::move(all.outside);
  if (all.inside == 0) return;
  // A grown box may be twice as far away.
  frame_ = {all.start_radius,
            all.near_reach,
            all.far_reach,
            units_per_length(Real(2) * all.start_radius),
            {},
            {}};
  std::vector<NumberedBox> boxes(all.inside);
  for_runs(threads, table.size(), [&](std::size_t k, ShapeId first, ShapeId last) {
    std::size_t place = inside_before[k];
    for (ShapeId id = first; id < last; ++id) {
      if (table.twins().is_hidden(id)) continue;
      const auto bounds = useful_bounds(table, id);
      if (!bounds) continue;
      const Real by =
          bounds->reach <= kCommonReach<Real> ? Real(0) : bounds->reach * frame_.start_radius;
      const Vec3<Real> margin{by, by, by};
      boxes[place++] = {tree_box(bounds->min - margin, bounds->max + margin, frame_.units), id};
    }
  });
  if (boxes.size() == 1) {  // its kernel alone costs less
    outside_.insert(std::lower_bound(outside_.begin(), outside_.end(), boxes[0].number),
                    boxes[0].number);
    return;
  }
  TreeBox around;
  for (const NumberedBox& box : boxes)
    around.add(box.box);
  for (int axis = 0; axis < 3; ++axis) {
    frame_.min[axis] = static_cast<Real>(around.min(axis)) / frame_.units;
    frame_.max[axis] = static_cast<Real>(around.max(axis)) / frame_.units;
  }
  nodes_ = build_tree(std::move(boxes), threads);
}

template <class Real>
std::size_t ShapeTree<Real>::bytes() const {
  return nodes_.size() * sizeof(TreeNode) + outside_.size() * sizeof(ShapeId);
}

template <class Real>
template <class Consider>
void ShapeTree<Real>::visit(const Ray<Real>& ray, const Source& source, Real from, const Real& to,
                            ShapeId ignored, const Consider& consider) const {
  if (source.shape < table_->size() && source.shape != ignored && !consider(source.shape)) return;
  const auto offer = [&](ShapeId id) {
    return id == source.shape || id == ignored || consider(id);
  };
  for (const ShapeId id : outside_) {
    if (!offer(id)) return;
  }
  if (nodes_.empty()) return;
  const Approach<Real> way = approach(frame_, ray, from, to);
  if (way.lost) {
    for (ShapeId id = 0; id < table_->size(); ++id) {
      if (!table_->twins().is_hidden(id) && !offer(id)) return;
    }
  }
  if (!way.enters) return;
  walk(std::span(nodes_), TreeChild::node(0), TreeRay(way.origin, way.inverse, way.blur), way.clock,
       to, offer);
}

namespace {

// Of shapes that stand in for others, and those without a twin.
template <class Real>
std::optional<Hit<Real>> first_of(const ShapeTree<Real>& tree, const Ray<Real>& ray,
                                  const Source& source, Real t_max, ShapeId ignored,
                                  const Hit<Real>* previous) {
  std::optional<Hit<Real>> best;
  Real to = t_max;
  const Real from = previous == nullptr ? Real(0) : previous->t;
  tree.visit(ray, source, from, to, ignored, [&](ShapeId id) {
    return for_each_hit(tree.table(), ray, source, t_max, id, [&](const Hit<Real>& hit) {
      const bool late = previous == nullptr || precedes(*previous, hit);
      if (late && (!best || precedes(hit, *best))) {
        best = hit;
        to = hit.t;
      }
      return true;
    });
  });
  return best;
}

}  // namespace

template <class Real>
std::optional<Hit<Real>> closest_hit(const ShapeTree<Real>& tree, const Ray<Real>& ray,
                                     const Source& source, Real t_max, ShapeId ignored) {
  return closest_layer(tree.table(), ray, source, ignored,
                       [&](const Source& from, ShapeId without) {
                         return first_of<Real>(tree, ray, from, t_max, without, nullptr);
                       });
}

template <class Real>
std::optional<Hit<Real>> next_hit(const ShapeTree<Real>& tree, const Ray<Real>& ray,
                                  const Source& source, const Hit<Real>& previous, Real t_max,
                                  ShapeId ignored) {
  return next_layer(tree.table(), ray, source, previous, ignored,
                    [&](const Source& from, const Hit<Real>* last, ShapeId without) {
                      return first_of(tree, ray, from, t_max, without, last);
                    });
}

template <class Real>
bool any_hit(const ShapeTree<Real>& tree, const Ray<Real>& ray, const Source& source, Real t_max,
             ShapeId ignored) {
  return any_layer(tree.table(), ray, source, ignored, [&](const Source& from, ShapeId without) {
    bool found = false;
    tree.visit(ray, from, Real(0), t_max, without, [&](ShapeId id) {
      found =
          !for_each_hit(tree.table(), ray, from, t_max, id, [](const Hit<Real>&) { return false; });
      return !found;
    });
    return found;
  });
}

template class ShapeTree<float>;
template std::optional<Hit<float>> closest_hit(const ShapeTree<float>&, const Ray<float>&,
                                               const Source&, float, ShapeId);
template std::optional<Hit<float>> next_hit(const ShapeTree<float>&, const Ray<float>&,
                                            const Source&, const Hit<float>&, float, ShapeId);
template bool any_hit(const ShapeTree<float>&, const Ray<float>&, const Source&, float, ShapeId);
template class ShapeTree<double>;
template std::optional<Hit<double>> closest_hit(const ShapeTree<double>&, const Ray<double>&,
                                                const Source&, double, ShapeId);
template std::optional<Hit<double>> next_hit(const ShapeTree<double>&, const Ray<double>&,
                                             const Source&, const Hit<double>&, double, ShapeId);
template bool any_hit(const ShapeTree<double>&, const Ray<double>&, const Source&, double, ShapeId);
#if ALHAZEN_HAS_QUAD
template class ShapeTree<Quad>;
template std::optional<Hit<Quad>> closest_hit(const ShapeTree<Quad>&, const Ray<Quad>&,
                                              const Source&, Quad, ShapeId);
template std::optional<Hit<Quad>> next_hit(const ShapeTree<Quad>&, const Ray<Quad>&, const Source&,
                                           const Hit<Quad>&, Quad, ShapeId);
template bool any_hit(const ShapeTree<Quad>&, const Ray<Quad>&, const Source&, Quad, ShapeId);
#endif

}  // namespace alhazen::render

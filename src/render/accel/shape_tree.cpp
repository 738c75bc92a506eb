#include "render/accel/shape_tree.h"

#include <algorithm>
#include <utility>

#include "render/accel/shape_hits.h"
#include "render/accel/tree_ray.h"

namespace alhazen::render {
namespace {

// A shape whose reach is more roundings than this (a cone, a map that nearly is singular) is kept
// from making every other box larger: its own is grown for all rays that start within the tree's
// radius. A choice of cost alone: either way the boxes hold every hit.
constexpr int kCommonRoundings = 4096;

template <class Real>
Real size_of(const TreeBox<Real>& box) {
  return larger(largest_coordinate(box.min), largest_coordinate(box.max));
}

template <class Real>
bool is_useful(const ShapeBounds<Real>& bounds) {
  return is_finite(bounds.min) && is_finite(bounds.max) && bounds.reach < Real(1) &&
         is_ordinary(size_of(TreeBox<Real>{bounds.min, bounds.max}));
}

}  // namespace

template <class Real>
ShapeTree<Real>::ShapeTree(const ShapeTable<Real>& table) : table_(&table) {
  std::vector<NumberedBox<Real>> boxes;
  for (ShapeId id = 0; id < table.size(); ++id) {
    const auto bounds = table.bounds(id);
    if (!bounds || !is_useful(*bounds)) {
      outside_.push_back(id);
      continue;
    }
    const TreeBox<Real> box{bounds->min, bounds->max};
    start_radius_ = larger(start_radius_, size_of(box));
    boxes.push_back({box, id});
  }
  if (boxes.size() == 1) {  // its kernel alone costs less
    outside_.insert(std::lower_bound(outside_.begin(), outside_.end(), boxes[0].number),
                    boxes[0].number);
    return;
  }
  const Real u = ScalarTraits<Real>::unit_roundoff();
  near_reach_ = Real(8) * u;
  for (NumberedBox<Real>& box : boxes) {
    const Real reach = table.bounds(box.number)->reach;
    far_reach_ = larger(far_reach_, reach);
    if (reach <= Real(kCommonRoundings) * u) {
      near_reach_ = larger(near_reach_, reach);
    } else {
      const Real by = reach * start_radius_;
      box.box.min = box.box.min - Vec3<Real>(by, by, by);
      box.box.max = box.box.max + Vec3<Real>(by, by, by);
    }
  }
  TreeNodes<Real> built = build_tree(std::move(boxes));
  nodes_ = std::move(built.nodes);
  shapes_ = std::move(built.leaves);
}

template <class Real>
std::size_t ShapeTree<Real>::bytes() const {
  return nodes_.size() * sizeof(nodes_[0]) + (shapes_.size() + outside_.size()) * sizeof(ShapeId);
}

template <class Real>
Real ShapeTree<Real>::margin_of(Vec3<Real> origin) const {
  const Real distance = largest_coordinate(origin);
  return (distance <= start_radius_ ? near_reach_ : far_reach_) * distance;
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
  if (is_ordinary(largest_coordinate(ray.direction)) &&
      largest_coordinate(ray.origin) <= largest_ordinary<Real>()) {
    visit_nodes(ray, from, to, offer);
    return;
  }
  for (const ShapeId id : shapes_) {
    if (!offer(id)) return;
  }
}

template <class Real>
template <class Consider>
void ShapeTree<Real>::visit_nodes(const Ray<Real>& ray, Real from, const Real& to,
                                  const Consider& consider) const {
  if (nodes_.empty()) return;
  struct Waiting {
    Real near;
    std::uint32_t child, count;  // as in TreeNode
  };
  // Each node on the way down leaves at most all of its children but one.
  std::array<Waiting, (kNodeWidth - 1) * kDeepestSplit + kNodeWidth> stack;
  const TreeRay<Real> tree_ray(ray, margin_of(ray.origin));
  stack[0] = {from, 0, 0};
  std::size_t waiting = 1;
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.near > to) continue;
    if (next.count > 0) {
      for (std::uint32_t i = next.child; i < next.child + next.count; ++i) {
        if (!consider(shapes_[i])) return;
      }
      continue;
    }
    const TreeNode<Real>& node = nodes_[next.child];
    const auto spans = tree_ray.spans(node, from, to);
    const std::size_t bottom = waiting;
    for (std::size_t k = 0; k < kNodeWidth; ++k) {
      if (spans.near[k] > spans.far[k]) continue;
      // The nearest on top.
      std::size_t place = waiting++;
      for (; place > bottom && stack[place - 1].near < spans.near[k]; --place)
        stack[place] = stack[place - 1];
      stack[place] = {spans.near[k], node.child[k], node.count[k]};
    }
  }
}

template <class Real>
std::optional<Hit<Real>> closest_hit(const ShapeTree<Real>& tree, const Ray<Real>& ray,
                                     const Source& source, Real t_max, ShapeId ignored) {
  std::optional<Hit<Real>> best;
  Real to = t_max;
  tree.visit(ray, source, Real(0), to, ignored, [&](ShapeId id) {
    return for_each_hit(tree.table(), ray, source, t_max, id, [&](const Hit<Real>& hit) {
      if (!best || precedes(hit, *best)) {
        best = hit;
        to = hit.t;
      }
      return true;
    });
  });
  return best;
}

template <class Real>
std::optional<Hit<Real>> next_hit(const ShapeTree<Real>& tree, const Ray<Real>& ray,
                                  const Source& source, const Hit<Real>& previous, Real t_max,
                                  ShapeId ignored) {
  std::optional<Hit<Real>> best;
  Real to = t_max;
  tree.visit(ray, source, previous.t, to, ignored, [&](ShapeId id) {
    return for_each_hit(tree.table(), ray, source, t_max, id, [&](const Hit<Real>& hit) {
      if (precedes(previous, hit) && (!best || precedes(hit, *best))) {
        best = hit;
        to = hit.t;
      }
      return true;
    });
  });
  return best;
}

template <class Real>
bool any_hit(const ShapeTree<Real>& tree, const Ray<Real>& ray, const Source& source, Real t_max,
             ShapeId ignored) {
  bool found = false;
  tree.visit(ray, source, Real(0), t_max, ignored, [&](ShapeId id) {
    found =
        !for_each_hit(tree.table(), ray, source, t_max, id, [](const Hit<Real>&) { return false; });
    return !found;
  });
  return found;
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

// render/shape: the members of WorldShapes (world_shapes.h, which includes this) whose lanes have a
// shape each. Lanes of one prototype go on together, however many instances they have met.
#pragma once

#include "render/shape/world_shapes.h"

namespace alhazen::render {

template <class Real>
template <class L, class Work>
void WorldShapes<Real>::for_each_table(const IntOf<L>& shape, const MaskOf<L>& active,
                                       const Work& work) const {
  using Int = IntOf<L>;
  using One = ScalarOf<Int>;
  constexpr One kSingle = -1;
  std::array<One, L::kWidth> numbers{}, instances{}, tables{};
  for_each_lane(active, [&](int i) {
    const InstanceIndex::Place place = index_.locate(static_cast<ShapeId>(shape[i]));
    const auto lane = static_cast<std::size_t>(i);
    const bool is_single = place.instance == kNoId;
    numbers[lane] = static_cast<One>(place.number);
    instances[lane] = is_single ? 0 : static_cast<One>(place.instance);
    tables[lane] = is_single ? kSingle : static_cast<One>(prototype_of_[place.instance]);
  });
  const Int number = Int::load(numbers.data()), instance = Int::load(instances.data()),
            table = Int::load(tables.data());
  for (MaskOf<L> left = active; any(left);) {
    const auto first = static_cast<std::size_t>(__builtin_ctz(left.bits()));
    const MaskOf<L> same = left && table == Int(tables[first]);
    left = left && !same;
    if (tables[first] == kSingle) {
      work(singles_, number, static_cast<const Placement<L>*>(nullptr), same);
      continue;
    }
    const auto one = static_cast<std::size_t>(instances[first]);
    const Placement<L> place =
        all(instance == Int(instances[first]) || !same)
            ? convert<L>(placements_[one])
            : gathered_kernel<L, Placement>(placements_.data(), instance, same);
    work(prototypes_[static_cast<std::size_t>(tables[first])], number, &place, same);
  }
}

template <class Real>
template <class L>
CrossingPair<L> WorldShapes<Real>::own_crossings(const IntOf<L>& shape, const Ray<L>& ray,
                                                 const IntOf<L>& face, const IntOf<L>& side,
                                                 const MaskOf<L>& active) const {
  if (!has_instances()) {
    return singles_.template own_crossings<L>(shape, ray, face, side, active);
  }
  CrossingPair<L> result;
  for_each_table<L>(shape, active,
                    [&](const ShapeTable<Real>& table, const IntOf<L>& number,
                        const Placement<L>* place, const MaskOf<L>& mask) {
                      const Ray<L> own = place == nullptr ? ray : place->in_object(ray);
                      const auto found =
                          table.template own_crossings<L>(number, own, face, side, mask);
                      result = select(mask, found, result);
                    });
  return result;
}

template <class Real>
template <bool with_coordinates, class L>
SurfacePoint<L> WorldShapes<Real>::surface_of_each(const IntOf<L>& shape, const Ray<L>& ray,
                                                   const Crossing<L>& crossing,
                                                   const MaskOf<L>& active) const {
  const auto in_table = [&](const ShapeTable<Real>& table, const IntOf<L>& number,
                            const Ray<L>& own, const MaskOf<L>& mask) {
    if constexpr (with_coordinates) {
      return table.template surface<L>(number, own, crossing, mask);
    } else {
      return table.template plain_surface<L>(number, own, crossing, mask);
    }
  };
  if (!has_instances()) return in_table(singles_, shape, ray, active);
  SurfacePoint<L> points;
  for_each_table<L>(shape, active,
                    [&](const ShapeTable<Real>& table, const IntOf<L>& number,
                        const Placement<L>* place, const MaskOf<L>& mask) {
                      const SurfacePoint<L> found =
                          place == nullptr
                              ? in_table(table, number, ray, mask)
                              : out_of_group(in_table(table, number, place->in_object(ray), mask),
                                             *place);
                      points = select(mask, found, points);
                    });
  return points;
}

template <class Real>
template <class L>
SurfacePoint<L> WorldShapes<Real>::surface(const IntOf<L>& shape, const Ray<L>& ray,
                                           const Crossing<L>& crossing,
                                           const MaskOf<L>& active) const {
  return surface_of_each<true>(shape, ray, crossing, active);
}

template <class Real>
template <class L>
SurfacePoint<L> WorldShapes<Real>::plain_surface(const IntOf<L>& shape, const Ray<L>& ray,
                                                 const Crossing<L>& crossing,
                                                 const MaskOf<L>& active) const {
  return surface_of_each<false>(shape, ray, crossing, active);
}

}  // namespace alhazen::render

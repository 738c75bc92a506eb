// render/shape: lanes that each have a shape of their own, sorted out by kind.
#pragma once

#include <array>
#include <vector>

#include "render/shape/convert.h"
#include "render/shape/kernel_arrays.h"

namespace alhazen::render {

// The entries of W shapes side by side.
template <class L>
struct EntryLanes {
  using Mask = MaskOf<L>;
  using Int = IntOf<L>;

  Int kind, index, placement;
  Mask active, placed, in_object_frame;

  EntryLanes(const std::vector<Entry>& entries, const Int& shape, const Mask& active_)
      : active(active_) {
    using One = ScalarOf<Int>;
    std::array<One, L::kWidth> kinds{}, indices{}, placements{};
    std::uint32_t are_placed = 0, are_in_object_frame = 0;
    for_each_lane(active, [&](int i) {
      const Entry& entry = entries[static_cast<std::size_t>(shape[i])];
      const auto lane = static_cast<std::size_t>(i);
      kinds[lane] = static_cast<One>(entry.kind);
      indices[lane] = static_cast<One>(entry.index);
      placements[lane] = static_cast<One>(entry.placement);
      are_placed |= static_cast<std::uint32_t>(entry.is_placed()) << i;
      are_in_object_frame |= static_cast<std::uint32_t>(entry.in_object_frame) << i;
    });
    kind = Int::load(kinds.data());
    index = Int::load(indices.data());
    placement = Int::load(placements.data());
    placed = Mask::from_bits(are_placed);
    in_object_frame = Mask::from_bits(are_in_object_frame);
  }

  // Calls visit(kernels, mask) for each kind that is there: the kernels of the lanes in the mask.
  template <class Visitor>
  void for_each_kind(const KernelArrays<ScalarOf<L>>& arrays, const Visitor& visit) const {
    for (Mask left = active; any(left);) {
      const auto first = kind[__builtin_ctz(left.bits())];
      const Mask same = left && kind == Int(first);
      arrays.visit(static_cast<Kind>(first), [&]<template <class> class Kernel, class Real>(
                                                 const std::vector<Kernel<Real>>& kernels) {
        visit(gathered_kernel<L, Kernel>(kernels.data(), index, same), same);
      });
      left = left && !same;
    }
  }
};

// The shape of all active lanes, if they have one and the same.
template <class L>
inline bool have_one_shape(const IntOf<L>& shape, const MaskOf<L>& active, ShapeId& one) {
  if (!any(active)) return false;
  const auto first = shape[__builtin_ctz(active.bits())];
  one = static_cast<ShapeId>(first);
  return all(shape == IntOf<L>(first) || !active);
}

}  // namespace alhazen::render

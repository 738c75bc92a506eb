// render/shape: lanes that each have a shape of their own, sorted out by kind.
#pragma once

#include <array>
#include <vector>

#include "render/shape/convert.h"
#include "render/shape/kernel_arrays.h"
#include "render/simd/records.h"

namespace alhazen::render {

// The entries of W shapes side by side.
template <class L>
struct EntryLanes {
  using Mask = MaskOf<L>;
  using Int = IntOf<L>;

  Int kind, index, placement;
  Mask active, placed, in_object_frame;

  // An entry is two words, its bit fields from the lowest on: so the ABI of x86-64 lays them out,
  // and the tests of these lanes see to it.
  EntryLanes(const std::vector<Entry>& entries, const Int& shape, const Mask& active_)
      : active(active_) {
    const auto* words = reinterpret_cast<const std::uint32_t*>(entries.data());
    const Int twice = shape + shape;
    index = gathered_words<L>(words, twice, active);
    const Int fields = gathered_words<L>(words, twice + Int(1), active);
    kind = fields & Int(7);
    in_object_frame = active && (fields & Int(8)) != Int(0);
    placement = (fields >> 4) & Int(static_cast<int>(Entry::kNotPlaced));
    placed = active && placement != Int(static_cast<int>(Entry::kNotPlaced));
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

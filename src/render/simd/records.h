// render/simd: records of numbers, of which each lane may want another.
//
// A record is a template on Real that holds nothing but Reals: a colour, the constants of a lobe.
// The record of lanes has the same members, each with its W numbers. Asked for a single number, the
// functions below hand out one record.
#pragma once

#include <bit>
#include <concepts>

#include "render/simd/lanes.h"

namespace alhazen::render {

template <template <class> class Record, class Real>
inline constexpr int kNumbersIn = static_cast<int>(sizeof(Record<Real>) / sizeof(Real));

// The whole number in the first lane of the mask, which is not empty.
template <class Int, int W, int Bytes>
inline Int first_of(const Lanes<Int, W>& index, LaneMask<Bytes, W> active) {
  return index[__builtin_ctz(active.bits())];
}
constexpr int first_of(int index, bool) {
  return index;
}

// Whether all lanes of the mask hold the same whole number; true if there are none.
template <class Int, int W, int Bytes>
inline bool all_same(const Lanes<Int, W>& index, LaneMask<Bytes, W> active) {
  if (!any(active)) return true;
  return !any(active && index != Lanes<Int, W>(first_of(index, active)));
}

// The same record for every lane.
template <class L, template <class> class Record>
inline Record<L> broadcast(const Record<ScalarOf<L>>& record) {
  if constexpr (std::same_as<L, ScalarOf<L>>) {
    return record;
  } else {
    constexpr int kCount = kNumbersIn<Record, L>;
    const auto numbers = std::bit_cast<std::array<ScalarOf<L>, kCount>>(record);
    std::array<L, kCount> members;
    for (int m = 0; m < kCount; ++m)
      members[m] = L(numbers[m]);
    return std::bit_cast<Record<L>>(members);
  }
}

// records[index]; lanes outside of the mask read nothing, and what they get means nothing. Records
// that are members of something larger stand `stride` numbers apart.
template <class L, template <class> class Record>
inline Record<L> gathered(const Record<ScalarOf<L>>* records, const IntOf<L>& index,
                          MaskOf<L> active = true, int stride = kNumbersIn<Record, ScalarOf<L>>) {
  using Scalar = ScalarOf<L>;
  if (!any(active)) return Record<L>{};
  const auto* numbers = reinterpret_cast<const Scalar*>(records);
  const auto record_at = [&](auto i) -> const Record<Scalar>& {
    return *reinterpret_cast<const Record<Scalar>*>(numbers +
                                                    static_cast<std::ptrdiff_t>(i) * stride);
  };
  if constexpr (std::same_as<L, Scalar>) {
    return record_at(index);
  } else {
    if (all_same(index, active)) return broadcast<L, Record>(record_at(first_of(index, active)));
    constexpr int kCount = kNumbersIn<Record, L>;
    static_assert(kCount == kNumbersIn<Record, Scalar>);
    const IntOf<L> first = index * IntOf<L>(stride);
    std::array<L, kCount> members;
    for (int m = 0; m < kCount; ++m)
      members[m] = L::gather(numbers + m, first, active);
    return std::bit_cast<Record<L>>(members);
  }
}

// words[index] as lanes of L's whole numbers, of the same low 32 bits; lanes outside of the mask
// read nothing and are 0.
template <class L>
inline IntOf<L> gathered_words(const std::uint32_t* words, const IntOf<L>& index,
                               MaskOf<L> active) {
  if constexpr (std::same_as<L, ScalarOf<L>>) {
    return active ? static_cast<IntOf<L>>(words[index]) : 0;
  } else {
    using Words = Lanes<std::int32_t, L::kWidth>;
    return IntOf<L>(Words::gather(reinterpret_cast<const std::int32_t*>(words), Words(index),
                                  typename Words::Mask(active)));
  }
}

// The numbers of W lanes, to be dealt out again: each of them to several lanes.
template <class L>
class DealtLanes {
 public:
  explicit DealtLanes(const L& numbers) { numbers.store(numbers_.data()); }
  // Lane i of the result is number from[i].
  template <class Int>
  L to(const Int& from) const {
    if (all_same(from, typename Int::Mask(true))) return L(numbers_[from[0]]);
    return L::gather(numbers_.data(), from);
  }

 private:
  std::array<ScalarOf<L>, static_cast<std::size_t>(L::kWidth)> numbers_;
};

// The records of W lanes, to be dealt out again: each of them to several lanes.
template <class L, template <class> class Record>
class DealtRecords {
 public:
  explicit DealtRecords(const Record<L>& record) {
    const auto members = std::bit_cast<std::array<L, kCount>>(record);
    for (int m = 0; m < kCount; ++m)
      members[m].store(numbers_.data() + m * kWidth);
  }

  // Lane i of the result is lane from[i] of the record.
  template <class Int>
  Record<L> to(const Int& from) const {
    std::array<L, kCount> members;
    if (all_same(from, typename Int::Mask(true))) {
      const ScalarOf<L>* numbers = numbers_.data() + from[0];
      for (int m = 0; m < kCount; ++m)
        members[m] = L(numbers[m * kWidth]);
    } else {
      for (int m = 0; m < kCount; ++m)
        members[m] = L::gather(numbers_.data() + m * kWidth, from);
    }
    return std::bit_cast<Record<L>>(members);
  }

 private:
  static constexpr int kCount = kNumbersIn<Record, L>, kWidth = L::kWidth;
  std::array<ScalarOf<L>, static_cast<std::size_t>(kCount* kWidth)> numbers_;
};

}  // namespace alhazen::render

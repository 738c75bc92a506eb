// render/wave: several entries of a queue at once, one in each lane.
#pragma once

#include <algorithm>
#include <iterator>

#include "render/simd/elementary.h"
#include "render/simd/records.h"
#include "render/simd/wide.h"
#include "render/wave/column.h"

namespace alhazen::render {

// The entries `index` of a queue, where `active`. Most often they stand in a row, or are one and
// the same, and then their numbers are loaded and not gathered.
template <class L>
class Entries {
 public:
  using Real = ScalarOf<L>;
  using Int = IntOf<L>;
  using Mask = MaskOf<L>;
  static_assert(std::is_same_v<typename Int::Scalar, LaneInt<Real>>);
  static_assert(L::kWidth <= static_cast<int>(kMaxLanes), "columns have no room for whole lanes");

  Entries(const Int& index, Mask active) : index_(index), active_(active) {
    first_ = static_cast<std::size_t>(index[0]);
    in_row_ = !any(active && index != Int(index[0]) + Int::iota());
    is_one_ = !any(active && index != Int(index[0]));
  }
  // first, first + 1, ... as far as they are below `end`.
  static Entries in_row(std::size_t first, std::size_t end) {
    return {Int(static_cast<LaneInt<Real>>(first)) + Int::iota(), below(first, end)};
  }
  // Those that a list names from its place `first` on.
  static Entries of_list(const IndexList<LaneInt<Real>>& list, std::size_t first) {
    return {Int::load(list.begin() + first), below(first, list.size())};
  }

  Mask active() const { return active_; }
  const Int& index() const { return index_; }
  // Of the entry in one lane.
  std::size_t operator[](int lane) const { return static_cast<std::size_t>(index_[lane]); }

  L of(const Column<Real>& column) const { return numbers<L>(column); }
  Int of(const Column<LaneInt<Real>>& column) const { return numbers<Int>(column); }
  // Words that hold bits, not numbers.
  Lanes<std::uint64_t, L::kWidth> of(const Column<std::uint64_t>& column) const {
    return numbers<Lanes<std::uint64_t, L::kWidth>>(column);
  }
  Lanes<std::uint32_t, L::kWidth> of(const Column<std::uint32_t>& column) const {
    using Words = Lanes<std::uint32_t, L::kWidth>;
    if (in_row_ || is_one_) return numbers<Words>(column);
    return Words(gathered_words<L>(column.data(), index_, active_));
  }
  Vec3<L> of(const Vec3Column<Real>& column) const {
    return {of(column.x), of(column.y), of(column.z)};
  }
  Rgb<L> of(const RgbColumn<Real>& column) const {
    return {of(column.r), of(column.g), of(column.b)};
  }

  // Of entries in a row: gives them these numbers. What stands behind the last of the queue's means
  // nothing, so the lanes that are not active are stored too.
  void store(const L& numbers, Column<Real>& column) const {
    numbers.store(column.data() + first_);
  }
  void store(const Vec3<L>& v, Vec3Column<Real>& column) const {
    store(v.x, column.x);
    store(v.y, column.y);
    store(v.z, column.z);
  }
  void store(const Rgb<L>& color, RgbColumn<Real>& column) const {
    store(color.r, column.r);
    store(color.g, column.g);
    store(color.b, column.b);
  }

  // Gives the active ones, wherever they stand, these numbers; no others.
  void put(const L& numbers, Column<Real>& column) const {
    if (in_row_) {
      store(select(active_, numbers, L::load(column.data() + first_)), column);
    } else {
      for_each_lane(active_, [&](int k) { column[(*this)[k]] = numbers[k]; });
    }
  }
  void put(const Rgb<L>& color, RgbColumn<Real>& column) const {
    put(color.r, column.r);
    put(color.g, column.g);
    put(color.b, column.b);
  }

 private:
  static Mask below(std::size_t first, std::size_t end) {
    return Mask::first(static_cast<int>(std::min<std::size_t>(L::kWidth, end - first)));
  }
  template <class Numbers, class T>
  Numbers numbers(const Column<T>& column) const {
    if (in_row_) return Numbers::load(column.data() + first_);
    if (is_one_) return Numbers(column[first_]);
    return Numbers::gather(column.data(), index_, typename Numbers::Mask(active_));
  }

  Int index_;
  Mask active_;
  std::size_t first_ = 0;
  bool in_row_ = false, is_one_ = false;
};

// Calls visit(entries) for the entries [0, count) of a queue, in their order.
template <class L, class Visitor>
void for_lanes(std::size_t count, const Visitor& visit) {
  for (std::size_t i = 0; i < count; i += L::kWidth)
    visit(Entries<L>::in_row(i, count));
}
// For those of a list.
template <class L, class Visitor>
void for_lanes(const IndexList<LaneInt<ScalarOf<L>>>& list, const Visitor& visit) {
  for (std::size_t k = 0; k < list.size(); k += L::kWidth)
    visit(Entries<L>::of_list(list, k));
}

// The lanes of the mask become the entries of the column from `i` on, in their order.
template <class L>
void store_lanes(MaskOf<L> which, const Vec3<L>& v, Vec3Column<ScalarOf<L>>& column,
                 std::size_t i) {
  v.x.store_compressed(which, column.x.data() + i);
  v.y.store_compressed(which, column.y.data() + i);
  v.z.store_compressed(which, column.z.data() + i);
}
template <class L>
void store_lanes(MaskOf<L> which, const Rgb<L>& color, RgbColumn<ScalarOf<L>>& column,
                 std::size_t i) {
  color.r.store_compressed(which, column.r.data() + i);
  color.g.store_compressed(which, column.g.data() + i);
  color.b.store_compressed(which, column.b.data() + i);
}

// Lanes that are found one by one: number(lane) where the mask is set, else `otherwise`.
template <class L, class Number>
L per_lane(MaskOf<L> which, ScalarOf<L> otherwise, const Number& number) {
  ScalarOf<L> numbers[L::kWidth];
  std::fill(std::begin(numbers), std::end(numbers), otherwise);
  for_each_lane(which, [&](int k) { numbers[k] = number(k); });
  return L::load(numbers);
}

// Lanes in memory, to be looked at one by one.
template <class L>
class Numbers {
 public:
  Numbers(const L& lanes) { lanes.store(number_); }
  ScalarOf<L> operator[](int lane) const { return number_[lane]; }

 private:
  ScalarOf<L> number_[L::kWidth];
};
template <class L>
class Colors {
 public:
  Colors(const Rgb<L>& c) : r_(c.r), g_(c.g), b_(c.b) {}
  Rgb<ScalarOf<L>> operator[](int lane) const { return {r_[lane], g_[lane], b_[lane]}; }

 private:
  Numbers<L> r_, g_, b_;
};

}  // namespace alhazen::render

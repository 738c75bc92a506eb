// render/wave: columns. A queue keeps each number of its entries in an array of its own, so that
// one instruction loads that number of several entries (docs/lanes.md).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "core/math/vec.h"

namespace alhazen::render {

// Whole numbers that stages use in lanes beside a Real, and masks with it: as wide as it is.
template <class Real>
using LaneInt = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;

// Entries that a column has room for beyond its last, so that whole lanes are loaded and stored
// there too; no lanes are more.
inline constexpr std::size_t kMaxLanes = 16;

// Memory is only ever added: after the first batches a render allocates nothing.
template <class T>
class Column {
 public:
  const T& operator[](std::size_t i) const { return values_[i]; }
  T& operator[](std::size_t i) { return values_[i]; }
  void set(std::size_t i, const T& value) { values_[i] = value; }
  const T* data() const { return values_.data(); }
  T* data() { return values_.data(); }

  std::size_t room() const { return values_.size() < kMaxLanes ? 0 : values_.size() - kMaxLanes; }
  // Afterwards there is room for `count` entries; those there are stay.
  void make_room(std::size_t count) {
    if (room() < count) values_.resize(std::max(2 * values_.size(), count + kMaxLanes));
  }
  // The entries [from, from + count) become those from `to` <= from on.
  void move(std::size_t to, std::size_t from, std::size_t count) {
    if (to != from) std::copy_n(data() + from, count, data() + to);
  }

 private:
  std::vector<T> values_;
};

template <class Real>
struct Vec3Column {
  Column<Real> x, y, z;

  Vec3<Real> operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, Vec3<Real> v) {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
  void make_room(std::size_t count) {
    x.make_room(count);
    y.make_room(count);
    z.make_room(count);
  }
  void move(std::size_t to, std::size_t from, std::size_t count) {
    x.move(to, from, count);
    y.move(to, from, count);
    z.move(to, from, count);
  }
};

template <class Real>
struct RgbColumn {
  Column<Real> r, g, b;

  Rgb<Real> operator[](std::size_t i) const { return {r[i], g[i], b[i]}; }
  void set(std::size_t i, Rgb<Real> color) {
    r[i] = color.r;
    g[i] = color.g;
    b[i] = color.b;
  }
  void make_room(std::size_t count) {
    r.make_room(count);
    g.make_room(count);
    b.make_room(count);
  }
  void move(std::size_t to, std::size_t from, std::size_t count) {
    r.move(to, from, count);
    g.move(to, from, count);
    b.move(to, from, count);
  }
};

// A list of indices into a queue, in its order.
template <class Index>
class IndexList {
 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  Index operator[](std::size_t k) const { return indices_[k]; }
  const Index* begin() const { return indices_.data(); }
  const Index* end() const { return indices_.data() + size_; }
  void clear() { size_ = 0; }
  void make_room(std::size_t count) { indices_.make_room(count); }
  // Precondition: there is room.
  void push(std::size_t index) { indices_[size_++] = static_cast<Index>(index); }
  // The lanes of the mask, in their order. Precondition: there is room.
  template <class Lanes>
  void append(const Lanes& indices, typename Lanes::Mask which) {
    size_ += static_cast<std::size_t>(indices.store_compressed(which, indices_.data() + size_));
  }

 private:
  Column<Index> indices_;
  std::size_t size_ = 0;
};

}  // namespace alhazen::render

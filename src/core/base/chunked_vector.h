// core/base: a vector that grows by chunks: elements never move, and none is ever there twice, as
// in a vector that makes room. Meant for lists that may have a handful of elements or a million.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>
#include <vector>

namespace alhazen {

template <class T>
class ChunkedVector {
 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  const T& operator[](std::size_t i) const {
    const Place place = place_of(i);
    return chunks_[place.chunk][place.offset];
  }

  void push_back(T value) {
    const Place place = place_of(size_);
    if (place.chunk == chunks_.size()) {
      chunks_.emplace_back().reserve(std::size_t{1} << std::min(place.chunk, kLog2Largest));
    }
    chunks_.back().push_back(std::move(value));
    ++size_;
  }

 private:
  // Chunk k has 2^k elements, from element 2^k - 1 on, until that is kLargest; then all have that.
  static constexpr std::size_t kLog2Largest = 12, kLargest = std::size_t{1} << kLog2Largest;
  struct Place {
    std::size_t chunk, offset;
  };
  static Place place_of(std::size_t i) {
    const std::size_t from_one = i + 1;
    if (from_one >= kLargest) {
      return {kLog2Largest - 1 + from_one / kLargest, from_one % kLargest};
    }
    const auto chunk = static_cast<std::size_t>(std::bit_width(from_one)) - 1;
    return {chunk, from_one - (std::size_t{1} << chunk)};
  }

  std::vector<std::vector<T>> chunks_;
  std::size_t size_ = 0;
};

}  // namespace alhazen

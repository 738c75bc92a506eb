// core/base: a list that needs no allocation while it is short: for arguments, operands and the
// like, of which there are seldom more than a few and which are made a million times.
#pragma once

#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace alhazen {

// Elements are default-constructible. References end with the next push_back.
template <class T, std::size_t kFew>
class SmallVector {
 public:
  SmallVector() = default;
  explicit SmallVector(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      push_back(T());
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }

  void push_back(T value) {
    if (many_.empty() && size_ < kFew) {
      few_[size_] = std::move(value);
    } else {
      if (many_.empty()) {
        many_.assign(std::make_move_iterator(few_.begin()), std::make_move_iterator(few_.end()));
      }
      many_.push_back(std::move(value));
    }
    ++size_;
  }
  void pop_back() {
    --size_;
    if (!many_.empty()) many_.pop_back();
  }

 private:
  T* data() { return many_.empty() ? few_.data() : many_.data(); }
  const T* data() const { return many_.empty() ? few_.data() : many_.data(); }

  std::array<T, kFew> few_{};
  std::vector<T> many_;  // all of them, once they are more
  std::size_t size_ = 0;
};

}  // namespace alhazen

// core/base: a list that needs no allocation while it is short: for arguments, operands and the
// like, of which there are seldom more than a few and which are made a million times.
#pragma once

#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace alhazen {

// References end with the next push_back.
template <class T, std::size_t kFew>
class SmallVector {
 public:
  SmallVector() = default;
  explicit SmallVector(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      push_back(T());
  }
  SmallVector(SmallVector&& other) noexcept : many_(std::move(other.many_)), size_(other.size_) {
    if (many_.empty()) {
      std::uninitialized_move_n(other.few(), size_, few());
    } else {
      other.size_ = 0;
    }
  }
  SmallVector& operator=(SmallVector&&) = delete;
  ~SmallVector() {
    if (many_.empty()) std::destroy_n(few(), size_);
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }

  void push_back(T value) {
    if (many_.empty() && size_ < kFew) {
      std::construct_at(few() + size_, std::move(value));
    } else {
      if (many_.empty()) leave_few();
      many_.push_back(std::move(value));
    }
    ++size_;
  }
  void pop_back() {
    --size_;
    if (many_.empty()) {
      std::destroy_at(few() + size_);
    } else {
      many_.pop_back();
    }
  }

 private:
  T* few() { return reinterpret_cast<T*>(&few_); }
  const T* few() const { return reinterpret_cast<const T*>(&few_); }
  T* data() { return many_.empty() ? few() : many_.data(); }
  const T* data() const { return many_.empty() ? few() : many_.data(); }

  void leave_few() {
    many_.assign(std::make_move_iterator(few()), std::make_move_iterator(few() + size_));
    std::destroy_n(few(), size_);
  }

  // Made one by one: a list of two pays for two.
  alignas(T) std::byte few_[kFew * sizeof(T)];
  std::vector<T> many_;  // all of them, once they are more
  std::size_t size_ = 0;
};

}  // namespace alhazen

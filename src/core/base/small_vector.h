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
  // Written out, so that `{}` does not fill the place for the elements with zeros first.
  SmallVector() {}  // NOLINT(modernize-use-equals-default)
  explicit SmallVector(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      push_back(T());
  }
  SmallVector(SmallVector&& other) noexcept : many_(std::move(other.many_)), size_(other.size_) {
    if (many_.empty()) {
      std::uninitialized_move_n(other.few(), size_, few());
    } else {
      data_ = many_.data();
      other.data_ = other.few();
      other.size_ = 0;
    }
  }
  SmallVector& operator=(SmallVector&&) = delete;
  ~SmallVector() {
    if (is_few()) std::destroy_n(few(), size_);
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }

  void push_back(const T& value) { push_back(T(value)); }
  void push_back(T&& value) {
    if (is_few() && size_ < kFew) {
      std::construct_at(data_ + size_, std::move(value));
    } else {
      push_among_many(std::move(value));
    }
    ++size_;
  }
  void pop_back() {
    --size_;
    if (is_few()) {
      std::destroy_at(few() + size_);
    } else {
      many_.pop_back();
    }
  }

 private:
  T* few() { return reinterpret_cast<T*>(&few_); }
  const T* few() const { return reinterpret_cast<const T*>(&few_); }
  bool is_few() const { return data_ == few(); }

  // Seldom, and so kept out of what is inlined.
  [[gnu::noinline]] void push_among_many(T&& value) {
    if (is_few()) {
      many_.assign(std::make_move_iterator(few()), std::make_move_iterator(few() + size_));
      std::destroy_n(few(), size_);
    }
    many_.push_back(std::move(value));
    data_ = many_.data();
  }

  // Made one by one: a list of two pays for two.
  alignas(T) std::byte few_[kFew * sizeof(T)];
  std::vector<T> many_;  // all of them, once they are more
  T* data_ = few();
  std::size_t size_ = 0;
};

}  // namespace alhazen

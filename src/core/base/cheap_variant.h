// core/base: a variant that is cheap to hand on. std::variant asks a table of functions how to move
// or to destroy whatever it holds as soon as one of its alternatives is no plain data; here those
// that are plain are moved as bytes and destroyed by nothing, and only the others are asked.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

namespace alhazen {

// Each alternative is there once; the first one is what a default is.
template <class... Ts>
class CheapVariant {
 public:
  template <class T>
  static constexpr bool has = (std::same_as<T, Ts> || ...);

  CheapVariant() { put(First()); }
  template <class T>
  requires has<T> CheapVariant(T value) { put(std::move(value)); }
  CheapVariant(const CheapVariant& other) { copy(other); }
  CheapVariant(CheapVariant&& other) noexcept { take(other); }
  CheapVariant& operator=(const CheapVariant& other) {
    if (this != &other) *this = CheapVariant(other);
    return *this;
  }
  CheapVariant& operator=(CheapVariant&& other) noexcept {
    if (this == &other) return *this;
    CheapVariant taken(std::move(other));  // which may be a part of what is destroyed here
    destroy();
    take(taken);
    return *this;
  }
  ~CheapVariant() { destroy(); }

  // Which of the alternatives it is, from 0.
  std::size_t index() const { return index_; }
  template <class T>
  requires has<T>
  const T& get() const {
    if (index_ != index_of<T>()) throw std::bad_variant_access();
    return held<T>();
  }

  // visitor(alternative), which gives the same type for each.
  template <class Visitor>
  decltype(auto) visit(Visitor&& visitor) const {
    return visit_from<0, Ts...>(*this, visitor);
  }

 private:
  using First = std::tuple_element_t<0, std::tuple<Ts...>>;
  static constexpr std::array kPlain = {std::is_trivially_copyable_v<Ts>...};
  static_assert((std::is_nothrow_move_constructible_v<Ts> && ...));

  template <class T>
  static constexpr std::uint8_t index_of() {
    constexpr std::array same = {std::same_as<T, Ts>...};
    return static_cast<std::uint8_t>(std::find(same.begin(), same.end(), true) - same.begin());
  }

  template <class T>
  const T& held() const {
    return *std::launder(reinterpret_cast<const T*>(bytes_));
  }

  template <std::size_t i, class T, class... Rest, class Self, class Visitor>
  static decltype(auto) visit_from(Self& self, Visitor& visitor) {
    if constexpr (sizeof...(Rest) == 0) {
      return visitor(self.template held<T>());
    } else {
      if (self.index_ == i) return visitor(self.template held<T>());
      return visit_from<i + 1, Rest...>(self, visitor);
    }
  }

  template <class T>
  void put(T value) {
    std::construct_at(reinterpret_cast<T*>(bytes_), std::move(value));
    index_ = index_of<T>();
  }
  void copy_bytes(const CheapVariant& other) {
    std::memcpy(bytes_, other.bytes_, sizeof bytes_);
    index_ = other.index_;
  }
  void copy(const CheapVariant& other) {
    if (kPlain[other.index_]) {
      copy_bytes(other);
    } else {
      other.visit([&](const auto& value) { put(value); });
    }
  }
  // What is moved from is still that alternative, as in std::variant.
  void take(CheapVariant& other) {
    if (kPlain[other.index_]) {
      copy_bytes(other);
    } else {
      other.visit([&]<class T>(const T& value) { put(std::move(const_cast<T&>(value))); });
    }
  }
  void destroy() {
    if (kPlain[index_]) return;
    visit([]<class T>(const T& value) { std::destroy_at(&value); });
  }

  alignas(Ts...) std::byte bytes_[std::max({sizeof(Ts)...})];
  std::uint8_t index_;
};

}  // namespace alhazen

// parser/ast: where a tree lives. A scene that is written out has a million nodes: they are made
// one after the other, none is freed alone, and all are gone at once.
#pragma once

#include <algorithm>
#include <memory>
#include <memory_resource>
#include <span>
#include <string_view>
#include <type_traits>

namespace alhazen::ast {

class Arena {
 public:
  // What it is given stays where it is for as long as the arena lives, also when that is moved.
  template <class Node>
  const Node* add(const Node& node) {
    return list(std::span(&node, 1)).data();
  }
  template <class Element>
  std::span<const Element> list(std::span<const Element> elements) {
    static_assert(std::is_trivially_copyable_v<Element>, "nobody destroys what lives here");
    if (elements.empty()) return {};
    auto* place = static_cast<Element*>(memory_->allocate(elements.size_bytes(), alignof(Element)));
    std::uninitialized_copy(elements.begin(), elements.end(), place);
    return {place, elements.size()};
  }
  std::string_view text(std::string_view bytes) {
    const auto copy = list(std::span(bytes));
    return {copy.data(), copy.size()};
  }

 private:
  std::unique_ptr<std::pmr::monotonic_buffer_resource> memory_ =
      std::make_unique<std::pmr::monotonic_buffer_resource>();
};

}  // namespace alhazen::ast

// core/scene: the shapes of a scene, in order. A scene may have a million of them, most of them
// alike, so they are not kept as records of the largest kind's size: geometry stands with others
// of its kind, and what is usual for many in a row is kept once. A ball takes 44 bytes.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

#include "core/base/chunked_vector.h"
#include "core/scene/shape.h"

namespace alhazen {

class ShapeList {
 public:
  class Iterator;

  ShapeList() = default;
  ShapeList(const std::vector<Shape>& shapes);  // NOLINT: shapes are shapes
  ShapeList(std::initializer_list<Shape> shapes) : ShapeList(std::vector<Shape>(shapes)) {}

  std::size_t size() const { return entries_.size(); }
  bool empty() const { return entries_.empty(); }
  // Put together from its parts: a value, not a place; const, so that what looks like an assignment
  // to a part of it is an error. Precondition: there is such a shape.
  const Shape operator[](std::size_t id) const;  // NOLINT(readability-const-return-type)
  // What people know it by: its name, completed by "sphere 3" where it is numbered.
  std::string name(std::size_t id) const;

  void push_back(const Shape& shape);

  Iterator begin() const;
  Iterator end() const;

 private:
  // What consecutive shapes often have in common: those that a loop places, for instance.
  struct Common {
    std::optional<Affined> world_from_object;
    LightId light;
    std::string name;
    SourceSpan span;
    bool numbered;
    std::uint32_t not_numbered;  // how many of its kind before it are not
    friend bool operator==(const Common&, const Common&) = default;
  };
  struct Entry {
    std::uint32_t kind : 4, index : 28;  // in the list of its kind
    MaterialId material;
    std::uint32_t common;
  };
  template <class Variant>
  struct ListsOf;
  template <class... Kinds>
  struct ListsOf<std::variant<Kinds...>> {
    using Type = std::tuple<ChunkedVector<Kinds>...>;
  };

  Geometry geometry(const Entry& entry) const;

  ListsOf<Geometry>::Type lists_;
  ChunkedVector<Entry> entries_;
  std::vector<Common> commons_;
};

class ShapeList::Iterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = Shape;
  using difference_type = std::ptrdiff_t;
  using pointer = const Shape*;
  using reference = Shape;

  Iterator(const ShapeList& list, std::size_t id) : list_(&list), id_(id) {}
  Shape operator*() const { return (*list_)[id_]; }
  Iterator& operator++() {
    ++id_;
    return *this;
  }
  Iterator operator++(int) { return {*list_, id_++}; }
  friend bool operator==(const Iterator& a, const Iterator& b) { return a.id_ == b.id_; }

 private:
  const ShapeList* list_;
  std::size_t id_;
};

inline ShapeList::Iterator ShapeList::begin() const {
  return {*this, 0};
}
inline ShapeList::Iterator ShapeList::end() const {
  return {*this, size()};
}

}  // namespace alhazen

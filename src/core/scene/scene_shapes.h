// core/scene: all shapes of a scene by id: single ones, and those of instances. A group that is
// placed many times is a prototype: its shapes are there once, in the group's own frame, and each
// place costs a transform. Whoever asks by id sees the same shapes as if each stood for itself.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/scene/instance_index.h"
#include "core/scene/shape_list.h"

namespace alhazen {

using PrototypeId = std::uint32_t;

// One copy of a prototype.
struct Instance {
  Affined world_from_group;  // never singular
  PrototypeId prototype = 0;
  MaterialId material = kNoId;  // of the shapes that have none of their own
  std::string path;             // of the groups around it: before each shape's name
  SourceSpan span;              // where it is placed
  // How many of each kind of shape come before its own, for the numbers in names.
  std::array<ShapeId, std::variant_size_v<Geometry>> numbered_before{};
};

class SceneShapes {
 public:
  class Iterator;

  SceneShapes() = default;
  SceneShapes(const std::vector<Shape>& shapes);  // NOLINT: shapes are shapes
  SceneShapes(std::initializer_list<Shape> shapes) : SceneShapes(std::vector<Shape>(shapes)) {}

  std::size_t size() const { return index_.size(); }
  bool empty() const { return size() == 0; }
  // As ShapeList's. Of an instance's shape the transforms are composed.
  const Shape operator[](std::size_t id) const;  // NOLINT(readability-const-return-type)
  std::string name(std::size_t id) const;
  Iterator begin() const;
  Iterator end() const;

  void push_back(const Shape& shape);
  // The shapes of a group in its frame. Those without a material have the instance's.
  PrototypeId add_prototype(ShapeList shapes);
  // Precondition: there is such a prototype.
  void push_back(const Instance& instance);

  const InstanceIndex& index() const { return index_; }
  const ShapeList& singles() const { return singles_; }
  std::span<const ShapeList> prototypes() const { return prototypes_; }
  InstanceId instance_count() const { return index_.instance_count(); }
  // Put together from its parts.
  Instance instance(InstanceId id) const;
  const Affined& world_from_group(InstanceId id) const { return places_[id].world_from_group; }
  PrototypeId prototype_of(InstanceId id) const { return common_of(id).prototype; }
  MaterialId material_of(InstanceId id) const { return common_of(id).material; }

  // Calls visit(shape, id) for every shape, but of instances that differ only in place, one.
  template <class Visit>
  void for_each_different(const Visit& visit) const {
    for (ShapeId n = 0; n < index_.single_count(); ++n)
      visit(singles_[n], index_.id_of_single(n));
    for (const InstanceId instance : different_instances()) {
      const ShapeId first = index_.first(instance);
      for (ShapeId n = 0; n < prototypes_[prototype_of(instance)].size(); ++n)
        visit((*this)[first + n], first + n);
    }
  }

 private:
  // What consecutive instances often have in common. Of them, `numbered_before` is the first's.
  struct Common {
    PrototypeId prototype;
    MaterialId material;
    std::string path;
    SourceSpan span;
    std::array<ShapeId, std::variant_size_v<Geometry>> numbered_before;
    InstanceId first;
  };
  struct Place {
    Affined world_from_group;
    std::uint32_t common;
  };
  // How many shapes of each kind a prototype has.
  using Counts = std::array<ShapeId, std::variant_size_v<Geometry>>;

  const Common& common_of(InstanceId id) const { return commons_[places_[id].common]; }
  Counts counts_before(const Common& common, InstanceId id) const;
  // The first of each prototype and material.
  std::vector<InstanceId> different_instances() const;

  ShapeList singles_;
  std::vector<ShapeList> prototypes_;
  std::vector<Counts> counts_;  // of the prototypes
  ChunkedVector<Place> places_;
  std::vector<Common> commons_;
  InstanceIndex index_;
};

class SceneShapes::Iterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = Shape;
  using difference_type = std::ptrdiff_t;
  using pointer = const Shape*;
  using reference = Shape;

  Iterator(const SceneShapes& shapes, std::size_t id) : shapes_(&shapes), id_(id) {}
  Shape operator*() const { return (*shapes_)[id_]; }
  Iterator& operator++() {
    ++id_;
    return *this;
  }
  Iterator operator++(int) { return {*shapes_, id_++}; }
  friend bool operator==(const Iterator& a, const Iterator& b) { return a.id_ == b.id_; }

 private:
  const SceneShapes* shapes_;
  std::size_t id_;
};

inline SceneShapes::Iterator SceneShapes::begin() const {
  return {*this, 0};
}
inline SceneShapes::Iterator SceneShapes::end() const {
  return {*this, size()};
}

// The same shapes under the same ids, each for itself.
SceneShapes written_out(const SceneShapes& shapes);

}  // namespace alhazen

// core/scene: where among the shapes of a scene the instances of prototypes stand. Ids are given
// instance by instance and shape by shape in the order of the text; a search finds the way back.
#pragma once

#include <cstddef>
#include <vector>

#include "core/scene/shape.h"

namespace alhazen {

using InstanceId = std::uint32_t;  // of the instances of a scene, in order

class InstanceIndex {
 public:
  // A single shape is the `number`-th of those; one of an instance, of its prototype's.
  struct Place {
    InstanceId instance;  // kNoId: a single one
    ShapeId number;
  };

  ShapeId size() const { return size_; }  // single shapes and those of all instances
  ShapeId single_count() const { return singles_; }
  InstanceId instance_count() const { return static_cast<InstanceId>(starts_.size()); }

  void add_single() { ++size_, ++singles_; }
  void add_instance(std::size_t shapes) {
    starts_.push_back({size_, singles_});
    size_ += static_cast<ShapeId>(shapes);
  }

  // Precondition: there is such a shape.
  Place locate(ShapeId id) const;
  // The id of the first shape of an instance.
  ShapeId first(InstanceId instance) const { return starts_[instance].id; }
  ShapeId id_of_single(ShapeId number) const;

 private:
  struct Start {
    ShapeId id;
    ShapeId singles_before;
  };
  Start next_start(std::size_t i) const {
    return i + 1 < starts_.size() ? starts_[i + 1] : Start{size_, singles_};
  }

  std::vector<Start> starts_;
  ShapeId size_ = 0, singles_ = 0;
};

}  // namespace alhazen

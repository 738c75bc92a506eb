// render/wave: which solids a ray is inside of. Nested dielectrics by priority (Schmidt and Budge
// 2002): where solids overlap, the one of highest priority is there, and crossing the surface of
// another changes nothing.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/scene/material.h"
#include "core/scene/shape.h"

namespace alhazen::render {

// A set of materials that a ray is inside of, as a list from the last entered to the first. The
// list of one material alone has that material's number, so that where no solid is inside of
// another nothing has to be looked up.
using MediumId = std::int32_t;
inline constexpr MediumId kVacuum = -1;

// One worker's lists, sharing tails. Entering the same surface many times from the same list gives
// the same id, so the pool grows with the number of different situations, not of rays. Which number
// a list of several has follows from what came before; no result does.
class MediumPool {
 public:
  explicit MediumPool(std::size_t materials) : materials_(static_cast<MediumId>(materials)) {}

  MediumId enter(MediumId medium, MaterialId material);
  // Without the last entry of `material`; the same list if it has none.
  MediumId leave(MediumId medium, MaterialId material);
  bool contains(MediumId medium, MaterialId material) const;
  // The material that is really there: of highest priority, of equal ones the last entered. kNoId
  // in vacuum. `priority` holds that of each material.
  MaterialId current(MediumId medium, const std::vector<int>& priority) const;
  // Whether it holds one material or none.
  bool is_single(MediumId medium) const { return medium < materials_; }
  // Before a batch: no list of another is still in use. What is known is kept while it is little.
  void forget_much();

 private:
  struct Node {
    MaterialId material;
    MediumId rest;
    MediumId first_child, next_sibling;
  };
  MaterialId material_of(MediumId medium) const {
    return is_single(medium) ? static_cast<MaterialId>(medium) : node(medium).material;
  }
  MediumId rest_of(MediumId medium) const {
    return is_single(medium) ? kVacuum : node(medium).rest;
  }
  const Node& node(MediumId medium) const {
    return nodes_[static_cast<std::size_t>(medium - materials_)];
  }

  MediumId materials_;
  std::vector<Node> nodes_;  // of lists of two and more, from the id materials_ on
  std::unordered_map<MediumId, MediumId> first_child_of_single_;
};

}  // namespace alhazen::render

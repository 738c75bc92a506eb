// render/wave: which solids a ray is inside of. Nested dielectrics by priority (Schmidt and Budge
// 2002): where solids overlap, the one of highest priority is there, and crossing the surface of
// another changes nothing.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/material.h"
#include "core/scene/shape.h"

namespace alhazen::render {

// A set of materials that a ray is inside of, as a list from the last entered to the first.
using MediumId = std::uint32_t;
inline constexpr MediumId kVacuum = ~MediumId{0};

// The lists of one batch, sharing tails. Entering the same surface many times from the same list
// gives the same id, so the pool grows with the number of different situations, not of rays.
class MediumPool {
 public:
  MediumId enter(MediumId medium, MaterialId material);
  // Without the last entry of `material`; the same list if it has none.
  MediumId leave(MediumId medium, MaterialId material);
  bool contains(MediumId medium, MaterialId material) const;
  // The material that is really there: of highest priority, of equal ones the last entered. kNoId
  // in vacuum. `priority` holds that of each material.
  MaterialId current(MediumId medium, const std::vector<int>& priority) const;
  void clear() {
    nodes_.clear();
    first_root_ = kVacuum;
  }

 private:
  struct Node {
    MaterialId material;
    MediumId rest;
    MediumId first_child, next_sibling;
  };
  std::vector<Node> nodes_;
  MediumId first_root_ = kVacuum;
};

}  // namespace alhazen::render

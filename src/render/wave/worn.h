// render/wave: what shapes wear, by id. Shapes of an instance have their prototype's materials, or
// else the instance's.
#pragma once

#include <algorithm>
#include <vector>

#include "core/scene/scene.h"
#include "render/simd/records.h"
#include "render/wave/entries.h"
#include "render/wave/materials.h"

namespace alhazen::render {

class WornMaterials {
 public:
  // `index` is that of the shapes; it stays where it is.
  WornMaterials(const SceneShapes& shapes, const InstanceIndex& index) : index_(index) {
    of_single_ = materials_of(shapes.singles());
    for (const ShapeList& prototype : shapes.prototypes())
      of_prototype_.push_back(materials_of(prototype));
    of_instance_.reserve(shapes.instance_count());
    for (InstanceId id = 0; id < shapes.instance_count(); ++id)
      of_instance_.push_back({shapes.prototype_of(id), shapes.material_of(id)});
  }

  std::size_t size() const { return index_.size(); }
  bool empty() const { return size() == 0; }
  MaterialId operator[](ShapeId id) const {
    if (of_instance_.empty()) return of_single_[id];
    return of(index_.locate(id));
  }
  MaterialId of(InstanceIndex::Place place) const {
    if (place.instance == kNoId) return of_single_[place.number];
    const Instance& instance = of_instance_[place.instance];
    const MaterialId own = of_prototype_[instance.prototype][place.number];
    return own != kNoId ? own : instance.material;
  }
  // Of the shapes of several lanes.
  template <class L>
  IntOf<L> at(const IntOf<L>& shape, MaskOf<L> active) const {
    if (of_instance_.empty()) return gathered_words<L>(of_single_.data(), shape, active);
    if constexpr (std::same_as<L, ScalarOf<L>>) {
      return active ? static_cast<IntOf<L>>((*this)[static_cast<ShapeId>(shape)]) : 0;
    } else {
      return per_lane<IntOf<L>>(active, 0, [&](int lane) {
        return static_cast<ScalarOf<IntOf<L>>>((*this)[static_cast<ShapeId>(shape[lane])]);
      });
    }
  }
  PrototypeId prototype_of(InstanceId id) const { return of_instance_[id].prototype; }

 private:
  struct Instance {
    PrototypeId prototype;
    MaterialId material;
  };
  static std::vector<MaterialId> materials_of(const ShapeList& shapes) {
    std::vector<MaterialId> materials;
    materials.reserve(shapes.size());
    for (const Shape& shape : shapes)
      materials.push_back(shape.material);
    return materials;
  }

  const InstanceIndex& index_;
  std::vector<MaterialId> of_single_;
  std::vector<std::vector<MaterialId>> of_prototype_;
  std::vector<Instance> of_instance_;
};

// Whether a shape is a clear sheet with nothing inside.
class ThinShapes {
 public:
  // All but `scene` and `materials` stay where they are.
  template <class Real>
  ThinShapes(const Scene& scene, const MaterialTable<Real>& materials, const WornMaterials& worn,
             const InstanceIndex& index)
      : worn_(worn), index_(index) {
    for (MaterialId id = 0; id < scene.materials.size(); ++id) {
      const MaterialRecord<Real>& material = materials[id];
      is_clear_.push_back(material.pov_clear && material.ior == 1 &&
                          material.pov_passage.fades == 0);
    }
    for (const Shape& shape : scene.shapes.singles())
      single_.push_back(is_clear_[shape.material] != 0 && !is_closed(shape.geometry));
    any_ = std::count(single_.begin(), single_.end(), 1) > 0;
    for (const ShapeList& prototype : scene.shapes.prototypes()) {
      open_.emplace_back();
      for (const Shape& shape : prototype)
        open_.back().push_back(!is_closed(shape.geometry));
      any_ = any_ || std::count(is_clear_.begin(), is_clear_.end(), 1) > 0;
    }
  }

  // Whether any shape may be.
  bool any() const { return any_; }
  bool operator[](ShapeId id) const {
    if (open_.empty()) return single_[id] != 0;
    const InstanceIndex::Place place = index_.locate(id);
    if (place.instance == kNoId) return single_[place.number] != 0;
    return open_[worn_.prototype_of(place.instance)][place.number] != 0 &&
           is_clear_[worn_.of(place)] != 0;
  }

 private:
  const WornMaterials& worn_;
  const InstanceIndex& index_;
  bool any_ = false;
  std::vector<std::uint8_t> single_;             // thin
  std::vector<std::uint8_t> is_clear_;           // of materials
  std::vector<std::vector<std::uint8_t>> open_;  // of shapes of prototypes
};

}  // namespace alhazen::render

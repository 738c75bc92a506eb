#include "core/scene/scene_shapes.h"

#include <fmt/format.h>
#include <set>
#include <utility>

namespace alhazen {

SceneShapes::SceneShapes(const std::vector<Shape>& shapes) {
  for (const Shape& shape : shapes)
    push_back(shape);
}

const Shape SceneShapes::operator[](std::size_t id) const {
  if (instance_count() == 0) return singles_[id];
  const InstanceIndex::Place place = index_.locate(static_cast<ShapeId>(id));
  if (place.instance == kNoId) return singles_[place.number];
  const Common& common = common_of(place.instance);
  Shape shape = prototypes_[common.prototype][place.number];
  const Affined& world_from_group = places_[place.instance].world_from_group;
  shape.world_from_object =
      shape.world_from_object ? world_from_group * *shape.world_from_object : world_from_group;
  if (shape.material == kNoId) shape.material = common.material;
  shape.name = common.path + shape.name;
  if (shape.number != 0) {
    shape.number += counts_before(common, place.instance)[shape.geometry.index()];
  }
  return shape;
}

std::string SceneShapes::name(std::size_t id) const {
  const Shape shape = (*this)[id];
  if (shape.number == 0) return shape.name;
  return fmt::format("{}{} {}", shape.name, kind_name(shape.geometry), shape.number);
}

void SceneShapes::push_back(const Shape& shape) {
  singles_.push_back(shape);
  index_.add_single();
}

PrototypeId SceneShapes::add_prototype(ShapeList shapes) {
  Counts counts{};
  for (const Shape& shape : shapes)
    ++counts[shape.geometry.index()];
  counts_.push_back(counts);
  prototypes_.push_back(std::move(shapes));
  return static_cast<PrototypeId>(prototypes_.size() - 1);
}

void SceneShapes::push_back(const Instance& instance) {
  const InstanceId id = instance_count();
  const auto goes_on = [&](const Common& common) {
    return common.prototype == instance.prototype && common.material == instance.material &&
           common.path == instance.path && common.span == instance.span &&
           counts_before(common, id) == instance.numbered_before;
  };
  if (commons_.empty() || !goes_on(commons_.back())) {
    commons_.push_back({instance.prototype, instance.material, instance.path, instance.span,
                        instance.numbered_before, id});
  }
  places_.push_back({instance.world_from_group, static_cast<std::uint32_t>(commons_.size() - 1)});
  index_.add_instance(prototypes_[instance.prototype].size());
}

SceneShapes::Counts SceneShapes::counts_before(const Common& common, InstanceId id) const {
  Counts counts = common.numbered_before;
  for (std::size_t kind = 0; kind < counts.size(); ++kind)
    counts[kind] += (id - common.first) * counts_[common.prototype][kind];
  return counts;
}

Instance SceneShapes::instance(InstanceId id) const {
  const Common& common = common_of(id);
  return {places_[id].world_from_group, common.prototype, common.material, common.path, common.span,
          counts_before(common, id)};
}

std::vector<InstanceId> SceneShapes::different_instances() const {
  std::vector<InstanceId> different;
  std::set<std::pair<PrototypeId, MaterialId>> seen;
  for (const Common& common : commons_) {
    if (seen.emplace(common.prototype, common.material).second) different.push_back(common.first);
  }
  return different;
}

SceneShapes written_out(const SceneShapes& shapes) {
  SceneShapes result;
  for (const Shape& shape : shapes)
    result.push_back(shape);
  return result;
}

}  // namespace alhazen

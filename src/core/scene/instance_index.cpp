#include "core/scene/instance_index.h"

#include <algorithm>

namespace alhazen {

InstanceIndex::Place InstanceIndex::locate(ShapeId id) const {
  const auto after =
      std::upper_bound(starts_.begin(), starts_.end(), id,
                       [](ShapeId wanted, const Start& start) { return wanted < start.id; });
  if (after == starts_.begin()) return {kNoId, id};
  const auto instance = static_cast<std::size_t>(after - starts_.begin()) - 1;
  // The instance, then single shapes up to the next one.
  const Start start = starts_[instance], next = next_start(instance);
  const ShapeId singles_behind = next.singles_before - start.singles_before;
  const ShapeId from_end = next.id - id;
  if (from_end <= singles_behind) return {kNoId, next.singles_before - from_end};
  return {static_cast<InstanceId>(instance), id - start.id};
}

ShapeId InstanceIndex::id_of_single(ShapeId number) const {
  // The first instance that more than `number` single shapes stand before.
  const auto after = std::upper_bound(
      starts_.begin(), starts_.end(), number,
      [](ShapeId wanted, const Start& start) { return wanted < start.singles_before; });
  const Start next = after == starts_.end() ? Start{size_, singles_} : *after;
  return next.id - (next.singles_before - number);
}

}  // namespace alhazen

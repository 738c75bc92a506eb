#include "render/wave/media.h"

namespace alhazen::render {

MediumId MediumPool::enter(MediumId medium, MaterialId material) {
  if (medium == kVacuum) return static_cast<MediumId>(material);
  const auto id = static_cast<MediumId>(materials_ + static_cast<MediumId>(nodes_.size()));
  MediumId& first = is_single(medium)
                        ? first_child_of_single_.try_emplace(medium, kVacuum).first->second
                        : nodes_[static_cast<std::size_t>(medium - materials_)].first_child;
  for (MediumId child = first; child != kVacuum; child = node(child).next_sibling) {
    if (node(child).material == material) return child;
  }
  const MediumId sibling = first;
  first = id;  // before push_back, which may move what `first` refers to
  nodes_.push_back({material, medium, kVacuum, sibling});
  return id;
}

MediumId MediumPool::leave(MediumId medium, MaterialId material) {
  // The entries above the one that goes are entered again, oldest first.
  std::vector<MaterialId> above;
  MediumId at = medium;
  while (at != kVacuum && material_of(at) != material) {
    above.push_back(material_of(at));
    at = rest_of(at);
  }
  if (at == kVacuum) return medium;
  MediumId result = rest_of(at);
  for (auto entry = above.rbegin(); entry != above.rend(); ++entry)
    result = enter(result, *entry);
  return result;
}

bool MediumPool::contains(MediumId medium, MaterialId material) const {
  for (MediumId at = medium; at != kVacuum; at = rest_of(at)) {
    if (material_of(at) == material) return true;
  }
  return false;
}

MaterialId MediumPool::current(MediumId medium, const std::vector<int>& priority) const {
  MaterialId best = kNoId;
  for (MediumId at = medium; at != kVacuum; at = rest_of(at)) {
    const MaterialId material = material_of(at);
    if (best == kNoId || priority[material] > priority[best]) best = material;
  }
  return best;
}

void MediumPool::forget_much() {
  constexpr std::size_t kMuch = 4096;
  if (nodes_.size() < kMuch) return;
  nodes_.clear();
  first_child_of_single_.clear();
}

}  // namespace alhazen::render

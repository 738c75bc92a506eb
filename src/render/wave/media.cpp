#include "render/wave/media.h"

namespace alhazen::render {

MediumId MediumPool::enter(MediumId medium, MaterialId material) {
  MediumId& first = medium == kVacuum ? first_root_ : nodes_[medium].first_child;
  for (MediumId child = first; child != kVacuum; child = nodes_[child].next_sibling) {
    if (nodes_[child].material == material) return child;
  }
  const auto id = static_cast<MediumId>(nodes_.size());
  const MediumId sibling = first;
  first = id;  // before push_back, which may move what `first` refers to
  nodes_.push_back({material, medium, kVacuum, sibling});
  return id;
}

MediumId MediumPool::leave(MediumId medium, MaterialId material) {
  // The entries above the one that goes are entered again, oldest first.
  std::vector<MaterialId> above;
  MediumId at = medium;
  while (at != kVacuum && nodes_[at].material != material) {
    above.push_back(nodes_[at].material);
    at = nodes_[at].rest;
  }
  if (at == kVacuum) return medium;
  MediumId result = nodes_[at].rest;
  for (auto entry = above.rbegin(); entry != above.rend(); ++entry)
    result = enter(result, *entry);
  return result;
}

bool MediumPool::contains(MediumId medium, MaterialId material) const {
  for (MediumId at = medium; at != kVacuum; at = nodes_[at].rest) {
    if (nodes_[at].material == material) return true;
  }
  return false;
}

MaterialId MediumPool::current(MediumId medium, const std::vector<int>& priority) const {
  MaterialId best = kNoId;
  for (MediumId at = medium; at != kVacuum; at = nodes_[at].rest) {
    const MaterialId material = nodes_[at].material;
    if (best == kNoId || priority[material] > priority[best]) best = material;
  }
  return best;
}

}  // namespace alhazen::render

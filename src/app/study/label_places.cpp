#include "app/study/label_places.h"

#include <algorithm>
#include <array>

namespace alhazen {
namespace {

// Where the label's middle is from the point, in half sizes of the label: to the right first, where
// reading goes on.
struct Direction {
  double x, y;
};
constexpr std::array<Direction, 8> kDirections{
    {{1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {1, 1}, {0, 1}, {-1, 1}}};
constexpr double kNearest = 7;  // clear of a marker
constexpr double kStep = 5;

bool contains(const LabelBox& outer, const LabelBox& inner) {
  return inner.x >= outer.x && inner.y >= outer.y &&
         inner.x + inner.width <= outer.x + outer.width &&
         inner.y + inner.height <= outer.y + outer.height;
}

LabelBox beside(const LabelWish& wish, Direction to, double gap) {
  const double x = wish.x + to.x * (gap + wish.width / 2);
  const double y = wish.y + to.y * (gap + wish.height / 2) * (to.x == 0 ? 1 : 0.7);
  return {x - wish.width / 2, y - wish.height / 2, wish.width, wish.height};
}

}  // namespace

bool overlap(const LabelBox& a, const LabelBox& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

std::vector<std::optional<LabelBox>> place_labels(std::span<const LabelWish> wishes,
                                                  std::vector<LabelBox> taken,
                                                  const LabelBox& bounds, double reach) {
  std::vector<std::optional<LabelBox>> places;
  for (const LabelWish& wish : wishes) {
    std::optional<LabelBox> found;
    for (double gap = kNearest; gap <= reach && !found; gap += kStep) {
      for (const Direction to : kDirections) {
        const LabelBox box = beside(wish, to, gap);
        const auto covers = [&](const LabelBox& other) { return overlap(box, other); };
        if (!contains(bounds, box) || std::ranges::any_of(taken, covers)) continue;
        found = box;
        taken.push_back(box);
        break;
      }
    }
    places.push_back(found);
  }
  return places;
}

}  // namespace alhazen

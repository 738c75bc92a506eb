// app/study: labels beside their points that cover neither points nor each other.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace alhazen {

// Upper left corner and size; y grows downwards.
struct LabelBox {
  double x = 0, y = 0, width = 0, height = 0;
};
bool overlap(const LabelBox& a, const LabelBox& b);

struct LabelWish {
  double x = 0, y = 0;  // of its point
  double width = 0, height = 0;
};

// A box for each label in their order, so the important ones come first; nothing where there is no
// room within `bounds`. `taken` are boxes that no label may cover; `reach` is how far the nearest
// side of a label is from its point at most.
std::vector<std::optional<LabelBox>> place_labels(std::span<const LabelWish> wishes,
                                                  std::vector<LabelBox> taken,
                                                  const LabelBox& bounds, double reach);

}  // namespace alhazen

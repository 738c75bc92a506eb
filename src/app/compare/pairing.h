// app/compare: which parts and channels of two pictures can be compared, and in words what cannot.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/compare/read_picture.h"
#include "core/base/result.h"

namespace alhazen {

struct ChannelPair {
  std::string name;
  std::size_t a{}, b{};  // indices in the part's pixels
};

// Parts of the same data window. The pointers lead into the pictures that were paired.
struct PartPair {
  const render::ExrPart* a{};
  const render::ExrPart* b{};
  std::vector<ChannelPair> channels;  // those that both have, in the order of layer.h; never empty
};

struct Pairing {
  std::vector<PartPair> parts;
  // Sentences without a full stop. A difference is one of shape: sizes, parts, channels, primaries.
  std::vector<std::string> differences;
  std::vector<std::string> notes;  // what was taken for granted
};

// Parts are paired by name; the only part of a picture, if it has no name, with the first part of
// the other. `channels`: names of channels or layers (layer.h), and nothing else is compared; empty
// for all. ErrorCode::usage when a name is in neither picture, and when one picture holds light and
// the other codes, whose numbers do not compare.
Result<Pairing> pair_pictures(const ComparedPicture& a, const ComparedPicture& b,
                              std::span<const std::string> channels);

}  // namespace alhazen

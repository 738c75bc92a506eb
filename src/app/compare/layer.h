// app/compare: channels that belong together: R, G and B; N.X, N.Y and N.Z.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace alhazen {

// What stands before the last dot of a channel's name; RGB for R, G and B; otherwise the name.
std::string layer_of(std::string_view channel);

// Which of `channels`, all of one layer, are its red, green and blue: what ends in R, G, B. Nothing
// when one is missing. The channels of Cryptomatte are ids and shares, whatever their letters.
std::optional<std::array<std::size_t, 3>> colors_of(std::span<const std::string> channels);

// Whether the channel holds ids of Cryptomatte: the .r and .b of CryptoObject00 and the like.
bool holds_ids(std::string_view channel);

// The order in which channels are told: R, G, B, then those of other layers as they come, where
// R, G, B, A of a layer are in this order and not in that of the alphabet.
void sort_for_reading(std::vector<std::string>& channels);

}  // namespace alhazen

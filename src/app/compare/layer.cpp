#include "app/compare/layer.h"

#include <algorithm>
#include <utility>

namespace alhazen {
namespace {

bool is_cryptomatte(std::string_view channel) {
  return channel.starts_with("Crypto");
}

// 0 .. 3 for a last word of one letter in R, G, B, A, large or small; 4 for all others.
std::size_t color_rank(std::string_view channel) {
  const std::size_t dot = channel.rfind('.');
  const std::string_view last = dot == std::string_view::npos ? channel : channel.substr(dot + 1);
  if (last.size() != 1) return 4;
  const std::size_t rank = std::string_view("RGBArgba").find(last);
  return rank == std::string_view::npos ? 4 : rank % 4;
}

}  // namespace

std::string layer_of(std::string_view channel) {
  const std::size_t dot = channel.rfind('.');
  if (dot != std::string_view::npos) return std::string(channel.substr(0, dot));
  return channel == "R" || channel == "G" || channel == "B" ? "RGB" : std::string(channel);
}

std::optional<std::array<std::size_t, 3>> colors_of(std::span<const std::string> channels) {
  std::array<std::size_t, 3> found{};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto is_color = [letter = "RGB"[c]](const std::string& name) {
      return color_rank(name) < 3 && name.back() == letter && !is_cryptomatte(name);
    };
    const auto at = std::ranges::find_if(channels, is_color);
    if (at == channels.end()) return std::nullopt;
    found[c] = static_cast<std::size_t>(at - channels.begin());
  }
  return found;
}

bool holds_ids(std::string_view channel) {
  return is_cryptomatte(channel) && (channel.ends_with(".r") || channel.ends_with(".b"));
}

void sort_for_reading(std::vector<std::string>& channels) {
  const std::vector<std::string> as_they_came = channels;
  const auto layer_rank = [&](const std::string& channel) {
    const std::string layer = layer_of(channel);
    if (layer == "RGB") return std::size_t{0};
    const auto first = std::ranges::find(as_they_came, layer, layer_of);
    return 1 + static_cast<std::size_t>(first - as_they_came.begin());
  };
  std::ranges::stable_sort(channels, {}, [&](const std::string& channel) {
    return std::pair(layer_rank(channel), color_rank(channel));
  });
}

}  // namespace alhazen

#include "render/image/cryptomatte.h"

#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace alhazen::render {
namespace {

constexpr std::uint32_t kFirstFactor = 0xcc9e2d51U;
constexpr std::uint32_t kSecondFactor = 0x1b873593U;

std::uint32_t byte_at(std::string_view bytes, std::size_t i) {
  return static_cast<unsigned char>(bytes[i]);
}

std::uint32_t scrambled(std::uint32_t block) {
  return std::rotl(block * kFirstFactor, 15) * kSecondFactor;
}

// MurmurHash3_x86_32 (Austin Appleby, public domain), seed 0. Blocks are little-endian by
// definition, so they are put together byte by byte.
std::uint32_t murmur3_32(std::string_view bytes) {
  std::uint32_t hash = 0;
  const std::size_t whole = bytes.size() / 4 * 4;
  for (std::size_t i = 0; i < whole; i += 4) {
    const std::uint32_t block = byte_at(bytes, i) | byte_at(bytes, i + 1) << 8 |
                                byte_at(bytes, i + 2) << 16 | byte_at(bytes, i + 3) << 24;
    hash = std::rotl(hash ^ scrambled(block), 13) * 5U + 0xe6546b64U;
  }
  std::uint32_t tail = 0;
  for (std::size_t i = bytes.size(); i > whole; --i)
    tail = tail << 8 | byte_at(bytes, i - 1);
  hash ^= scrambled(tail);
  hash ^= static_cast<std::uint32_t>(bytes.size());
  hash = (hash ^ hash >> 16) * 0x85ebca6bU;
  hash = (hash ^ hash >> 13) * 0xc2b2ae35U;
  return hash ^ hash >> 16;
}

}  // namespace

std::uint32_t cryptomatte_hash(std::string_view name) {
  const std::uint32_t hash = murmur3_32(name);
  const std::uint32_t exponent = hash >> 23 & 0xffU;
  return exponent == 0 || exponent == 255 ? hash ^ 1U << 23 : hash;
}

std::string cryptomatte_key(std::string_view layer_name) {
  return fmt::format("{:08x}", cryptomatte_hash(layer_name)).substr(0, 7);
}

CryptomatteLayer::CryptomatteLayer(std::string name, int width, int height, int ranks,
                                   std::vector<std::string> object_names)
    : name_(std::move(name)), object_names_(std::move(object_names)) {
  std::vector<std::string> channel_names;
  for (int set = 0; 2 * set < ranks; ++set) {
    // Lower case is what the specification writes, and what lossy codecs leave alone.
    for (const char component : {'r', 'g', 'b', 'a'}) {
      channel_names.push_back(fmt::format("{}{:02}.{}", name_, set, component));
    }
  }
  channels_ = FloatBuffer(width, height, std::move(channel_names));
}

void CryptomatteLayer::set_pixel(int column, int row, std::vector<IdCoverage> ids) {
  std::sort(ids.begin(), ids.end(), [](IdCoverage a, IdCoverage b) {
    return a.coverage != b.coverage ? a.coverage > b.coverage : a.hash < b.hash;
  });
  const std::size_t ranks = channels_.channel_count() / 2;
  for (std::size_t rank = 0; rank < ranks; ++rank) {
    const IdCoverage id = rank < ids.size() ? ids[rank] : IdCoverage{};
    channels_.at(2 * rank, column, row) = std::bit_cast<float>(id.hash);
    channels_.at(2 * rank + 1, column, row) = id.coverage;
  }
}

std::string CryptomatteLayer::manifest() const {
  nlohmann::json manifest = nlohmann::json::object();
  for (const std::string& object : object_names_) {
    manifest[object] = fmt::format("{:08x}", cryptomatte_hash(object));
  }
  // A name that is not UTF-8 must not cost the picture: its bad bytes become U+FFFD.
  return manifest.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace alhazen::render

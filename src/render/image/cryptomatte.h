// render/image: Cryptomatte 1.2 (Friedman and Jones, Psyop): ids and coverages as float channels.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "render/image/pixel_buffer.h"

namespace alhazen::render {

// MurmurHash3_x86_32 of the bytes with seed 0; then, where the exponent of the float with these
// bits would be 0 or 255, bit 23 is flipped, so that no id is a denormal, an infinity or a NaN.
std::uint32_t cryptomatte_hash(std::string_view name);

// The seven hexadecimal digits that key the attributes of the layer of this name.
std::string cryptomatte_key(std::string_view layer_name);

// Part of a pixel that shows the object with this hash. coverage is in 0 .. 1.
struct IdCoverage {
  std::uint32_t hash{};
  float coverage{};
};

// One layer, for instance `CryptoObject`: for each pixel the ids with the largest coverages.
class CryptomatteLayer {
 public:
  // `object_names` in any order. `ranks` is how many ids a pixel keeps; it is rounded up to even,
  // for two ranks share one set of channels. Preconditions: sizes and ranks are positive.
  CryptomatteLayer(std::string name, int width, int height, int ranks,
                   std::vector<std::string> object_names);

  // Sets one pixel from ids that differ, in any order; those beyond the last rank are dropped.
  // Equal coverages are ordered by hash, so the result does not depend on the order of arrival.
  void set_pixel(int column, int row, std::vector<IdCoverage> ids);

  const std::string& name() const { return name_; }
  // NAME00.r, NAME00.g (id and coverage of rank 0), NAME00.b, NAME00.a (rank 1), NAME01.r, ...
  const FloatBuffer& channels() const { return channels_; }
  // {"object name":"its hash as 8 hexadecimal digits", ...}, sorted by name.
  std::string manifest() const;

 private:
  std::string name_;
  std::vector<std::string> object_names_;
  FloatBuffer channels_;
};

}  // namespace alhazen::render

#include "render/image/exr_zip.h"

#include <new>

namespace alhazen::render {
namespace {

// As many bytes as from zlib at its level 4, which is what OpenEXR takes.
constexpr int kLevel = 3;

// The bytes at even places, then those at odd ones, so that the slowly varying high bytes of halves
// stand together; and in the place of each the difference from the one before, plus 128.
void filter(std::string_view samples, std::vector<std::uint8_t>& filtered) {
  const std::size_t half = samples.size() / 2;
  filtered.resize(samples.size());
  const auto difference = [](char byte, char before) {
    return static_cast<std::uint8_t>(byte - before + 128);
  };
  filtered[0] = static_cast<std::uint8_t>(samples[0]);
  filtered[half] = difference(samples[1], samples[samples.size() - 2]);
  for (std::size_t i = 1; i < half; ++i) {
    filtered[i] = difference(samples[2 * i], samples[2 * i - 2]);
    filtered[half + i] = difference(samples[2 * i + 1], samples[2 * i - 1]);
  }
}

}  // namespace

void ZipCompressor::Free::operator()(libdeflate_compressor* compressor) const {
  ::libdeflate_free_compressor(compressor);
}

ZipCompressor::ZipCompressor() : compressor_(::libdeflate_alloc_compressor(kLevel)) {
  if (!compressor_) throw std::bad_alloc();
}

std::string ZipCompressor::compress(std::string_view samples) {
  filter(samples, filtered_);
  compressed_.resize(samples.size() - 1);  // a stream that does not fit is not wanted
  const std::size_t size =
      ::libdeflate_zlib_compress(compressor_.get(), filtered_.data(), filtered_.size(),
                                 compressed_.data(), compressed_.size());
  if (size == 0) return std::string(samples);
  return {compressed_.begin(), compressed_.begin() + static_cast<std::ptrdiff_t>(size)};
}

}  // namespace alhazen::render

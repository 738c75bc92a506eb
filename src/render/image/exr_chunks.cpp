#include "render/image/exr_chunks.h"

#include <Imath/half.h>
#include <algorithm>
#include <bit>
#include <cstring>

#include "core/base/parallel.h"
#include "render/image/exr_samples.h"
#include "render/image/exr_zip.h"

namespace alhazen::render {
namespace {

// Rows that a thread takes at a time. Its compressor takes long to make, hence not a single one.
constexpr std::size_t kBandRows = 64;

template <class Stored>
char* put(std::span<const float> samples, SampleType type, char* to) {
  static_assert(std::endian::native == std::endian::little, "as EXR files are");
  const bool as_they_are = are_writable(samples, type);
  for (const float sample : samples) {
    const Stored stored(as_they_are ? sample : writable_sample(sample, type));
    std::memcpy(to, &stored, sizeof stored);
    to += sizeof stored;
  }
  return to;
}

std::size_t bytes_of(SampleType type) {
  return type == SampleType::half ? sizeof(Imath::half) : sizeof(float);
}

// Rows begin .. end-1 as the file has them before it is compressed.
void pack(const std::vector<ExrPlane>& planes, std::size_t width, std::size_t begin,
          std::size_t end, std::string& packed) {
  std::size_t pixel_bytes = 0;
  for (const ExrPlane& plane : planes)
    pixel_bytes += bytes_of(plane.channel.type);
  packed.resize(pixel_bytes * width * (end - begin));
  char* to = packed.data();
  for (std::size_t row = begin; row < end; ++row) {
    for (const ExrPlane& plane : planes) {
      const SampleType type = plane.channel.type;
      const std::span<const float> samples = plane.samples.subspan(row * width, width);
      to = type == SampleType::half ? put<Imath::half>(samples, type, to)
                                    : put<float>(samples, type, to);
    }
  }
}

}  // namespace

std::vector<std::string> compressed_chunks(std::vector<ExrPlane> planes, int width, int chunk_rows,
                                           int threads) {
  std::sort(planes.begin(), planes.end(),
            [](const ExrPlane& a, const ExrPlane& b) { return a.channel.name < b.channel.name; });
  const auto columns = static_cast<std::size_t>(width);
  const auto step = static_cast<std::size_t>(chunk_rows);
  const std::size_t rows = planes.front().samples.size() / columns;
  std::vector<std::string> chunks((rows + step - 1) / step);
  in_parallel(threads, (rows + kBandRows - 1) / kBandRows, [&](std::size_t band) {
    ZipCompressor compressor;
    std::string packed;
    const std::size_t end = std::min(rows, (band + 1) * kBandRows);
    for (std::size_t row = band * kBandRows; row < end; row += step) {
      pack(planes, columns, row, std::min(row + step, end), packed);
      chunks[row / step] = compressor.compress(packed);
    }
  });
  return chunks;
}

}  // namespace alhazen::render

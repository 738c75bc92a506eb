// tests/render: PNG files put together by hand from the specification (ISO/IEC 15948), so that the
// reader is not checked against libpng's own writer.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <zlib.h>

namespace alhazen::render {

inline std::string big_endian_32(std::uint32_t word) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>(word >> shift & 0xff);
  return bytes;
}

inline std::string png_chunk(const std::string& type, const std::string& data) {
  const std::string checked = type + data;
  const auto crc =
      ::crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size()));
  return big_endian_32(static_cast<std::uint32_t>(data.size())) + checked +
         big_endian_32(static_cast<std::uint32_t>(crc));
}

struct PngFile {
  std::uint32_t width{}, height{};
  char bit_depth = 8;
  char color_type = 2;  // 0 gray, 2 RGB, 3 palette, 4 gray and alpha, 6 RGBA
  char interlaced = 0;
  std::string chunks;     // PLTE, tRNS, ..., ready made
  std::string scanlines;  // each begins with its filter type

  std::string bytes() const {
    const std::string header = big_endian_32(width) + big_endian_32(height) + bit_depth +
                               color_type + '\0' + '\0' + interlaced;
    uLongf size = ::compressBound(static_cast<uLong>(scanlines.size()));
    std::string compressed(size, '\0');
    ::compress(reinterpret_cast<Bytef*>(compressed.data()), &size,
               reinterpret_cast<const Bytef*>(scanlines.data()),
               static_cast<uLong>(scanlines.size()));
    compressed.resize(size);
    return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + chunks +
           png_chunk("IDAT", compressed) + png_chunk("IEND", "");
  }
};

}  // namespace alhazen::render

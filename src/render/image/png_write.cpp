#include "render/image/png_write.h"

#include <fmt/format.h>
#include <png.h>

#include "core/base/file.h"

namespace alhazen::render {

Result<std::string> encode_png(std::span<const std::uint8_t> samples, int width, int height,
                               int components) {
  if (width <= 0 || height <= 0 || (components != 3 && components != 4) ||
      samples.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                            static_cast<std::size_t>(components)) {
    return Error{ErrorCode::usage, fmt::format("{} samples are not {} x {} pixels of {} components",
                                               samples.size(), width, height, components)};
  }
  // libpng's simplified interface: it catches its own long jumps.
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = components == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, samples.data(), 0, nullptr) == 0) {
    return Error{ErrorCode::io, fmt::format("cannot make the PNG file: {}", image.message)};
  }
  bytes.resize(size);
  return bytes;
}

Status write_png(const std::filesystem::path& path, std::span<const std::uint8_t> samples,
                 int width, int height, int components) {
  const Result<std::string> bytes = encode_png(samples, width, height, components);
  if (!bytes) return bytes.error();
  return write_file_atomic(path, bytes.value());
}

}  // namespace alhazen::render

#include "render/image/image_read.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "core/base/file.h"
#include "render/image/exr_read.h"
#include "render/image/jpeg_read.h"
#include "render/image/png_read.h"

namespace alhazen::render {
namespace {

// The channels R, G, B and A of a part, or its Y in place of the three colours; nothing when it has
// neither.
std::optional<FloatBuffer> colors_of(const FloatBuffer& pixels) {
  std::array<std::optional<std::size_t>, 3> sources{pixels.find("R"), pixels.find("G"),
                                                    pixels.find("B")};
  if (const auto gray = pixels.find("Y"); gray && !sources[0]) sources = {gray, gray, gray};
  if (!sources[0] || !sources[1] || !sources[2]) return std::nullopt;
  std::vector<std::string> names{"R", "G", "B"};
  const auto alpha = pixels.find("A");
  if (alpha) names.emplace_back("A");
  FloatBuffer colors(pixels.width(), pixels.height(), std::move(names));
  const auto copy = [&](std::size_t from, std::size_t to) {
    std::ranges::copy(pixels.channel(from), colors.channel(to).begin());
  };
  for (std::size_t c = 0; c < 3; ++c)
    copy(*sources[c], c);
  if (alpha) copy(*alpha, 3);
  return colors;
}

Result<FloatBuffer> decode_exr_colors(std::string_view bytes, const ImageLimits& limits) {
  const Result<std::vector<ExrPart>> parts = decode_exr(bytes, limits);
  if (!parts) return parts.error();
  std::string names;
  for (const ExrPart& part : parts.value()) {
    if (std::optional<FloatBuffer> colors = colors_of(part.pixels)) return *std::move(colors);
    for (const std::string& name : part.pixels.names()) {
      names += fmt::format("{}`{}`", names.empty() ? "" : ", ", name);
    }
  }
  return Error{ErrorCode::io,
               fmt::format("EXR file has no channels R, G and B, nor Y; it has: {}", names)};
}

Result<ReadImage> tagged(ImageFormat format, Result<FloatBuffer> pixels) {
  if (!pixels) return pixels.error();
  return ReadImage{format, std::move(pixels).value()};
}

}  // namespace

Result<ReadImage> decode_image(std::string_view bytes, const ImageLimits& limits) {
  if (is_png(bytes)) return tagged(ImageFormat::png, decode_png(bytes, limits));
  if (is_jpeg(bytes)) return tagged(ImageFormat::jpeg, decode_jpeg(bytes, limits));
  if (is_exr(bytes)) return tagged(ImageFormat::exr, decode_exr_colors(bytes, limits));
  return Error{ErrorCode::io, "not a PNG, JPEG or EXR file"};
}

Result<ReadImage> read_image(const std::filesystem::path& path, const ImageLimits& limits) {
  const Result<std::string> bytes = read_file(path, limits.max_file_bytes);
  if (!bytes) return bytes.error();
  Result<ReadImage> image = decode_image(bytes.value(), limits);
  if (!image) {
    return Error{image.error().code,
                 fmt::format("cannot read `{}`: {}", path.string(), image.error().message)};
  }
  return image;
}

}  // namespace alhazen::render

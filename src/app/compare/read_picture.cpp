#include "app/compare/read_picture.h"

#include <fmt/format.h>
#include <utility>

#include "core/base/file.h"
#include "render/image/image_read.h"

namespace alhazen {
namespace {

Result<ComparedPicture> decode(std::string_view bytes) {
  if (render::is_exr(bytes)) {
    Result<std::vector<render::ExrPart>> parts = render::decode_exr(bytes);
    if (!parts) return parts.error();
    return ComparedPicture{"", PixelEncoding::light, std::move(parts).value()};
  }
  Result<render::ReadImage> image = render::decode_image(bytes);
  if (!image) return image.error();
  render::ExrPart part;
  part.pixels = std::move(image.value().pixels);
  part.data_window = {0, 0, part.pixels.width(), part.pixels.height()};
  part.display_window = part.data_window;
  ComparedPicture picture{"", PixelEncoding::srgb, {}};
  picture.parts.push_back(std::move(part));
  return picture;
}

}  // namespace

Result<ComparedPicture> read_picture(const std::filesystem::path& path) {
  const Result<std::string> bytes = read_file(path, render::ImageLimits{}.max_file_bytes);
  if (!bytes) return bytes.error();
  Result<ComparedPicture> picture = decode(bytes.value());
  if (!picture) {
    return Error{picture.error().code,
                 fmt::format("cannot read `{}`: {}", path.string(), picture.error().message)};
  }
  picture.value().name = path.string();
  return picture;
}

}  // namespace alhazen

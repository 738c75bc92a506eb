#include "app/cli/load_images.h"

#include "core/base/file.h"
#include "core/base/hash.h"
#include "render/image/image_read.h"

namespace alhazen {
namespace {

struct ImageBytes {
  render::ImagePixels pixels;
  std::uint64_t hash;
};

render::ImagePixels interleaved(const render::FloatBuffer& planes) {
  render::ImagePixels image{planes.width(), planes.height(), {}};
  image.rgb.resize(3 * planes.pixel_count());
  for (std::size_t c = 0; c < 3; ++c) {
    const std::span<const float> plane = planes.channel(c);
    for (std::size_t i = 0; i < plane.size(); ++i)
      image.rgb[3 * i + c] = plane[i];
  }
  return image;
}

Result<ImageBytes> load_image(const ImageFile& file, const render::ColorConfig& colors) {
  const render::ImageLimits limits;
  const Result<std::string> bytes = read_file(file.path, limits.max_file_bytes);
  if (!bytes) return bytes.error();
  Result<render::ReadImage> image = render::decode_image(bytes.value(), limits);
  if (!image) return image.error();
  const render::TextureSpace space =
      colors.texture_space(file.path, file.color_space, render::TextureUse::color);
  const Result<render::ColorTransform> to_working = colors.to_working(space.name);
  if (!to_working) return to_working.error();
  render::FloatBuffer& pixels = image.value().pixels;
  to_working.value().apply({pixels.channel(0), pixels.channel(1), pixels.channel(2)});
  return ImageBytes{interleaved(pixels), fnv1a_64(space.name, fnv1a_64(bytes.value()))};
}

}  // namespace

LoadedImages load_images(const Scene& scene, const render::ColorConfig& colors,
                         DiagnosticSink& sink) {
  LoadedImages images;
  for (const ImageFile& file : scene.images) {
    Result<ImageBytes> image = load_image(file, colors);
    if (!image) {
      sink.report<DiagnosticKind::unreadable_file>(file.span, file.path, image.error().message);
      continue;
    }
    images.hash = mix_64(images.hash, image.value().hash);
    images.pixels.push_back(std::move(image.value().pixels));
  }
  return images;
}

}  // namespace alhazen

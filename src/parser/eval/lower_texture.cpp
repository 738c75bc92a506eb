// parser/eval: bodies of textures.
#include "parser/eval/lower.h"

namespace alhazen::parser {
namespace {

bool lower_brick(Context& context, const Properties& p, BrickPattern& brick) {
  if (p.has("size")) brick.size = p.vec3("size");
  if (p.has("mortar_width")) brick.mortar_width = p.number("mortar_width");
  const double least = smaller(brick.size.x, smaller(brick.size.y, brick.size.z));
  if (brick.mortar_width < least) return true;
  context.report<DiagnosticKind::mortar_too_wide>(
      p.has("mortar_width") ? p.span("mortar_width") : p.span("size"),
      number_text(brick.mortar_width), number_text(least));
  return false;
}

void lower_image(Context& context, const Properties& p, ImagePattern& image) {
  if (p.has("color_space")) {
    ImageFile file = context.store().image(image.image);
    file.color_space = p.text_or_empty("color_space");
    image.image = context.store().add(std::move(file));
  }
  if (p.has("wrap")) {
    const std::string wrap = p.word("wrap");
    image.wrap = wrap == "clamp"    ? ImageWrap::clamp
                 : wrap == "mirror" ? ImageWrap::mirror
                                    : ImageWrap::repeat;
  }
  if (p.has("filter")) {
    image.filter = p.word("filter") == "nearest" ? ImageFilter::nearest : ImageFilter::bilinear;
  }
}

}  // namespace

const BlockSchema& schema_of(const Texture& texture) {
  static constexpr std::string_view kNames[] = {"solid", "checker",  "stripes",
                                                "brick", "gradient", "image"};
  return *find_schema(texture_schemas(), kNames[texture.pattern.index()]);
}

std::optional<TextureId> lower_texture(Context& context, const Properties& properties,
                                       TextureId base) {
  Texture out = context.store().texture(base);
  out.span = properties.head();
  if (properties.has("mapping")) {
    const std::string mapping = properties.word("mapping");
    out.mapping = mapping == "uv"      ? Mapping::uv
                  : mapping == "world" ? Mapping::world
                                       : Mapping::object;
  }
  if (auto* brick = std::get_if<BrickPattern>(&out.pattern)) {
    if (!lower_brick(context, properties, *brick)) return std::nullopt;
  }
  if (auto* image = std::get_if<ImagePattern>(&out.pattern)) {
    lower_image(context, properties, *image);
  }
  // The transforms move the pattern; a point is looked up by going back.
  const auto moved_from_pattern = lower_transform(context, properties);
  if (!moved_from_pattern) return std::nullopt;
  if (!(*moved_from_pattern == Affined())) {
    out.pattern_from_mapped = out.pattern_from_mapped * *inverse(*moved_from_pattern);
  }
  return context.add(std::move(out));
}

}  // namespace alhazen::parser

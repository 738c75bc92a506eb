// parser/eval: the bodies of textures: `checker(a, b) { scale 0.5 }`. The functions that make
// textures are in builtin/texture.cpp.
#include "parser/eval/schema/schema.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {
namespace {

constexpr std::string_view kMappings[] = {"object", "world", "uv"};
constexpr std::string_view kWraps[] = {"repeat", "clamp", "mirror"};
constexpr std::string_view kFilters[] = {"bilinear", "nearest"};

constexpr std::array<PropertySpec, 1> kMapping = {{
    {.name = "mapping",
     .types = kString,
     .words = kMappings,
     .doc = "which coordinates the pattern is laid out in: the point in the frame of the shape, in "
            "the world, or the (u, v) of the surface; `object` unless it is an image, for which it "
            "is `uv`"},
}};
constexpr PropertySpec kBrick[] = {
    {.name = "size",
     .types = kVec3,
     .range = above(0),
     .default_value = vec3_default(8, 3, 4.5),
     .doc = "of a brick with its joint"},
    {.name = "mortar_width",
     .types = kNumber,
     .range = at_least(0),
     .default_value = number_default(0.5),
     .doc = "of the joints; less than the bricks' size"},
};
constexpr PropertySpec kImage[] = {
    {.name = "color_space",
     .types = kString,
     .doc = "what the file holds, as the colour configuration calls it; found by the rules of the "
            "configuration if not given"},
    {.name = "wrap",
     .types = kString,
     .default_value = word_default("repeat"),
     .words = kWraps,
     .doc = "what is outside of the unit square"},
    {.name = "filter",
     .types = kString,
     .default_value = word_default("bilinear"),
     .words = kFilters,
     .doc = "how pixels are interpolated"},
};

// In the order of the alternatives of Pattern.
constexpr BlockSchema kSchemas[] = {
    {.name = "solid", .doc = "One colour everywhere."},
    {.name = "checker",
     .doc = "Unit cubes of two textures in turn.",
     .tables = {kMapping, kTransformProperties},
     .example = "material diffuse { color checker(rgb(0.9), rgb(0.1)) { scale 0.5 } }"},
    {.name = "stripes",
     .doc = "Slabs of unit width across x, of two textures in turn.",
     .tables = {kMapping, kTransformProperties},
     .example = "material diffuse { color stripes(rgb(0.9), rgb(0.1)) { rotate z*45deg } }"},
    {.name = "brick",
     .doc = "A wall of bricks with mortar between them.",
     .tables = {kBrick, kMapping, kTransformProperties},
     .example = "material diffuse { color brick(srgb(0.6, 0.2, 0.1), rgb(0.6)) "
                "{ mortar_width 0.3  scale 0.1 } }"},
    {.name = "gradient",
     .doc = "Colours that pass into each other along x.",
     .tables = {kMapping, kTransformProperties},
     .example = "material diffuse { color gradient([[0, rgb(0.1)], [1, rgb(0.9)]]) "
                "{ rotate z*90deg } }"},
    {.name = "image",
     .doc =
         "A picture file that fills the unit square of x and y. Its name is relative to the file "
         "it is written in.",
     .tables = {kImage, kMapping, kTransformProperties}},
};
constexpr const BlockSchema* kAll[] = {&kSchemas[0], &kSchemas[1], &kSchemas[2],
                                       &kSchemas[3], &kSchemas[4], &kSchemas[5]};

}  // namespace

std::span<const BlockSchema* const> texture_schemas() {
  return kAll;
}

}  // namespace alhazen::parser

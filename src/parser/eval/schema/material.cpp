// parser/eval: the blocks of materials and highlights. core/scene/material.h says what each is.
#include "parser/eval/schema/schema.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {
namespace {

constexpr NumberRange kUnit = between(0, 1);

constexpr std::array<PropertySpec, 1> kEmission = {{
    {.name = "emission",
     .types = kColor,
     .range = at_least(0),
     .default_value = gray_default(0),
     .doc = "the radiance it gives off by itself; it is seen but lights nothing"},
}};
constexpr PropertySpec kDiffuse[] = {
    {.name = "color",
     .types = kColor | kTexture,
     .range = kUnit,
     .default_value = gray_default(0.8),
     .doc = "the part of the light that it scatters"},
    {.name = "highlight",
     .types = kHighlight,
     .doc = "`phong { ... }` or `blinn { ... }`: a gloss; colour and strength together are at "
            "most 1"},
};
constexpr PropertySpec kMirror[] = {
    {.name = "color",
     .types = kColor | kTexture,
     .range = kUnit,
     .default_value = gray_default(1),
     .doc = "the part of the light that it reflects"},
};
constexpr std::string_view kPresets[] = {"gold",     "silver",   "copper", "aluminium", "iron",
                                         "chromium", "titanium", "brass",  "platinum",  "tungsten"};
constexpr PropertySpec kMetal[] = {
    {.name = "preset",
     .types = kString,
     .words = kPresets,
     .doc = "a real metal; instead of `n` and `k`"},
    {.name = "n",
     .types = kNumber | kColor,
     .range = above(0),
     .doc = "the index of refraction, one or one for each channel as `rgb(...)`"},
    {.name = "k",
     .types = kNumber | kColor,
     .range = at_least(0),
     .doc = "the extinction coefficient, likewise"},
};
constexpr PropertySpec kGlass[] = {
    {.name = "ior",
     .types = kNumber,
     .range = above(0),
     .default_value = number_default(1.5),
     .doc = "the index of refraction of the inside"},
    {.name = "absorption",
     .types = kColor,
     .range = at_least(0),
     .default_value = gray_default(0),
     .doc = "light is dimmed by exp(-absorption * distance) on its way through (Beer-Lambert)"},
    {.name = "priority",
     .types = kNumber,
     .range = integers(-1000, 1000),
     .default_value = number_default(0),
     .doc = "where solids overlap, the one of higher priority is there"},
};
constexpr PropertySpec kCoat[] = {
    {.name = "color",
     .types = kColor | kTexture,
     .range = kUnit,
     .default_value = gray_default(0.8),
     .doc = "of the diffuse base under the varnish"},
    {.name = "ior",
     .types = kNumber,
     .range = above(1),
     .default_value = number_default(1.5),
     .doc = "the index of refraction of the varnish"},
    {.name = "absorption",
     .types = kColor,
     .range = at_least(0),
     .default_value = gray_default(0),
     .doc = "the optical depth of the varnish, seen from straight above"},
};
constexpr PropertySpec kGlow[] = {
    {.name = "color",
     .types = kColor,
     .range = at_least(0),
     .default_value = gray_default(1),
     .doc = "the radiance it gives off"},
};
constexpr PropertySpec kLobe[] = {
    {.name = "strength",
     .types = kNumber | kColor,
     .range = kUnit,
     .default_value = number_default(0.2),
     .doc = "the largest part of the light it reflects"},
    {.name = "exponent",
     .types = kNumber,
     .range = between(1, 1e6),
     .default_value = number_default(40),
     .doc = "how small and sharp it is"},
};

constexpr BlockSchema kMaterials[] = {
    {.name = "diffuse",
     .doc = "Matt, as paper or chalk (Lambert), with a highlight if wanted.",
     .tables = {kDiffuse, kEmission},
     .example = "material diffuse { color srgb(0.8, 0.3, 0.2)  highlight blinn { strength 0.1 } }"},
    {.name = "mirror",
     .doc = "A perfect mirror that reflects the same part at every angle.",
     .tables = {kMirror, kEmission},
     .example = "material mirror { color rgb(0.9) }"},
    {.name = "metal",
     .doc = "A polished metal: Fresnel reflection by its complex index n + ik. Give either "
            "`preset` or both `n` and `k`.",
     .tables = {kMetal, kEmission},
     .example = "material metal { preset gold }"},
    {.name = "glass",
     .doc = "A clear solid: reflects and refracts by Fresnel and Snell, may absorb inside.",
     .tables = {kGlass, kEmission},
     .example = "material glass { ior 1.5  absorption rgb(0.1, 0.02, 0.02) }"},
    {.name = "coat",
     .doc = "A diffuse base under a clear varnish, as lacquered wood.",
     .tables = {kCoat, kEmission},
     .example = "material coat { color srgb(0.5, 0.25, 0.1)  ior 1.5 }"},
    {.name = "glow",
     .doc = "Gives off light and reflects none.",
     .tables = {kGlow},
     .example = "material glow { color rgb(5) }"},
};
constexpr BlockSchema kHighlights[] = {
    {.name = "phong",
     .doc = "Phong's highlight: by the angle to the mirror direction.",
     .tables = {kLobe},
     .example = "material diffuse { highlight phong { strength 0.2  exponent 60 } }"},
    {.name = "blinn",
     .doc = "Blinn's highlight: by the angle of the half vector to the normal.",
     .tables = {kLobe},
     .example = "material diffuse { highlight blinn { strength 0.2  exponent 60 } }"},
};
constexpr const BlockSchema* kAllMaterials[] = {&kMaterials[0], &kMaterials[1], &kMaterials[2],
                                                &kMaterials[3], &kMaterials[4], &kMaterials[5],
                                                &kPovFinish};
constexpr const BlockSchema* kAllHighlights[] = {&kHighlights[0], &kHighlights[1]};

}  // namespace

std::span<const BlockSchema* const> material_schemas() {
  return kAllMaterials;
}
std::span<const BlockSchema* const> highlight_schemas() {
  return kAllHighlights;
}

}  // namespace alhazen::parser

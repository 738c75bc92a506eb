// parser/eval: the block of POV-Ray's own surface model. Names, defaults and meanings are those of
// POV-Ray 3.7; docs/pov_ray.md has the formulas.
#include "parser/eval/schema/schema.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {
namespace {

constexpr NumberRange kUnit = between(0, 1);
constexpr TypeSet kAmount = kNumber | kColor;

constexpr PropertySpec kReflectionProperties[] = {
    {.name = "min",
     .types = kAmount,
     .range = at_least(0),
     .default_value = number_default(0),
     .doc = "the part reflected when seen from straight above"},
    {.name = "max",
     .types = kAmount,
     .range = at_least(0),
     .default_value = number_default(1),
     .doc = "the part reflected at a grazing angle"},
    {.name = "falloff",
     .types = kNumber,
     .range = at_least(0),
     .default_value = number_default(1),
     .doc = "between both by (1 - cos)^falloff of the angle of view"},
    {.name = "fresnel",
     .types = kBool,
     .default_value = bool_default(false),
     .doc = "between both by Fresnel's equations with `ior` instead"},
    {.name = "metallic",
     .types = kNumber,
     .range = kUnit,
     .default_value = number_default(0),
     .doc = "how much of the colour is in the reflection, less at grazing angles"},
};
constexpr BlockSchema kReflection = {
    .name = "reflection",
    .doc = "POV-Ray's reflection that changes with the angle of view.",
    .tables = {kReflectionProperties},
    .example = "material pov_finish { reflection { min 0.1  max 0.8  falloff 3 } }"};
constexpr const BlockSchema* kReflections[] = {&kReflection};

constexpr PropertySpec kPigment[] = {
    {.name = "color",
     .types = kColor | kTexture,
     .range = at_least(0),
     .default_value = gray_default(0.8),
     .doc = "the pigment"},
    {.name = "filter",
     .types = kNumber,
     .range = kUnit,
     .default_value = number_default(0),
     .doc = "the part of the light that passes, in its colour; with `transmit` at most 1"},
    {.name = "transmit",
     .types = kNumber,
     .range = kUnit,
     .default_value = number_default(0),
     .doc = "the part of the light that passes unchanged"},
};
constexpr PropertySpec kFinish[] = {
    {.name = "ambient",
     .types = kAmount,
     .range = at_least(0),
     .default_value = number_default(0.1),
     .doc = "light of its colour that it shows by itself"},
    {.name = "emission",
     .types = kAmount,
     .range = at_least(0),
     .default_value = number_default(0),
     .doc = "the same again; times the colour, as in POV-Ray"},
    {.name = "diffuse",
     .types = kNumber,
     .range = at_least(0),
     .default_value = number_default(0.6),
     .doc = "how much it answers to lights; there is no 1/pi"},
    {.name = "brilliance",
     .types = kNumber,
     .range = above(0),
     .default_value = number_default(1),
     .doc = "the exponent of the cosine in `diffuse`"},
    {.name = "phong",
     .types = kNumber,
     .range = at_least(0),
     .default_value = number_default(0),
     .doc = "the strength of a highlight by the angle to the mirror direction"},
    {.name = "phong_size",
     .types = kNumber,
     .range = at_least(0),
     .default_value = number_default(40),
     .doc = "its exponent: how small and sharp it is"},
    {.name = "specular",
     .types = kNumber,
     .range = at_least(0),
     .default_value = number_default(0),
     .doc = "the strength of a highlight by the angle of the half vector to the normal"},
    {.name = "roughness",
     .types = kNumber,
     .range = above(0),
     .default_value = number_default(0.05),
     .doc = "1 over its exponent"},
    {.name = "metallic",
     .types = kNumber,
     .range = kUnit,
     .default_value = number_default(0),
     .doc = "how much of the colour is in the highlights, less at grazing angles"},
    {.name = "reflection",
     .types = kAmount,
     .range = at_least(0),
     .default_value = number_default(0),
     .blocks = kReflections,
     .kind_named = false,
     .doc = "the part reflected as by a mirror, or how it changes with the angle"},
};
constexpr PropertySpec kInterior[] = {
    {.name = "conserve_energy",
     .types = kBool,
     .default_value = bool_default(false),
     .doc = "what is reflected is taken from what passes"},
    {.name = "ior",
     .types = kNumber,
     .range = above(0),
     .default_value = number_default(1),
     .doc = "the index of refraction of the inside"},
    {.name = "fade_distance",
     .types = kNumber,
     .range = at_least(0),
     .default_value = number_default(0),
     .doc = "light fades inside over such a distance; needs `fade_power`"},
    {.name = "fade_power",
     .types = kNumber,
     .range = at_least(0),
     .default_value = number_default(0),
     .doc = "how: by a power of the distance, or from 1000 on exponentially"},
    {.name = "fade_color",
     .types = kColor,
     .range = at_least(0),
     .default_value = gray_default(0),
     .doc = "what is left of the light far inside"},
};

}  // namespace

constinit const BlockSchema kPovFinish = {
    .name = "pov_finish",
    .doc =
        "POV-Ray 3.7's own surface model, for scenes that come from there. Unlike all others it "
        "may give off more light than it receives.",
    .tables = {kPigment, kFinish, kInterior},
    .example = "material pov_finish { color rgb(0.8, 0.2, 0.1)  phong 0.6  reflection 0.1 }"};

}  // namespace alhazen::parser

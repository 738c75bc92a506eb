// parser/eval: the blocks of lights. core/scene/light.h says what each is.
#include "parser/eval/schema/schema.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {
namespace {

constexpr Presence kRequired = Presence::required;
constexpr std::string_view kFalloffs[] = {"inverse_square", "none"};

constexpr PropertySpec kPoint[] = {
    {.name = "position", .types = kVec3, .presence = kRequired, .doc = "where it is"},
    {.name = "intensity",
     .types = kColor,
     .range = at_least(0),
     .default_value = gray_default(1),
     .doc = "lights a surface that faces it from distance d with intensity / d^2"},
    {.name = "falloff",
     .types = kString,
     .default_value = word_default("inverse_square"),
     .words = kFalloffs,
     .doc = "`none`: as bright at any distance, as POV-Ray's lights are unless told otherwise"},
};
constexpr PropertySpec kDirectional[] = {
    {.name = "direction",
     .types = kVec3,
     .presence = kRequired,
     .range = kNonzero,
     .doc = "the way the light travels, of any length"},
    {.name = "irradiance",
     .types = kColor,
     .range = at_least(0),
     .default_value = gray_default(1),
     .doc = "on a surface that faces it"},
};
constexpr PropertySpec kSpot[] = {
    {.name = "position", .types = kVec3, .presence = kRequired, .doc = "where it is"},
    {.name = "look_at", .types = kVec3, .presence = kRequired, .doc = "the point it aims at"},
    {.name = "intensity",
     .types = kColor,
     .range = at_least(0),
     .default_value = gray_default(1),
     .doc = "lights a surface that faces it from distance d with intensity / d^2"},
    {.name = "inner_angle",
     .types = kAngle,
     .range = between(0, 180),
     .default_value = angle_default(30),
     .doc = "from the axis to where it begins to fade"},
    {.name = "outer_angle",
     .types = kAngle,
     .range = between(0, 180),
     .default_value = angle_default(45),
     .doc = "from the axis to where it is dark"},
    {.name = "falloff",
     .types = kString,
     .default_value = word_default("inverse_square"),
     .words = kFalloffs,
     .doc = "as of a point light"},
};
constexpr std::array<PropertySpec, 3> kArea = {{
    {.name = "radiance",
     .types = kColor,
     .range = at_least(0),
     .default_value = gray_default(1),
     .doc = "how bright its surface is"},
    {.name = "samples",
     .types = kNumber,
     .range = integers(1, 1024),
     .default_value = number_default(4),
     .doc = "shadow rays for each shaded point"},
    {.name = "visible",
     .types = kBool,
     .default_value = bool_default(true),
     .doc = "whether the light itself can be seen"},
}};
constexpr PropertySpec kSphere[] = {
    {.name = "center", .types = kVec3, .presence = kRequired, .doc = "the centre"},
    {.name = "radius",
     .types = kNumber,
     .range = above(0),
     .default_value = number_default(1),
     .doc = "the radius"},
};
constexpr PropertySpec kRectangle[] = {
    {.name = "corner", .types = kVec3, .presence = kRequired, .doc = "one corner"},
    {.name = "edge_u",
     .types = kVec3,
     .presence = kRequired,
     .range = kNonzero,
     .doc = "from that corner to the next"},
    {.name = "edge_v",
     .types = kVec3,
     .presence = kRequired,
     .range = kNonzero,
     .doc = "from that corner to the one before; the light shines to "
            "the side of cross(edge_u, edge_v)"},
};
constexpr PropertySpec kAmbient[] = {
    {.name = "radiance",
     .types = kColor,
     .range = at_least(0),
     .default_value = gray_default(0.1),
     .doc = "the same from everywhere, without shadows"},
};

constexpr std::array<PropertySpec, 1> kName = {{
    {.name = "name", .types = kString, .doc = "what it is called in statistics"},
}};
constexpr std::array<PropertySpec, 6> kPlaced = {{
    {.name = "name", .types = kString, .doc = "what it is called in statistics"},
    {.name = "shadows",
     .types = kBool,
     .default_value = bool_default(true),
     .doc = "whether things in its way cast shadows"},
    {.name = "translate",
     .types = kVec3,
     .presence = Presence::repeatable,
     .doc = "moves by a vector"},
    {.name = "rotate",
     .types = kAngles | kTransform,
     .presence = Presence::repeatable,
     .doc = "turns, as for shapes"},
    {.name = "scale",
     .types = kNumber | kVec3,
     .presence = Presence::repeatable,
     .doc = "stretches, as for shapes"},
    {.name = "matrix",
     .types = kList | kTransform,
     .presence = Presence::repeatable,
     .doc = "any affine map, as for shapes"},
}};

constexpr BlockSchema kSchemas[] = {
    {.name = "point",
     .doc = "Shines from one point to all sides, with hard shadows.",
     .tables = {kPoint, kPlaced},
     .example = "light point { position <5, 8, -5>  intensity rgb(60) }"},
    {.name = "directional",
     .doc = "Parallel light from far away, as the sun's.",
     .tables = {kDirectional, kPlaced},
     .example = "light directional { direction <1, -2, 1>  irradiance rgb(3) }"},
    {.name = "spot",
     .doc = "A point that shines into a cone.",
     .tables = {kSpot, kPlaced},
     .example = "light spot { position <0, 5, 0>  look_at <0, 0, 0>  intensity rgb(40)  "
                "inner_angle 20deg  outer_angle 30deg }"},
    {.name = "sphere",
     .doc = "A shining ball, with soft shadows.",
     .tables = {kSphere, kArea, kPlaced},
     .example = "light sphere { center <3, 6, -2>  radius 0.5  radiance rgb(40) }"},
    {.name = "rectangle",
     .doc = "A shining rectangle, with soft shadows.",
     .tables = {kRectangle, kArea, kPlaced},
     .example = "light rectangle { corner <-1, 5, -1>  edge_u <2, 0, 0>  edge_v <0, 0, 2>  "
                "radiance rgb(8) }"},
    {.name = "ambient",
     .doc = "Light from everywhere: lifts the shadows, casts none.",
     .tables = {kAmbient, kName},
     .example = "light ambient { radiance rgb(0.1) }"},
};
constexpr const BlockSchema* kAll[] = {&kSchemas[0], &kSchemas[1], &kSchemas[2],
                                       &kSchemas[3], &kSchemas[4], &kSchemas[5]};

}  // namespace

std::span<const BlockSchema* const> light_schemas() {
  return kAll;
}

}  // namespace alhazen::parser

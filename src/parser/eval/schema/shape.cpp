// parser/eval: the blocks of shapes. core/scene/shape.h says what each is.
#include "parser/eval/schema/schema.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {
namespace {

constexpr Presence kRequired = Presence::required;

constexpr PropertySpec kSphere[] = {
    {.name = "center", .types = kVec3, .default_value = vec3_default(0, 0, 0), .doc = "the centre"},
    {.name = "radius",
     .types = kNumber,
     .range = above(0),
     .default_value = number_default(1),
     .doc = "the radius"},
};
constexpr PropertySpec kPlane[] = {
    {.name = "normal",
     .types = kVec3,
     .range = kNonzero,
     .default_value = vec3_default(0, 1, 0),
     .doc = "the direction away from the solid side, of any length"},
    {.name = "offset",
     .types = kNumber,
     .doc = "the distance from the origin along the normal; 0 without `offset` and `point`"},
    {.name = "point", .types = kVec3, .doc = "a point of the plane, instead of `offset`"},
};
constexpr PropertySpec kBox[] = {
    {.name = "min",
     .types = kVec3,
     .presence = kRequired,
     .doc = "the corner of the least coordinates"},
    {.name = "max",
     .types = kVec3,
     .presence = kRequired,
     .doc = "the opposite corner; each coordinate is above that of `min`"},
};
constexpr PropertySpec kDisc[] = {
    {.name = "center", .types = kVec3, .default_value = vec3_default(0, 0, 0), .doc = "the centre"},
    {.name = "normal",
     .types = kVec3,
     .range = kNonzero,
     .default_value = vec3_default(0, 1, 0),
     .doc = "the direction it faces, of any length"},
    {.name = "radius",
     .types = kNumber,
     .range = above(0),
     .default_value = number_default(1),
     .doc = "the outer radius"},
    {.name = "hole_radius",
     .types = kNumber,
     .range = at_least(0),
     .default_value = number_default(0),
     .doc = "the radius of the hole in its middle"},
};
constexpr PropertySpec kCylinder[] = {
    {.name = "base", .types = kVec3, .presence = kRequired, .doc = "the centre of one end"},
    {.name = "top", .types = kVec3, .presence = kRequired, .doc = "the centre of the other end"},
    {.name = "radius",
     .types = kNumber,
     .range = above(0),
     .default_value = number_default(1),
     .doc = "the radius"},
    {.name = "open",
     .types = kBool,
     .default_value = bool_default(false),
     .doc = "whether the end discs are left out"},
};
constexpr PropertySpec kCone[] = {
    {.name = "base", .types = kVec3, .presence = kRequired, .doc = "the centre of one end"},
    {.name = "base_radius",
     .types = kNumber,
     .range = at_least(0),
     .default_value = number_default(1),
     .doc = "the radius there"},
    {.name = "top", .types = kVec3, .presence = kRequired, .doc = "the centre of the other end"},
    {.name = "top_radius",
     .types = kNumber,
     .range = at_least(0),
     .default_value = number_default(0),
     .doc = "the radius there; 0 makes a point"},
    {.name = "open",
     .types = kBool,
     .default_value = bool_default(false),
     .doc = "whether the end discs are left out"},
};
constexpr PropertySpec kTriangle[] = {
    {.name = "a", .types = kVec3, .presence = kRequired, .doc = "the first corner"},
    {.name = "b", .types = kVec3, .presence = kRequired, .doc = "the second corner"},
    {.name = "c", .types = kVec3, .presence = kRequired, .doc = "the third corner"},
    {.name = "normals",
     .types = kList,
     .doc = "three vectors, one for each corner, that shade it as if it were curved"},
};
constexpr PropertySpec kQuad[] = {
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
     .doc = "from that corner to the one before"},
};

constexpr BlockSchema kSchemas[] = {
    {.name = "sphere",
     .doc = "A ball.",
     .tables = {kSphere, kPlacedProperties, kTransformProperties},
     .example = "sphere { center <0, 1, 0>  radius 1  material diffuse { color rgb(0.8) } }"},
    {.name = "plane",
     .doc = "An endless plane with a solid half-space behind it, on the side away from its normal.",
     .tables = {kPlane, kPlacedProperties, kTransformProperties},
     .example = "plane { normal y  offset -1  material diffuse { color rgb(0.5) } }"},
    {.name = "box",
     .doc = "A box with its edges along the axes; `rotate` turns it.",
     .tables = {kBox, kPlacedProperties, kTransformProperties},
     .example = "box { min <-1, 0, -1>  max <1, 2, 1>  rotate y*30deg  "
                "material diffuse { color rgb(0.8) } }"},
    {.name = "disc",
     .doc = "A flat disc, with a hole if wanted.",
     .tables = {kDisc, kPlacedProperties, kTransformProperties},
     .example = "disc { normal y  radius 2  hole_radius 0.5  material mirror { } }"},
    {.name = "cylinder",
     .doc = "A round cylinder between two points.",
     .tables = {kCylinder, kPlacedProperties, kTransformProperties},
     .example = "cylinder { base <0, 0, 0>  top <0, 2, 0>  radius 0.5  "
                "material diffuse { color rgb(0.8) } }"},
    {.name = "cone",
     .doc = "A cone, pointed or cut off.",
     .tables = {kCone, kPlacedProperties, kTransformProperties},
     .example = "cone { base <0, 0, 0>  base_radius 1  top <0, 2, 0>  top_radius 0.2  "
                "material diffuse { color rgb(0.8) } }"},
    {.name = "triangle",
     .doc = "A flat triangle, which `normals` can make look curved.",
     .tables = {kTriangle, kPlacedProperties, kTransformProperties},
     .example = "triangle { a <0, 0, 0>  b <1, 0, 0>  c <0, 1, 0>  "
                "material diffuse { color rgb(0.8) } }"},
    {.name = "quad",
     .doc = "A parallelogram.",
     .tables = {kQuad, kPlacedProperties, kTransformProperties},
     .example = "quad { corner <-1, 0, 0>  edge_u <2, 0, 0>  edge_v <0, 2, 0>  "
                "material diffuse { color rgb(0.8) } }"},
};
constexpr const BlockSchema* kAll[] = {&kSchemas[0], &kSchemas[1], &kSchemas[2], &kSchemas[3],
                                       &kSchemas[4], &kSchemas[5], &kSchemas[6], &kSchemas[7]};

}  // namespace

std::span<const BlockSchema* const> shape_schemas() {
  return kAll;
}

}  // namespace alhazen::parser

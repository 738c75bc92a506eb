// parser/eval: the blocks of cameras. core/scene/camera.h says what each is.
#include "parser/eval/schema/schema.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {
namespace {

constexpr PropertySpec kLensProperties[] = {
    {.name = "aperture",
     .types = kNumber,
     .presence = Presence::required,
     .range = at_least(0),
     .doc = "the radius of the lens; 0 keeps everything sharp"},
    {.name = "focus",
     .types = kNumber,
     .range = above(0),
     .doc = "the distance of what is sharp, along the direction of view"},
    {.name = "focus_on", .types = kVec3, .doc = "a point that is sharp, instead of `focus`"},
};
constexpr BlockSchema kLens = {
    .name = "lens",
    .doc = "A thin lens: what is nearer or farther than its focus is blurred.",
    .tables = {kLensProperties},
    .example =
        "camera perspective { position <0, 1, -6>  lens { aperture 0.1  focus_on <0, 1, 0> } }"};
constexpr const BlockSchema* kLenses[] = {&kLens};

constexpr std::array<PropertySpec, 5> kFrame = {{
    {.name = "position",
     .types = kVec3,
     .default_value = vec3_default(0, 0, 0),
     .doc = "where the camera is"},
    {.name = "look_at",
     .types = kVec3,
     .doc = "the point in the middle of the picture; without it "
            "the camera looks along z"},
    {.name = "up",
     .types = kVec3,
     .range = kNonzero,
     .default_value = vec3_default(0, 1, 0),
     .doc = "the direction that is up in the picture"},
    {.name = "translate",
     .types = kVec3,
     .presence = Presence::repeatable,
     .doc = "moves the camera, with all its points"},
    {.name = "rotate",
     .types = kAngles | kTransform,
     .presence = Presence::repeatable,
     .doc = "turns the camera about the origin, with all its points"},
}};
constexpr PropertySpec kPerspective[] = {
    {.name = "fov",
     .types = kAngle,
     .range = strictly_between(0, 180),
     .default_value = angle_default(60),
     .doc = "the full angle of view, from left to right"},
    {.name = "lens", .blocks = kLenses, .kind_named = false, .doc = "depth of field"},
};
constexpr PropertySpec kOrthographic[] = {
    {.name = "width",
     .types = kNumber,
     .range = above(0),
     .default_value = number_default(2),
     .doc = "of the picture, in lengths of the scene"},
};

constexpr BlockSchema kSchemas[] = {
    {.name = "perspective",
     .doc = "Sees as an eye or a photograph.",
     .tables = {kFrame, kPerspective},
     .example = "camera perspective { position <0, 1.5, -6>  look_at <0, 1, 0>  fov 40deg }"},
    {.name = "orthographic",
     .doc = "Parallel rays: size does not change with distance.",
     .tables = {kFrame, kOrthographic},
     .example = "camera orthographic { position <0, 0, -5>  width 4 }"},
};
constexpr const BlockSchema* kAll[] = {&kSchemas[0], &kSchemas[1]};

}  // namespace

std::span<const BlockSchema* const> camera_schemas() {
  return kAll;
}

}  // namespace alhazen::parser

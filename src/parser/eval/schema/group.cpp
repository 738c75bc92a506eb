// parser/eval: blocks that hold other things.
#include "parser/eval/schema/schema.h"

namespace alhazen::parser {
namespace {

constexpr BlockSchema kGroup = {
    .name = "group",
    .doc =
        "Several things as one: transforms apply to all of it, `material` to the shapes in it "
        "that have none. The body of a function `fn f(...) { ... }` is a group, too.",
    .tables = {kPlacedProperties, kTransformProperties},
    .places = true,
    .example =
        "group {\n  sphere { center <0, 1, 0> }\n  sphere { center <0, 2.5, 0>  radius 0.5 }\n"
        "  material diffuse { color rgb(0.9) }\n  rotate z*10deg\n}"};

constexpr BlockSchema kObject = {
    .name = "object",
    .doc =
        "Places a value: what a function yields, or a shape or group with a name. Its body may "
        "move it and give it a material.",
    .tables = {kPlacedProperties, kTransformProperties},
    .example =
        "fn pin(height) {\n  cylinder { base <0, 0, 0>  top y*height  radius 0.1 }\n"
        "  sphere { center y*height  radius 0.2 }\n}\n"
        "pin(2) { translate x  material metal { preset brass } }"};

}  // namespace

const BlockSchema& group_schema() {
  return kGroup;
}
const BlockSchema& object_schema() {
  return kObject;
}

}  // namespace alhazen::parser

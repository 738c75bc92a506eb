// parser/eval: properties that many kinds of blocks share.
#include "parser/eval/schema/schema.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {

const std::array<PropertySpec, 4> kTransformProperties = {{
    {.name = "translate",
     .types = kVec3,
     .presence = Presence::repeatable,
     .doc = "moves by a vector"},
    {.name = "rotate",
     .types = kAngles | kTransform,
     .presence = Presence::repeatable,
     .doc = "turns about x, then y, then z: `rotate <0, 30deg, 0>`, `rotate y*30deg`; or about any "
            "axis: `rotate about(<1, 1, 0>, 30deg)`"},
    {.name = "scale",
     .types = kNumber | kVec3,
     .presence = Presence::repeatable,
     .doc = "stretches about the origin, by one factor or one for each axis; no factor is 0"},
    {.name = "matrix",
     .types = kList | kTransform,
     .presence = Presence::repeatable,
     .doc = "any affine map, as three rows of four numbers, the last of each the translation"},
}};

const std::array<PropertySpec, 2> kPlacedProperties = {{
    {.name = "material",
     .types = kMaterial,
     .doc = "what it is made of; without it the material of the group around it"},
    {.name = "name",
     .types = kString,
     .doc = "what it is called in data channels; without it \"sphere 3\" and the like"},
}};

}  // namespace alhazen::parser

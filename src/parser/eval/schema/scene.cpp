// parser/eval: the whole file as a block. Its tables are put together when first asked for, since
// they refer to those of other files.
#include "parser/eval/schema/schema.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {

const BlockSchema& scene_schema() {
  static const PropertySpec properties[] = {
      {.name = "camera",
       .presence = Presence::required,
       .blocks = camera_schemas(),
       .doc = "what looks at the scene"},
      {.name = "background",
       .types = kColor,
       .range = at_least(0),
       .default_value = gray_default(0),
       .blocks = background_schemas(),
       .doc = "what is seen where nothing is"},
      {.name = "render",
       .blocks = render_schemas(),
       .kind_named = false,
       .doc = "how the picture is made"},
  };
  static const BlockSchema schema = {
      .name = "scene",
      .doc = "The file itself: shapes, groups, objects and lights, and each of these at most once.",
      .tables = {properties},
      .places = true,
      .example =
          "camera perspective { position <0, 1, -5>  look_at <0, 1, 0> }\n"
          "background rgb(0.3, 0.5, 0.8)"};
  return schema;
}

}  // namespace alhazen::parser

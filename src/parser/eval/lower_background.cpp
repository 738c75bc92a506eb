// parser/eval: the background.
#include "parser/eval/files.h"
#include "parser/eval/lower.h"
#include "parser/eval/texture_value.h"

namespace alhazen::parser {

std::optional<Background> lower_background(Context& context, const Property& property) {
  if (!property.block) {
    return Background{SolidBackground{property.value.as<Rgbd>()}, property.value_span};
  }
  const Properties& p = *property.block;
  if (p.schema().name == "gradient") {
    auto stops = gradient_stops(context, p.find("stops")->value, p.span("stops"), -1, 1);
    if (!stops) return std::nullopt;
    return Background{GradientBackground{std::move(*stops)}, p.head()};
  }
  const auto path = resolve_file(context, p.span("file"), p.text_or_empty("file"));
  if (!path) return std::nullopt;
  const ImageId id = context.store().add(
      ImageFile{path->string(), p.text_or_empty("color_space"), p.span("file")});
  return Background{EnvironmentBackground{id, p.angle_deg("rotation"), p.number("intensity")},
                    p.head()};
}

}  // namespace alhazen::parser

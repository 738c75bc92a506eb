// parser/eval: colours and textures where either will do, and stops of gradients.
#pragma once

#include <optional>
#include <vector>

#include "core/scene/camera.h"
#include "parser/eval/context.h"

namespace alhazen::parser {

// The texture that a value is; a colour becomes a solid one. Precondition: a colour or a texture.
TextureId texture_of(Context& context, const Value& value, SourceSpan span);

// Stops from a list of colours, spread evenly over [first, last], or of pairs [position, colour] in
// order. Reports what is wrong with the list and gives nothing then.
std::optional<std::vector<GradientStop>> gradient_stops(Context& context, const Value& list,
                                                        SourceSpan span, double first, double last);

}  // namespace alhazen::parser

// parser/eval: a last look at the finished scene.
#pragma once

#include "core/scene/scene.h"
#include "parser/eval/context.h"

namespace alhazen::parser {

// Errors for numbers that are not finite, which no rule before should have let through; warnings
// for what is likely not meant: no light, glass without an inside.
void check_scene(Context& context, const Scene& scene);

}  // namespace alhazen::parser

// parser/eval: from the tree of what is placed to the lists of the scene.
#pragma once

#include "core/scene/scene.h"
#include "parser/eval/context.h"
#include "parser/eval/object.h"

namespace alhazen::parser {

// Appends all shapes and lights of `root`, in the order of the text, with the materials, textures
// and images that they use and no others. Reports transforms that are singular as a whole.
void flatten(Context& context, const Group& root, Scene& scene);

}  // namespace alhazen::parser

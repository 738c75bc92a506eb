// parser/eval: which file a name in a scene means, and whether the scene may use it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "parser/eval/context.h"

namespace alhazen::parser {

// The file that `name`, written at `at`, stands for: relative to the folder of the text it is
// written in, symbolic links resolved. Reports and gives nothing when it is not a file or lies
// where EvalOptions::files does not let the scene look.
std::optional<std::filesystem::path> resolve_file(Context& context, SourceSpan at,
                                                  const std::string& name);

}  // namespace alhazen::parser

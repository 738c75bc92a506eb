// parser/eval: "did you mean".
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace alhazen::parser {

// The candidate nearest to `name` in edits (insertion, deletion, change, exchange of neighbours;
// Damerau), if at most a third of the letters differ; the first of equals.
std::optional<std::string_view> nearest(std::string_view name,
                                        const std::vector<std::string_view>& candidates);

}  // namespace alhazen::parser

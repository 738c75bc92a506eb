// core/base: "did you mean": the known name that a misspelt one is likely to stand for.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace alhazen {

// How many single-character insertions, deletions, replacements and swaps of neighbours turn `a`
// into `b`, no character being touched twice: the optimal string alignment distance.
std::size_t edit_distance(std::string_view a, std::string_view b);

// The candidate nearest to `name`, the earlier one if two are equally near; nothing if even the
// nearest needs more than one change for every three characters (and at least one is allowed).
// Names that differ in case only are always near, a name of more than 200 bytes is near to none.
std::optional<std::string_view> near_name(std::string_view name,
                                          std::span<const std::string_view> candidates);

}  // namespace alhazen

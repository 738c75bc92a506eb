#include "app/cli/verb.h"

#include <algorithm>

namespace alhazen {
namespace {

constexpr Verb kVerbs[] = {
    {"help", "say what a verb does and which options it has", run_help},
    {"version", "print the versions of the program and its libraries", run_version},
};

}  // namespace

std::span<const Verb> verbs() {
  return kVerbs;
}

const Verb* find_verb(std::string_view name) {
  const auto* found = std::ranges::find(kVerbs, name, &Verb::name);
  return found == std::end(kVerbs) ? nullptr : found;
}

}  // namespace alhazen

#include "app/cli/verb.h"

#include <algorithm>

namespace alhazen {
namespace {

constexpr Verb kVerbs[] = {
    {"render", "render a scene to an EXR file", run_render},
    {"check", "find every mistake in a scene without rendering it", run_check},
    {"fmt", "rewrite scenes in the canonical layout", run_fmt},
    {"explain", "say what a scene asks of the renderer, and which lines ask for it", run_explain},
    {"dump", "print what the program makes of a scene, step by step", run_dump},
    {"compare", "say how two pictures differ, in figures and to look at", run_compare},
    {"import", "write the scene of another program as a .scn text", run_import},
    {"export-pov", "write the equivalent scene for POV-Ray 3.7", run_export_pov},
    {"cross-check", "render scenes here and with POV-Ray, and compare", run_cross_check},
    {"study", "show what accuracy costs in time, scene by scene", run_study},
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

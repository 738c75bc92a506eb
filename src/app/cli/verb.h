// app/cli: the verbs, one file each. A verb takes the words after its name.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/exit_code.h"

namespace alhazen {

using Arguments = std::vector<std::string>;

ExitCode run_render(const Arguments& arguments);
ExitCode run_check(const Arguments& arguments);
ExitCode run_fmt(const Arguments& arguments);
ExitCode run_explain(const Arguments& arguments);
ExitCode run_dump(const Arguments& arguments);
ExitCode run_compare(const Arguments& arguments);
ExitCode run_import(const Arguments& arguments);
ExitCode run_export_pov(const Arguments& arguments);
ExitCode run_cross_check(const Arguments& arguments);
ExitCode run_study(const Arguments& arguments);
ExitCode run_help(const Arguments& arguments);
ExitCode run_version(const Arguments& arguments);

struct Verb {
  std::string_view name;
  std::string_view summary;  // for the list that `alhazen help` prints
  ExitCode (*run)(const Arguments&);
};

std::span<const Verb> verbs();
const Verb* find_verb(std::string_view name);

}  // namespace alhazen

// app/cli: alhazen --version: what this program is made of, and what it found when it started.
#include "app/cli/version.h"

#include <CLI/Version.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/arguments.h"
#include "app/cli/streams.h"
#include "core/base/library_version.h"
#include "render/color/library_versions.h"
#include "render/image/library_versions.h"
#include "render/wave/isa.h"

namespace alhazen {

std::string program_version() {
  return ALHAZEN_VERSION;
}

namespace {

// Header-only libraries cannot be replaced after the build: there is nothing to be loaded.
std::vector<LibraryVersion> all_libraries() {
  std::vector<LibraryVersion> libraries = {
      {"CLI11", CLI11_VERSION, ""},
      {"fmt",
       fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100),
       ""},
      {"nlohmann-json",
       fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                   NLOHMANN_JSON_VERSION_PATCH),
       ""},
  };
  for (const auto& more : {render::image_library_versions(), render::color_library_versions()}) {
    libraries.insert(libraries.end(), more.begin(), more.end());
  }
  return libraries;
}

// The instruction sets that the renderer was compiled for.
std::vector<std::string_view> kernel_names() {
  std::vector<std::string_view> names;
  for (const render::IsaInfo& each : render::kIsaInfo) {
    if (render::is_compiled(each.isa)) names.push_back(each.name);
  }
  return names;
}

std::string as_text() {
  std::string text = fmt::format("alhazen {}\n", program_version());
  if (*ALHAZEN_GIT != '\0') text += fmt::format("  source    {}\n", ALHAZEN_GIT);
  text += fmt::format("  compiler  {}\n  build     {}\n", ALHAZEN_COMPILER, ALHAZEN_BUILD_TYPE);
  text += fmt::format("  kernels   {} (used: {})\n", fmt::join(kernel_names(), ", "),
                      render::info(render::usable_isas().back()).name);
  for (const LibraryVersion& library : all_libraries()) {
    text += fmt::format("  library   {} {}", library.name, library.compiled);
    if (!library.loaded.empty() && library.loaded != library.compiled) {
      text += fmt::format(" (loaded {})", library.loaded);
    }
    text += '\n';
  }
  return text;
}

std::string as_json() {
  nlohmann::ordered_json libraries = nlohmann::ordered_json::array();
  for (const LibraryVersion& library : all_libraries()) {
    nlohmann::ordered_json entry = {
        {"name", library.name}, {"compiled", library.compiled}, {"loaded", nullptr}};
    if (!library.loaded.empty()) entry["loaded"] = library.loaded;
    libraries.push_back(std::move(entry));
  }
  const nlohmann::ordered_json out = {
      {"name", "alhazen"},
      {"version", program_version()},
      {"source", ALHAZEN_GIT},
      {"compiler", ALHAZEN_COMPILER},
      {"build_type", ALHAZEN_BUILD_TYPE},
      {"kernels", kernel_names()},
      {"kernels_used", render::info(render::usable_isas().back()).name},
      {"libraries", libraries}};
  return out.dump(2) + "\n";
}

}  // namespace

ExitCode run_version(const Arguments& arguments) {
  CommandLine line("--version", "Prints the versions of the program and of its libraries.",
                   "  alhazen --version\n  alhazen --version --json\n");
  bool json = false;
  line.flag("--json", json, "as JSON");
  if (const auto code = line.read(arguments)) return *code;
  return print(json ? as_json() : as_text());
}

}  // namespace alhazen

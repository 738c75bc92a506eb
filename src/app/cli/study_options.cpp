#include "app/cli/study_options.h"

#include "app/cli/render_values.h"

namespace alhazen {
namespace {

constexpr const char* kDescription =
    "Shows what accuracy costs in time: renders each scene many times, with every knob that "
    "trades\n"
    "one for the other, and writes a page with charts of error against time, and the same as CSV\n"
    "and JSON. Errors are measured against a converged picture, whose own error is told.\n"
    "\n"
    "Only knobs that the scene's effects call for are turned. A study of one scene takes about "
    "two\n"
    "minutes; --budget says otherwise, and the page says what did not fit.";

constexpr const char* kExamples =
    "  alhazen study scene.scn -o study              study/scene.html, .csv and .json\n"
    "  alhazen study scenes/gallery/*.scn -o study --budget 600\n"
    "                                                and study/index.html, in ten minutes\n"
    "  alhazen study scene.scn -o study --size 320x180 --threads 4\n"
    "  alhazen study scene.scn -o study --povray     POV-Ray on the same chart\n";

auto whole(std::int64_t low, std::int64_t high) {
  return [low, high](const std::string& text) -> Result<int> {
    const auto count = to_whole(text, low, high);
    if (!count) return count.error();
    return static_cast<int>(count.value());
  };
}

}  // namespace

std::optional<ExitCode> read_study_options(const Arguments& arguments, StudyRequest& request) {
  constexpr double kLongestBudget = 1e7;
  constexpr int kMostRuns = 99;
  CommandLine line("study", kDescription, kExamples);
  line.scene_arguments(request.scenes);
  line.text_option("-o,--output", "DIR", request.folder,
                   "the folder for NAME.html, .csv and .json of each scene, and index.html\n"
                   "of several; made if it is not there")
      ->required();
  line.value_option(
      "--budget", "SECONDS", request.budget,
      [](const std::string& text) -> Result<std::optional<double>> {
        const auto seconds = to_number(text, 1, kLongestBudget);
        if (!seconds) return seconds.error();
        return std::optional(seconds.value());
      },
      "choose what to render so that all scenes take about this long [120 each]");
  line.value_option("--size", "WxH", request.size, to_size,
                    "pixels of the pictures [the scene's, made smaller to 160 of width]");
  line.value_option("--runs", "N", request.runs, whole(1, kMostRuns),
                    "how often each setting is timed, in turn [3]");
  line.value_option("--threads", "N", request.threads, whole(1, kMaxThreads),
                    "of each rendering that is timed; the converged pictures take one a\ncore [1]");
  line.value_option("--isa", "NAME", request.isa, to_isa,
                    "instructions: auto, baseline, avx2 or avx512; the same bits with each [auto]");
  line.flag("--povray", request.with_povray,
            "also POV-Ray 3.7, at its anti-aliasing methods and thresholds");
  line.text_option("--povray-program", "PROGRAM", request.povray, "POV-Ray 3.7 [povray]");
  line.list_option("-D,--define", "NAME=VALUE", request.common.defines, to_define,
                   "another value for a `param` of the scenes; may be repeated");
  line.flag("--allow-outside", request.common.allow_outside,
            "let the scenes read files outside of the folders they stand in");
  line.text_option("--ocio", "FILE", request.common.color_file,
                   "OpenColorIO configuration [$OCIO, or else a built-in one]");
  line.value_option("--progress", "STYLE", request.progress, to_progress_style,
                    "auto, bar, plain or none [auto: a bar on a terminal]");
  line.flag("--json", request.json, "print the figures as JSON on stdout, not the table");
  if (const auto code = line.read(arguments)) return code;
  if (request.progress == ProgressStyle::json) {
    return line.complain("--progress: expected one of auto, bar, plain, none, found `json`");
  }
  return std::nullopt;
}

}  // namespace alhazen

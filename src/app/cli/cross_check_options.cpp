#include "app/cli/cross_check_options.h"

#include "app/cli/render_values.h"

namespace alhazen {

std::optional<ExitCode> read_cross_check_options(const Arguments& arguments,
                                                 CrossCheckRequest& request) {
  CommandLine line("cross-check",
                   "Renders scenes here and with POV-Ray, one ray through the centre of each "
                   "pixel, and compares "
                   "the pictures to the rounding of a half float. A scene x.scn is exported; if "
                   "there is an x.pov "
                   "beside it, POV-Ray renders that too. Scenes that POV-Ray cannot say exactly "
                   "have a tolerance "
                   "in expected.json beside them.",
                   "  alhazen cross-check scenes/cross/*.scn --report build/cross\n"
                   "  alhazen cross-check scene.scn --size 320x240 --json\n");
  line.scene_arguments(request.scenes);
  line.text_option("--report", "DIR", request.report_folder,
                   "write index.html, results.json, the .pov files and all pictures there");
  line.value_option("--size", "WxH", request.size, to_size,
                    "width and height of the pictures [each scene's]");
  line.text_option(
      "--expect", "FILE", request.allowances,
      "tolerances and their reasons [expected.json beside each scene, if there is one]");
  line.text_option("--povray", "PROGRAM", request.povray, "POV-Ray 3.7 [povray]");
  line.value_option(
      "--threads", "N", request.threads,
      [](const std::string& text) -> Result<int> {
        const auto count = to_whole(text, 1, kMaxThreads);
        if (!count) return count.error();
        return static_cast<int>(count.value());
      },
      "of both programs [1]");
  line.value_option(
      "--time-limit", "SECONDS", request.time_limit_seconds,
      [](const std::string& text) { return to_number(text, 1, 1e6); },
      "for POV-Ray, each scene [600]");
  line.list_option("-D,--define", "NAME=VALUE", request.common.defines, to_define,
                   "another value for a `param` of the scenes; may be repeated");
  line.flag("--allow-outside", request.common.allow_outside,
            "let the scenes read files outside of the folders they stand in");
  line.text_option("--ocio", "FILE", request.common.color_file,
                   "OpenColorIO configuration [$OCIO, or else a built-in one]");
  line.flag(
      "--exported-only", request.exported_only,
      "leave .pov files that stand beside scenes alone: they are programs, which POV-Ray runs");
  line.flag("--json", request.json, "print the figures as JSON on stdout");
  return line.read(arguments);
}

}  // namespace alhazen

#include "app/cli/render_options.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "app/batch/frame_list.h"
#include "app/batch/frame_name.h"
#include "app/cli/arguments.h"
#include "app/cli/render_values.h"
#include "app/cli/streams.h"

namespace alhazen {
namespace {

constexpr const char* kDescription =
    "Renders a scene to an OpenEXR file: half-float RGBA, scene-linear, and with --aov a second,\n"
    "lossless part of data. The file appears whole or not at all.\n"
    "\n"
    "The scene's own render { ... } block says how; options take its place for this run.";

constexpr const char* kExamples =
    "  alhazen render scene.scn                      writes scene.exr to the current folder\n"
    "  alhazen render scene.scn -o a.exr --preview a.png --size 640x360 --samples 4\n"
    "  alhazen render scene.scn -D ball_ior=1.33     for `param ball_ior = 1.5` in the scene\n"
    "  alhazen render scene.scn --max-error 1/255    as many samples as that takes\n"
    "  alhazen render turn.scn --frames 1-48 -o turn.####.exr --skip-existing\n"
    "                                                the scene says `param frame = 1`\n"
    "  alhazen render scene.scn -o - | oiiotool - -info\n"
    "\n"
    "Stop it with Ctrl-C (or SIGTERM): it ends within two seconds, leaves no half-written file "
    "and\n"
    "exits with 75. All exit codes: alhazen help.\n";

Result<std::uint64_t> to_seed(const std::string& text) {
  const auto seed = to_whole(text, 0, kMaxSeed);
  if (!seed) return seed.error();
  return static_cast<std::uint64_t>(seed.value());
}

// Wraps to_whole for a target of its own type.
auto whole(std::int64_t low, std::int64_t high) {
  return [low, high](const std::string& text) -> Result<int> {
    const Result<std::int64_t> number = to_whole(text, low, high);
    if (!number) return number.error();
    return static_cast<int>(number.value());
  };
}

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

auto number(double low, double high) {
  return [low, high](const std::string& text) { return to_number(text, low, high); };
}

void add_output_options(CommandLine& line, RenderRequest& request, bool& as_half, bool& as_float) {
  line.begin_group("Output");
  line.text_option("-o,--output", "OUT.exr", request.output,
                   "the picture; - for stdout [SCENE.exr in the current folder]");
  line.text_option("--preview", "OUT.png", request.preview,
                   "also an 8-bit picture as a display shows it");
  line.value_option("--aov", "LIST", request.aovs, to_aovs,
                    "data channels: depth, normal, position, uv, albedo, object, material\n"
                    "(Cryptomatte), samples, cost; with commas between, or all; and\n"
                    "signature and margin: what the rays decided, and how nearly; error\n"
                    "comes with --max-error");
  line.flag("--half", as_half, "store the picture in 16 bits a channel [default]");
  line.flag("--float", as_float, "store it in 32 bits a channel");
}

void add_picture_options(CommandLine& line, RenderRequest& request, bool& outside) {
  SettingOverrides& settings = request.settings;
  line.begin_group("Picture");
  line.value_option("--size", "WxH", settings.size, to_size, "pixels of the whole frame");
  line.value_option("--crop", "X,Y,W,H", request.crop, to_crop,
                    "only these pixels of the frame, from its upper left corner;\n"
                    "they come out the same as in the whole picture");
  line.list_option("-D,--define", "NAME=VALUE", request.defines, to_define,
                   "another value for a `param` of the scene; may be repeated");
  line.flag("--allow-outside", outside,
            "let the scene read files outside of the folder it stands in");
  line.value_option("--frames", "LIST", request.frames, parse_frame_list,
                    "frames as 1-100, 1-100x5 or 1-3,7; each is given to the scene's\n"
                    "`param frame`, and -o needs a place for it: a.####.exr or a.%04d.exr");
  line.flag("--skip-existing", request.skip_existing,
            "leave out pictures that are there, complete, and made by the same\n"
            "program from the same scene with the same options");
}

void add_quality_options(CommandLine& line, RenderRequest& request) {
  SettingOverrides& settings = request.settings;
  line.begin_group("Quality (in the place of the scene's own settings)");
  line.value_option("--samples", "N", settings.samples, whole(1, kMaxSamples),
                    "camera rays a pixel; with --adaptive, at most");
  line.value_option("--adaptive", "T", settings.adaptive_threshold, number(0, kNoLimit),
                    "stop a pixel once its standard error is at most T, between 16\n"
                    "samples, or the scene's min_samples, and --samples: 1024 if neither that\n"
                    "nor an adaptive scene says how many; 0 turns it off");
  line.value_option("--max-error", "E[@SHARE%]", settings.max_error, to_error_target,
                    "choose samples, depth and cutoff so that the RMSE of the picture is\n"
                    "at most E, as in 1/255, or so that this share of its pixels is off by\n"
                    "no more, as in 1/255@99%; 0 turns a scene's max_error off");
  line.value_option("--preset", "NAME", settings.preset, to_preset,
                    "a --max-error by name: draft 1/64, normal 1/255, final 1/1024");
  line.value_option("--filter", "NAME[:RADIUS]", settings.filter, to_filter,
                    "box, tent, gaussian or mitchell; the radius is in pixels");
  line.value_option("--max-depth", "N", settings.max_depth, whole(0, kMaxDepth),
                    "reflections and refractions along a path");
  line.value_option("--cutoff", "C", settings.cutoff, number(0, 1),
                    "do not follow a ray that would add less than C of a pixel's light;\n"
                    "0 follows all");
  line.value_option("--seed", "N", settings.seed, to_seed, "another draw of the random numbers");
  line.value_option("--precision", "TYPE", request.precision, to_precision,
                    "of the arithmetic: float, double [default] or quad (very slow)");
}

void add_color_options(CommandLine& line, RenderRequest& request) {
  line.begin_group("Colour");
  line.text_option("--ocio", "FILE", request.color_file,
                   "OpenColorIO configuration [$OCIO, or else a built-in one: ACEScg]");
  line.text_option("--display", "NAME", request.display,
                   "display of the preview [the configuration's first]");
  line.text_option("--view", "NAME", request.view,
                   "its view [the display's first]; built in are `Un-tone-mapped`,\n"
                   "`ACES 1.0 SDR` and `Raw`");
}

void add_run_options(CommandLine& line, RenderRequest& request) {
  line.begin_group("Run");
  line.value_option("--threads", "N", request.threads, whole(1, kMaxThreads),
                    "[one a core]; the picture is the same for any number");
  line.value_option("--time-limit", "SECONDS", request.time_limit, number(0, kNoLimit),
                    "end --max-error with what there is by then, and with code 75 if that\n"
                    "is not good enough; 0 is no limit");
  line.value_option("--isa", "NAME", request.isa, to_isa,
                    "instruction set: auto [default], baseline, avx2 or avx512; the\n"
                    "picture is the same with any");
  line.value_option("--progress", "STYLE", request.progress, to_progress_style,
                    "on stderr: bar, plain, json, none, or auto [bar on a terminal]");
  line.text_option("--stats", "FILE", request.statistics,
                   "rays, stages, times and memory as JSON; - for stdout;\n"
                   "with --frames a list of them");
  line.flag("-q,--quiet", request.quiet, "no progress and no summary, only what went wrong");
}

// The scene's name with another ending, in the current folder.
std::string default_output(const RenderRequest& request) {
  const std::string stem = std::filesystem::path(request.scene).stem();
  return stem + (request.frames.empty() ? ".exr" : ".####.exr");
}

// Endings of pictures that this program does not write.
constexpr std::string_view kOtherPictures[] = {".jpg", ".jpeg", ".tif",  ".tiff", ".bmp",
                                               ".gif", ".hdr",  ".webp", ".ppm",  ".tga"};

std::string ending(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension();
  for (char& c : ending)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending;
}

// A file's name promises what is in it.
Status check_endings(const RenderRequest& request) {
  const auto is_other = [](const std::string& ending) {
    return std::ranges::find(kOtherPictures, ending) != std::end(kOtherPictures);
  };
  const std::string output = ending(request.output), preview = ending(request.preview);
  if (output == ".png" || is_other(output)) {
    return Error{
        ErrorCode::usage,
        fmt::format("-o {}: the picture is OpenEXR; for one to look at: `--preview {}`",
                    request.output,
                    std::filesystem::path(request.output).replace_extension(".png").string())};
  }
  if (preview == ".exr" || is_other(preview)) {
    return Error{ErrorCode::usage,
                 fmt::format("--preview {}: the preview is a PNG", request.preview)};
  }
  return Unit{};
}

// Places for the number of a frame are there if there are frames.
Status check_places(const RenderRequest& request) {
  for (const std::string& pattern : {request.output, request.preview}) {
    const std::string_view place = frame_place(pattern);
    if (request.frames.empty() && !place.empty()) {
      return Error{ErrorCode::usage, fmt::format("`{}`: `{}` is for `--frames`", pattern, place)};
    }
    if (request.frames.size() <= 1 || pattern.empty()) continue;
    if (const auto name = frame_name(pattern, 0); !name) return name.error();
  }
  return Unit{};
}

Status check_names(const RenderRequest& request) {
  const bool to_stdout = request.output == "-";
  if (to_stdout && request.statistics == "-") {
    return Error{ErrorCode::usage, "the picture and --stats cannot both go to stdout"};
  }
  if (to_stdout && request.skip_existing) {
    return Error{ErrorCode::usage, "--skip-existing needs a file, and -o is stdout"};
  }
  if (request.preview == "-") return Error{ErrorCode::usage, "--preview needs a file name"};
  for (const parser::Define& define : request.defines) {
    if (!request.frames.empty() && define.name == "frame") {
      return Error{ErrorCode::usage, "-D frame and --frames both set the scene's `param frame`"};
    }
  }
  if (request.frames.size() > 1 && to_stdout) {
    return Error{ErrorCode::usage, "several frames cannot all go to stdout"};
  }
  if (Status good = check_endings(request); !good) return good;
  return check_places(request);
}

}  // namespace

std::optional<ExitCode> read_render_options(const Arguments& arguments, RenderRequest& request) {
  CommandLine line("render", kDescription, kExamples);
  bool as_half = false, as_float = false, outside = false;
  line.scene_argument(request.scene);
  add_output_options(line, request, as_half, as_float);
  add_picture_options(line, request, outside);
  add_quality_options(line, request);
  add_color_options(line, request);
  add_run_options(line, request);
  if (const auto code = line.read(arguments)) return code;

  if (as_half && as_float) return line.complain("--half and --float exclude each other");
  if (as_float) request.beauty = SamplePrecision::float32;
  if (outside) request.files = parser::FileAccess::anywhere;
  if (request.output.empty()) request.output = default_output(request);
  if (request.quiet) request.progress = ProgressStyle::none;
  if (const Status good = check_names(request); !good) return line.complain(good.error().message);
  return std::nullopt;
}

}  // namespace alhazen

// app/cli: alhazen compare: how two pictures differ, in figures and to look at.
#include "app/compare/compare.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "app/cli/arguments.h"
#include "app/cli/overwrite_check.h"
#include "app/cli/streams.h"
#include "app/compare/difference_picture.h"
#include "app/compare/page_view.h"
#include "app/compare/report_json.h"
#include "app/compare/report_page.h"
#include "app/compare/report_text.h"
#include "core/base/file.h"
#include "render/image/exr_write.h"

namespace alhazen {
namespace {

constexpr const char* kDescription =
    "Compares picture A with picture B, the reference: errors of each channel, SSIM, and FLIP.\n"
    "Both are EXR files, or both PNG or JPEG files. The exit code is 0 if no pixel differs by\n"
    "more than --max-error, and 5 if one does or the pictures differ in shape.";

constexpr const char* kExamples =
    "  alhazen compare new.exr old.exr\n"
    "  alhazen compare new.exr old.exr --max-error 0.001 --html new.html\n"
    "  alhazen compare draft.exr final.exr --channels RGB,Z -o difference.exr\n"
    "  alhazen compare a.exr b.exr --json | jq '.parts[0].layers[0].flip.mean'\n"
    "\n"
    "docs/compare.md says what the figures are.\n";

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

struct CompareRequest {
  std::string a, b;
  CompareSettings settings;
  bool json = false;
  std::string difference, page;
  std::string color_file, display, view;
};

auto number(double low, double high) {
  return [low, high](const std::string& text) { return to_number(text, low, high); };
}

Result<std::vector<std::string>> to_names(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    if (end == begin) {
      return Error{ErrorCode::usage,
                   fmt::format("expected names with commas between, found `{}`", text)};
    }
    names.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

// A file's name promises what is in it.
Status check_ending(const char* option, const std::string& path,
                    std::initializer_list<std::string_view> endings) {
  std::string ending = std::filesystem::path(path).extension();
  for (char& c : ending)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (path.empty() || std::ranges::find(endings, ending) != endings.end()) return Unit{};
  return Error{ErrorCode::usage, fmt::format("{} {}: expected a file name that ends in {}", option,
                                             path, *endings.begin())};
}

Status check_outputs(const CompareRequest& request) {
  if (request.page.empty() &&
      !(request.color_file.empty() && request.display.empty() && request.view.empty())) {
    return Error{ErrorCode::usage,
                 "--ocio, --display and --view are for the page: --html PAGE.html"};
  }
  if (Status good = check_ending("-o", request.difference, {".exr"}); !good) return good;
  return check_ending("--html", request.page, {".html", ".htm"});
}

std::optional<ExitCode> read_options(const Arguments& arguments, CompareRequest& request) {
  CommandLine line("compare", kDescription, kExamples);
  CompareSettings& settings = request.settings;
  line.add_option("A", request.a, "the picture")->required()->type_name("");
  line.add_option("B", request.b, "the reference")->required()->type_name("");
  line.begin_group("What counts as different");
  line.value_option("--max-error", "E", settings.tolerance.absolute, number(0, kNoLimit),
                    "values may be E apart [0: they must be equal]");
  line.value_option("--max-relative", "R", settings.tolerance.relative, number(0, kNoLimit),
                    "or R times the reference's value, if that is more [0]");
  line.value_option("--channels", "LIST", settings.channels, to_names,
                    "compare only these channels or layers: R,G,Z or RGB,N,albedo");
  line.begin_group("Measures");
  line.value_option("--peak", "P", settings.peak, number(1e-30, 1e30),
                    "the largest value, for the PSNR [1]");
  line.value_option("--exposure", "EV", settings.exposure, number(-100, 100),
                    "stops brighter for SSIM, FLIP and the page [0]");
  line.value_option("--pixels-per-degree", "N", settings.pixels_per_degree, number(1, 1000),
                    "how close FLIP looks [67.02: a display of 3840 pixels,\n"
                    "as far away as it is wide]");
  line.flag("--hdr-flip", settings.hdr_flip,
            "also FLIP at all exposures that the reference has light for; takes\n"
            "about a second for each, of a picture of 1920 x 1080");
  line.begin_group("Output (a table on stdout)");
  line.flag("--json", request.json, "JSON on stdout in place of the table");
  line.text_option("-o,--output", "DIFF.exr", request.difference,
                   "A - B, signed, of each channel, and FLIP in the channel FLIP.E");
  line.text_option("--html", "PAGE.html", request.page,
                   "both pictures, the difference, FLIP and the figures; needs no network");
  line.begin_group("Colour of the page");
  line.text_option("--ocio", "FILE", request.color_file,
                   "OpenColorIO configuration [$OCIO, or else a built-in one]");
  line.text_option("--display", "NAME", request.display, "display [the configuration's first]");
  line.text_option("--view", "NAME", request.view, "its view [the display's first]");
  if (const auto code = line.read(arguments)) return code;
  if (const Status good = check_outputs(request); !good) {
    return line.complain(good.error().message);
  }
  return std::nullopt;
}

// Found before the pictures are read: a misspelt view costs no time.
Result<std::optional<PageView>> open_view(const CompareRequest& request) {
  if (request.page.empty()) return std::optional<PageView>();
  const auto colors = render::ColorConfig::open(render::color_source(request.color_file));
  if (!colors) return colors.error();
  Result<PageView> view = PageView::make(colors.value(), request.display, request.view);
  if (!view) return view.error();
  return std::optional<PageView>(std::move(view).value());
}

Status write_difference(const CompareRequest& request, const Comparison& comparison) {
  if (request.difference.empty()) return Unit{};
  if (comparison.parts.empty()) {
    write_stderr(fmt::format("alhazen: `{}` is not written: nothing could be compared\n",
                             request.difference));
    return Unit{};
  }
  const Result<DifferencePicture> picture = difference_picture(comparison);
  if (!picture) return picture.error();
  for (const std::string& sentence : picture.value().left_out)
    write_stderr("alhazen: " + sentence + "\n");
  const Result<render::ExrReport> written =
      render::write_exr(request.difference, picture.value().file);
  if (!written) return written.error();
  return Unit{};
}

ExitCode compare(const CompareRequest& request, const std::optional<PageView>& view) {
  const Result<ComparedPicture> a = read_picture(request.a);
  if (!a) return report(a.error());
  const Result<ComparedPicture> b = read_picture(request.b);
  if (!b) return report(b.error());
  const Result<Comparison> comparison = compare_pictures(a.value(), b.value(), request.settings);
  if (!comparison) return report(comparison.error());
  if (const Status good = write_difference(request, comparison.value()); !good) {
    return report(good.error());
  }
  if (view) {
    const auto page = comparison_page(comparison.value(), a.value(), b.value(), *view);
    if (!page) return report(page.error());
    if (const Status good = write_file_atomic(request.page, page.value()); !good) {
      return report(good.error());
    }
  }
  // File names need not be UTF-8, which JSON is.
  const std::string text =
      request.json ? comparison_json(comparison.value(), a.value(), b.value())
                             .dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
                         "\n"
                   : comparison_text(comparison.value(), a.value(), b.value());
  if (const ExitCode printed = print(text); printed != ExitCode::done) return printed;
  return comparison.value().passed() ? ExitCode::done : ExitCode::different;
}

}  // namespace

ExitCode run_compare(const Arguments& arguments) {
  CompareRequest request;
  if (const auto code = read_options(arguments, request)) return *code;
  const Status good = check_overwrites({request.difference, request.page}, {request.a, request.b});
  if (!good) return report(good.error());
  const auto view = open_view(request);
  if (!view) return report(view.error());
  return compare(request, view.value());
}

}  // namespace alhazen

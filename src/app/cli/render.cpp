// app/cli: alhazen render: options to pictures.
#include <fmt/format.h>

#include "app/batch/frame_name.h"
#include "app/cli/interrupt.h"
#include "app/cli/render_options.h"
#include "app/cli/render_picture.h"
#include "app/cli/streams.h"
#include "core/base/file.h"

namespace alhazen {
namespace {

// `pattern` for this frame; a name without a place for the number is taken as it is, which
// read_render_options allows for a single frame only.
std::string name_for(const std::string& pattern, int frame) {
  return frame_place(pattern).empty() ? pattern : frame_name(pattern, frame).value();
}

std::vector<PictureJob> picture_jobs(const RenderRequest& request) {
  if (request.frames.empty()) return {{std::nullopt, {}, request.output, request.preview}};
  std::vector<PictureJob> jobs;
  for (const int frame : request.frames) {
    const FramePosition position{fmt::format("frame {}", frame), jobs.size(),
                                 request.frames.size()};
    jobs.push_back(
        {frame, position, name_for(request.output, frame), name_for(request.preview, frame)});
  }
  return jobs;
}

// A misspelt display or view is found before anything is rendered.
Result<render::ColorConfig> open_colors(const RenderRequest& request) {
  auto colors = render::ColorConfig::open(render::color_source(request.color_file));
  if (!colors || (request.preview.empty() && request.display.empty() && request.view.empty())) {
    return colors;
  }
  const auto view = colors.value().display_transform(request.display, request.view);
  if (!view) return view.error();
  return colors;
}

// An object for a picture, a list of them for frames, however many were asked for or are finished.
// Of a single picture that was not rendered there is nothing to say.
ExitCode write_statistics(const RenderRequest& request, const std::vector<PictureReport>& reports) {
  const bool is_single = request.frames.empty();
  if (request.statistics.empty() || (is_single && reports.empty())) return ExitCode::done;
  const std::string json = is_single ? statistics_json(reports.front()) : statistics_json(reports);
  if (request.statistics == "-") return print(json);
  const FileWriting writing;
  const Status written = write_file_atomic(request.statistics, json);
  return written ? ExitCode::done : report(written.error());
}

}  // namespace

ExitCode run_render(const Arguments& arguments) {
  RenderRequest request;
  if (const auto code = read_render_options(arguments, request)) return *code;
  catch_interrupts();
  const auto colors = open_colors(request);
  if (!colors) return report(colors.error());
  std::vector<PictureReport> reports;
  ExitCode rendered = ExitCode::done;
  for (const PictureJob& job : picture_jobs(request)) {
    const std::size_t written_before = reports.size();
    const ExitCode code = render_picture(request, job, colors.value(), reports);
    if (code == ExitCode::done) continue;
    rendered = code;
    // A picture that fell short of its accuracy is one, and the next may not.
    if (reports.size() == written_before) break;
  }
  // What was refused before anything was rendered writes nothing.
  if (rendered != ExitCode::done && reports.empty()) return rendered;
  const ExitCode written = write_statistics(request, reports);
  return rendered != ExitCode::done ? rendered : written;
}

}  // namespace alhazen

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
  return has_frame_place(pattern) ? frame_name(pattern, frame).value() : pattern;
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

ExitCode write_statistics(const std::string& path, const std::vector<PictureReport>& reports) {
  if (path.empty()) return ExitCode::done;
  const std::string json = statistics_json(reports);
  if (path == "-") return print(json);
  const FileWriting writing;
  const Status written = write_file_atomic(path, json);
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
  for (const PictureJob& job : picture_jobs(request)) {
    const ExitCode code = render_picture(request, job, colors.value(), reports);
    if (code != ExitCode::done) return code;
  }
  return write_statistics(request.statistics, reports);
}

}  // namespace alhazen

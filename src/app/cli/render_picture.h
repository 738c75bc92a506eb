// app/cli: one picture from the scene's text to the files, step by step.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/exit_code.h"
#include "app/cli/progress.h"
#include "app/cli/render_request.h"
#include "app/cli/statistics.h"
#include "render/color/color_config.h"

namespace alhazen {

// One of the pictures that a request asks for.
struct PictureJob {
  std::optional<int> frame;  // given to the scene's `param frame`
  FramePosition position;
  std::string output, preview;  // names with the frame number in its place
};

// Renders and writes one picture; complaints go to stderr. Adds a report if the picture was
// written, also when it is not as accurate as was asked for, which its code says.
ExitCode render_picture(const RenderRequest& request, const PictureJob& job,
                        const render::ColorConfig& colors, std::vector<PictureReport>& reports);

}  // namespace alhazen

// app/cli: render's command line.
#pragma once

#include "app/cli/render_request.h"
#include "app/cli/verb.h"

namespace alhazen {

// Reads the words into `request`. A code means that the verb is over.
std::optional<ExitCode> read_render_options(const Arguments& arguments, RenderRequest& request);

}  // namespace alhazen

// app/cli: what came of --max-error, for people, for programs and for the picture's header.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/cli/exit_code.h"
#include "render/wave/render.h"

namespace alhazen {

// Lines of the summary, each with its line break.
std::string accuracy_text(const render::AccuracyReport& report);
// One sentence for who asked for more than there is; empty when the target was reached.
std::string shortfall_text(const render::AccuracyReport& report);
nlohmann::ordered_json accuracy_json(const render::AccuracyReport& report);

// `stopped` where more time would do, `limit` where it would not.
ExitCode exit_code(const render::AccuracyReport& report);

}  // namespace alhazen

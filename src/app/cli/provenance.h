// app/cli: what made a picture: enough to tell whether making it again would change it.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/render_request.h"
#include "core/scene/scene.h"
#include "render/color/color_config.h"

namespace alhazen {

// Attribute names and values: version, sceneHash, imagesHash, colorHash, precision, options, and
// preview where there is one: a run without a preview may take up what one with a preview made; and
// target, which says that max_error was reached. Two
// runs with equal provenance give equal pixels; whatever cannot change a pixel (threads, file
// names, progress) is left out.
using Provenance = std::vector<std::pair<std::string, std::string>>;

// `scene` with the command line's settings in it; `defines` with that of the frame.
Provenance provenance(const RenderRequest& request, const std::vector<parser::Define>& defines,
                      const Scene& scene, std::uint64_t images_hash,
                      const render::ColorConfig& colors);

// For the header of the picture: what came of max_error, in place of what was hoped for.
void tell_accuracy(const render::AccuracyReport& report, Provenance& provenance);

// Whether `path` holds a picture that can be read to its last pixel and was made by the same.
bool is_made_by(const std::string& path, const Provenance& provenance);

}  // namespace alhazen

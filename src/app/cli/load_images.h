// app/cli: the picture files that a scene uses, in the working space.
#pragma once

#include <cstdint>
#include <vector>

#include "core/diag/diagnostic.h"
#include "core/scene/scene.h"
#include "render/color/color_config.h"
#include "render/wave/render.h"

namespace alhazen {

struct LoadedImages {
  std::vector<render::ImagePixels> pixels;  // parallel to Scene::images
  std::uint64_t hash = 0;                   // of the bytes of all files and their colour spaces
};

// Every file that cannot be used is reported at the place in the scene that names it; the result
// is of use only if none was.
LoadedImages load_images(const Scene& scene, const render::ColorConfig& colors,
                         DiagnosticSink& sink);

}  // namespace alhazen

// app/povray: a scene as POV-Ray 3.7 text that gives the same picture, as far as POV-Ray can.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/povray/deviation.h"
#include "core/base/result.h"
#include "core/scene/scene.h"
#include "render/wave/render.h"

namespace alhazen {

// A file that the text reads, to be written beside it.
struct PovFile {
  std::string name;  // relative to the folder of the text
  std::string bytes;
};

// The first line of every exported text, by which it is known from one that was written by hand.
inline constexpr std::string_view kPovHeading = "An Alhazen scene for POV-Ray 3.7.";

struct PovExport {
  std::string text;
  std::vector<Deviation> deviations;  // in the order of the text; each kind once for each line
  std::vector<PovFile> files;         // pictures, as EXR in the working space
};

// `images` parallels Scene::images, linear in the working space: colours are exported as the
// numbers that the renderer uses, and POV-Ray's EXR holds the same kind of numbers. `stem` begins
// the names of files, with %5C and the like for what POV-Ray takes in no name. Fails when a picture
// cannot be encoded.
Result<PovExport> export_pov(const Scene& scene, const SourceManager& sources,
                             const std::vector<render::ImagePixels>& images,
                             const std::string& stem);

// The names that PovExport::files may have.
std::vector<std::string> pov_file_names(const Scene& scene, std::string_view stem);

}  // namespace alhazen

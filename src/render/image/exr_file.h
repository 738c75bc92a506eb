// render/image: what a written EXR file says, without OpenEXR's types.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/math/chromaticities.h"
#include "core/math/transform.h"
#include "render/image/cryptomatte.h"
#include "render/image/pixel_buffer.h"

namespace alhazen::render {

enum class SampleType { half, float32, uint32 };

// The depth of a pixel that no ray hit. Infinity is what geometry says, but viewers that scale the
// picture by its largest value and filters that multiply by zero make NaN of it.
constexpr float kBackgroundDepth = 1e30F;

// Names of the renderer's own attributes begin with this.
constexpr const char* kAttributePrefix = "alhazen/";

// Every field is optional, and nothing is filled in from the clock or the host: the same scene and
// settings give the same bytes.
struct ExrMetadata {
  std::optional<Chromaticities> chromaticities;  // also gives adoptedNeutral: its white
  // Camera frame: left-handed, x right, y up, +z the viewing direction, as EXR defines it.
  std::optional<Affined> camera_from_world;
  // Homogeneous; for a point p of the picture M p = w (x, y, ., 1), with (0, 0) the upper left and
  // (1, 1) the lower right corner of the display window.
  std::optional<std::array<std::array<double, 4>, 4>> ndc_from_world;
  std::string software;  // for instance "Alhazen 0.1.0"
  std::string owner;
  std::string comments;
  std::string cap_date;  // local time, YYYY:MM:DD hh:mm:ss
  std::optional<float> utc_offset_seconds;
  // Written as strings under kAttributePrefix + name: sceneHash, options, version, ...
  std::vector<std::pair<std::string, std::string>> provenance;
};

// A picture of one or two parts. `rgba`: the beauty, ZIP. `data`: depth, normals, Cryptomatte, ...,
// always 32-bit float and lossless (ZIPS); there only if it has a channel.
struct ExrFile {
  PixelWindow display_window;  // the whole frame
  PixelWindow data_window;     // the pixels there are; every buffer below has its size
  FloatBuffer beauty;          // R, G, B and perhaps A (premultiplied), scene-linear
  SampleType beauty_type = SampleType::half;
  FloatBuffer data;  // Z, N.X, N.Y, N.Z, ...; empty when there is none
  std::vector<CryptomatteLayer> cryptomattes;
  ExrMetadata metadata;
};

}  // namespace alhazen::render

// core/scene: textures: a colour for each point of a surface.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/diag/source.h"
#include "core/math/transform.h"

namespace alhazen {

using TextureId = std::uint32_t;
using ImageId = std::uint32_t;

// Where the pattern's coordinates come from, before `pattern_from_mapped`.
enum class Mapping {
  object,  // the point in the shape's object frame, before the shape's own transforms
  world,   // the point in the world
  uv,      // (u, v, 0) of the shape's own parametrisation
};

struct SolidPattern {
  Rgbd color;
};
// Unit cubes: even(floor x + floor y + floor z) shows `even`, else `odd`. Both are textures.
struct CheckerPattern {
  TextureId even, odd;
};
// Slabs of unit width across x.
struct StripesPattern {
  TextureId even, odd;
};
// POV-Ray's bricks: `size` is the period, joints of `mortar_width` at its upper end included.
// Courses are stacked along y; every second one is shifted by half a brick along x, the others
// along z.
struct BrickPattern {
  TextureId brick, mortar;
  Vec3d size{8, 3, 4.5};
  double mortar_width = 0.5;
};
// Linear between stops along x; constant beyond the first and the last. Positions do not decrease.
struct GradientStop {
  double position;
  Rgbd color;
};
struct GradientPattern {
  std::vector<GradientStop> stops;  // at least one
};
inline bool is_one_color(const std::vector<GradientStop>& stops) {
  return std::all_of(stops.begin(), stops.end(),
                     [&](const GradientStop& stop) { return stop.color == stops.front().color; });
}
enum class ImageWrap { repeat, clamp, mirror };
enum class ImageFilter { bilinear, nearest };
// The image fills [0,1]^2 of (x, y), its first row at y = 1.
struct ImagePattern {
  ImageId image;
  ImageWrap wrap = ImageWrap::repeat;
  ImageFilter filter = ImageFilter::bilinear;
};

using Pattern = std::variant<SolidPattern, CheckerPattern, StripesPattern, BrickPattern,
                             GradientPattern, ImagePattern>;

struct Texture {
  Pattern pattern;
  Mapping mapping = Mapping::object;
  Affined pattern_from_mapped;
  SourceSpan span;
};

// A picture file that textures or the background use. Read by the renderer, once.
struct ImageFile {
  std::string path;         // as resolved when the scene was evaluated
  std::string color_space;  // of the colour configuration; empty: chosen by its file rules
  SourceSpan span;
};

}  // namespace alhazen

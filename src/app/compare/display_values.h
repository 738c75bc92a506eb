// app/compare: pictures as a display shows them, which is what measures of visible error look at.
#pragma once

#include <array>
#include <optional>

#include "core/math/chromaticities.h"
#include "render/image/exr_read.h"
#include "render/image/pixel_buffer.h"

namespace alhazen {

// The curve of sRGB, IEC 61966-2-1, from light to code and back, both in 0 .. 1.
double srgb_code(double light);
double srgb_light(double code);

// What the numbers of a picture are.
enum class PixelEncoding {
  light,  // linear in light: EXR
  srgb,   // codes of sRGB, 0 .. 1: PNG and JPEG
};

// The attribute `chromaticities` of the part, if there is one that can be used.
std::optional<Chromaticities> chromaticities_of(const render::ExrPart& part);

// From a space to linear Rec.709, whose primaries and white are those of sRGB.
ColorMatrix rec709_from(const Chromaticities& space);

struct DisplayLook {
  PixelEncoding encoding = PixelEncoding::light;
  ColorMatrix rec709;     // from the picture's space, of light
  double exposure = 0.0;  // in stops: light is multiplied by 2^exposure
};

// Channels R, G, B: linear light of Rec.709 primaries, where 1 is the display's white. A NaN is
// black and an infinity as much light as a float holds. `channels` are the indices of red, green
// and blue.
render::FloatBuffer rec709_light(const render::FloatBuffer& picture,
                                 const std::array<std::size_t, 3>& channels,
                                 const DisplayLook& look);

// rec709_light clamped to 0 .. 1: what a display shows of it.
render::FloatBuffer display_light(const render::FloatBuffer& picture,
                                  const std::array<std::size_t, 3>& channels,
                                  const DisplayLook& look);

}  // namespace alhazen

// app/compare: pictures as the page shows them, through the same display views as previews.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/compare/compare.h"
#include "core/base/result.h"
#include "render/color/color_config.h"

namespace alhazen {

class PageView {
 public:
  // Empty names are the configuration's defaults. Fails as ColorConfig does.
  static Result<PageView> make(const render::ColorConfig& colors, std::string_view display,
                               std::string_view view);

  // Interleaved RGB of three channels. Light goes from its space to the working space and through
  // the view, codes are shown as they are; both after the exposure of `look`.
  std::vector<std::uint8_t> shown(const render::FloatBuffer& pixels,
                                  const std::array<std::size_t, 3>& channels,
                                  const DisplayLook& look) const;

 private:
  PageView(render::ColorTransform working_from_rec709, render::ColorTransform view)
      : working_from_rec709_(std::move(working_from_rec709)), view_(std::move(view)) {}

  render::ColorTransform working_from_rec709_, view_;
};

// |A - B| of three channels times `gain`, clamped to 0 .. 1 and shown with the curve of sRGB
// (`encoding` light) or as it is (codes).
std::vector<std::uint8_t> shown_difference(const PartPair& parts,
                                           const std::array<ChannelPair, 3>& channels, double gain,
                                           PixelEncoding encoding);

// The power of two that takes the 99th percentile of the pixels' largest differences, of those that
// differ, to between 1/4 and 1/2: a few outliers do not hide the rest. 1 when nothing differs.
double difference_gain(const PartPair& parts, const std::array<ChannelPair, 3>& channels);

}  // namespace alhazen

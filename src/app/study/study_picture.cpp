#include "app/study/study_picture.h"

#include <algorithm>
#include <cmath>

#include "app/compare/color_ramp.h"
#include "render/color/preview.h"

namespace alhazen {
namespace {

RgbPicture cut(const RgbPicture& picture, const ThumbnailWindow& window) {
  RgbPicture out{window.width, window.height, {}};
  out.rgb.reserve(3 * static_cast<std::size_t>(window.width) *
                  static_cast<std::size_t>(window.height));
  for (int y = window.y; y < window.y + window.height; ++y) {
    const auto row = picture.rgb.begin() + 3 * (std::ptrdiff_t{y} * picture.width + window.x);
    out.rgb.insert(out.rgb.end(), row, row + 3 * window.width);
  }
  return out;
}

// Entry (x, y) is the sum of what is above and to the left of it: windows in four look-ups.
std::vector<double> integral_of(const std::vector<float>& map, int width, int height) {
  const auto stride = static_cast<std::size_t>(width) + 1;
  std::vector<double> sums(stride * (static_cast<std::size_t>(height) + 1));
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
    double row = 0;
    for (std::size_t x = 0; x + 1 < stride; ++x) {
      row += map[y * (stride - 1) + x];
      sums[(y + 1) * stride + x + 1] = sums[y * stride + x + 1] + row;
    }
  }
  return sums;
}

float ramp_value(float error) {
  constexpr double kRange = 8;  // log2 of brightest / darkest
  const double above =
      std::log2(std::max(static_cast<double>(error), kDarkestError) / kDarkestError);
  return static_cast<float>(std::min(1.0, above / kRange));
}
static_assert(kBrightestError / kDarkestError == 256);

}  // namespace

ThumbnailWindow thumbnail_window(const RgbPicture& a, const RgbPicture& b) {
  ThumbnailWindow best{0, 0, std::min(a.width, kThumbnailSide), std::min(a.height, kThumbnailSide)};
  const std::vector<double> sums = integral_of(error_map(a, b), a.width, a.height);
  const auto at = [&](int x, int y) {
    return sums[static_cast<std::size_t>(y) * (static_cast<std::size_t>(a.width) + 1) +
                static_cast<std::size_t>(x)];
  };
  double most = -1;
  for (int y = 0; y + best.height <= a.height; ++y) {
    for (int x = 0; x + best.width <= a.width; ++x) {
      const int right = x + best.width, bottom = y + best.height;
      const double sum = at(right, bottom) - at(x, bottom) - at(right, y) + at(x, y);
      if (sum <= most) continue;
      most = sum;
      best.x = x;
      best.y = y;
    }
  }
  return best;
}

StudyPictures study_pictures(const RgbPicture& picture, const RgbPicture& reference,
                             const ThumbnailWindow& window, const render::ColorTransform& view) {
  const RgbPicture part = cut(picture, window);
  const render::FloatBuffer light = float_buffer(part);
  std::vector<float> errors = error_map(part, cut(reference, window));
  std::ranges::transform(errors, errors.begin(), ramp_value);
  return {window.width, window.height,
          render::preview_rgb8(view, light.channel(0), light.channel(1), light.channel(2)),
          ramp_picture(errors, 1)};
}

}  // namespace alhazen

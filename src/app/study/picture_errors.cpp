#include "app/study/picture_errors.h"

#include <algorithm>
#include <cmath>

#include "app/compare/figures.h"
#include "app/compare/flip.h"

namespace alhazen {

RgbPicture rgb_of(const render::Picture& picture) {
  return {picture.window.width, picture.window.height, picture.rgb};
}

render::FloatBuffer float_buffer(const RgbPicture& picture) {
  render::FloatBuffer buffer(picture.width, picture.height, {"R", "G", "B"});
  for (std::size_t c = 0; c < 3; ++c) {
    const auto plane = buffer.channel(c);
    for (std::size_t i = 0; i < plane.size(); ++i)
      plane[i] = static_cast<float>(picture.rgb[3 * i + c]);
  }
  return buffer;
}

double PictureErrors::share_over() const {
  return pixels == 0 ? 0 : static_cast<double>(pixels_over) / static_cast<double>(pixels);
}

PictureErrors errors_of(const RgbPicture& a, const RgbPicture& reference, const DisplayLook& look) {
  PictureErrors errors;
  errors.pixels = a.pixel_count();
  double squares = 0, relative_squares = 0;
  std::uint64_t compared = 0;
  for (std::size_t pixel = 0; pixel < errors.pixels; ++pixel) {
    bool over = false;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
      const double b = reference.rgb[i], error = std::fabs(a.rgb[i] - b);
      if (!std::isfinite(error)) {
        ++errors.not_finite;
        over = true;
        continue;
      }
      squares += error * error;
      relative_squares += error * error / (b * b + kRelativeEpsilon);
      errors.largest = std::max(errors.largest, error);
      over = over || error > kVisibleStep;
      ++compared;
    }
    errors.pixels_over += over ? 1 : 0;
  }
  if (compared > 0) {
    errors.rmse = std::sqrt(squares / static_cast<double>(compared));
    errors.relative_mse = relative_squares / static_cast<double>(compared);
  }
  errors.flip = flip(display_light(float_buffer(a), {0, 1, 2}, look),
                     display_light(float_buffer(reference), {0, 1, 2}, look))
                    .mean;
  return errors;
}

double rmse_of(const RgbPicture& a, const RgbPicture& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    const double error = a.rgb[i] - b.rgb[i];
    if (std::isfinite(error)) squares += error * error;
  }
  return a.rgb.empty() ? 0 : std::sqrt(squares / static_cast<double>(a.rgb.size()));
}

std::vector<float> error_map(const RgbPicture& a, const RgbPicture& reference) {
  std::vector<float> map(a.pixel_count());
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    const double error = std::fabs(a.rgb[i] - reference.rgb[i]);
    if (std::isfinite(error)) map[i / 3] = std::max(map[i / 3], static_cast<float>(error));
  }
  return map;
}

}  // namespace alhazen

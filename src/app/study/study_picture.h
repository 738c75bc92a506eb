// app/study: the two small pictures that stand for a point: what was rendered, and where it errs.
#pragma once

#include <cstdint>
#include <vector>

#include "app/study/picture_errors.h"
#include "render/color/color_transform.h"

namespace alhazen {

// Small enough that a page of fifty points stays below a megabyte.
inline constexpr int kThumbnailSide = 84;

struct StudyPictures {
  int width = 0, height = 0;
  std::vector<std::uint8_t> shown, error;  // interleaved sRGB
};

// A rectangle of the picture, pixel for pixel.
struct ThumbnailWindow {
  int x = 0, y = 0, width = 0, height = 0;
};

// The whole of a small picture; of a larger one the window that differs most, in sum, between `a`
// and `b`: noise and steps are seen in pixels, and go away when a picture is made smaller.
ThumbnailWindow thumbnail_window(const RgbPicture& a, const RgbPicture& b);

// Errors are shown on a scale of logarithms, from black at 1/1024 to pale yellow at 1/4.
inline constexpr double kDarkestError = 1.0 / 1024, kBrightestError = 1.0 / 4;

StudyPictures study_pictures(const RgbPicture& picture, const RgbPicture& reference,
                             const ThumbnailWindow& window, const render::ColorTransform& view);

}  // namespace alhazen

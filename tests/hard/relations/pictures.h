// tests/hard/relations: pictures of scenes, and how two of them differ.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>

#include "hard/figure.h"
#include "render/wave/render.h"

namespace alhazen::hard {

using render::Picture;
using render::Precision;

inline Picture picture_of(const Scene& scene, render::RenderOptions options = {}) {
  Result<render::RenderOutput> output = render::render(scene, {}, options);
  EXPECT_TRUE(output) << (output ? "" : output.error().message);
  return output ? std::move(output).value().picture : Picture{};
}

inline Picture decisions_of(const Scene& scene, Precision precision = Precision::float64) {
  return picture_of(scene, {.precision = precision, .aovs = {.signature = true, .margin = true}});
}

// Numbers that are not the same bits: a NaN equals itself, -0 is not 0.
inline double different_bits(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return HUGE_VAL;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    count += std::memcmp(&a[i], &b[i], sizeof(double)) != 0;
  return static_cast<double>(count);
}

// The largest difference; NaN if there is one.
inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return HUGE_VAL;
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = std::abs(a[i] - b[i]);
    if (std::isnan(d)) return d;
    worst = std::max(worst, d);
  }
  return worst;
}

// Left and right exchanged.
inline std::vector<double> flipped(const Picture& picture) {
  std::vector<double> result(picture.rgb.size());
  const std::size_t width = static_cast<std::size_t>(picture.window.width);
  for (std::size_t i = 0; i < result.size() / 3; ++i) {
    const std::size_t there = i / width * width + (width - 1 - i % width);
    std::copy_n(&picture.rgb[3 * i], 3, &result[3 * there]);
  }
  return result;
}

// What a picture in another precision, or of the scene in another place, has in common with the
// certified one: only pixels count whose margin there is above `certain`.
struct Certified {
  double pixels = 0, flips = 0, largest_error = 0;
};
inline Certified compare_certified(const Picture& certified, const Picture& other, double certain) {
  Certified result;
  for (std::size_t p = 0; p < certified.margin.size(); ++p) {
    if (!(static_cast<double>(certified.margin[p]) > certain)) continue;
    ++result.pixels;
    result.flips += certified.signature[p] != other.signature[p] ? 1 : 0;
    for (std::size_t c = 3 * p; c < 3 * p + 3; ++c) {
      result.largest_error =
          std::max(result.largest_error, std::abs(certified.rgb[c] - other.rgb[c]));
    }
  }
  return result;
}

}  // namespace alhazen::hard

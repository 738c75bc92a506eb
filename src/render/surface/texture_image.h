// render/surface: colours of a picture at a point of its unit square.
#pragma once

#include <array>
#include <cstddef>

#include "core/math/vec.h"
#include "core/scene/texture.h"
#include "render/simd/lanes.h"

namespace alhazen::render {

// Three floats a pixel in the scene-linear working space, rows from the top. Not owned.
struct ImageView {
  const float* rgb = nullptr;
  int width = 0, height = 0;
};

// Precondition: 0 <= column < width, 0 <= row < height, in every lane. Lanes are read one by one:
// a picture may have more floats than an index of lanes of float can count.
template <class Real>
inline Rgb<Real> image_pixel(const ImageView& image, IntOf<Real> column, IntOf<Real> row) {
  const auto floats_at = [&image](auto x, auto y) {
    return image.rgb + (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                        static_cast<std::size_t>(x)) *
                           3;
  };
  if constexpr (std::same_as<Real, ScalarOf<Real>>) {
    const float* pixel = floats_at(column, row);
    return {static_cast<Real>(pixel[0]), static_cast<Real>(pixel[1]), static_cast<Real>(pixel[2])};
  } else {
    using Scalar = ScalarOf<Real>;
    std::array<std::array<Scalar, Real::kWidth>, 3> channels;
    for (int i = 0; i < Real::kWidth; ++i) {
      const float* pixel = floats_at(column[i], row[i]);
      for (std::size_t c = 0; c < 3; ++c)
        channels[c][static_cast<std::size_t>(i)] = static_cast<Scalar>(pixel[c]);
    }
    return {Real::load(channels[0].data()), Real::load(channels[1].data()),
            Real::load(channels[2].data())};
  }
}

// A coordinate folded into [0, 1]; NaN and infinities go to 0 or 1.
template <class Real>
inline Real folded(Real x, ImageWrap wrap) {
  if (wrap == ImageWrap::repeat) x = x - round_down(x);
  if (wrap == ImageWrap::mirror) {
    x = x - 2 * round_down(x / 2);
    x = select(x > Real(1), 2 - x, x);
  }
  return select(x > Real(0), smaller(x, Real(1)), Real(0));
}

// The pixel index of a neighbour at -1 or `count`: across the seam, or the border pixel again
// (which is also what a mirrored picture shows there).
template <class Int>
inline Int neighbour(Int index, int count, ImageWrap wrap) {
  const bool repeats = wrap == ImageWrap::repeat;
  const Int before = repeats ? count - 1 : 0, beyond = repeats ? 0 : count - 1;
  return select(index < Int(0), before, select(index >= Int(count), beyond, index));
}

// Two pixels along one axis and the weight of the second. Pixel i has its centre at (i +
// 1/2)/count.
template <class Real>
struct PixelPair {
  IntOf<Real> first = 0, second = 0;
  Real weight = 0;
};
template <class Real>
inline PixelPair<Real> pixel_pair(Real unit, int count, ImageWrap wrap) {
  const Real position = unit * static_cast<Real>(count) - Real(0.5);
  const Real below = round_down(position);
  const auto first = static_cast<IntOf<Real>>(below);
  return {neighbour(first, count, wrap), neighbour(first + IntOf<Real>(1), count, wrap),
          position - below};
}

template <class Real>
inline Rgb<Real> bilinear(const ImageView& image, const PixelPair<Real>& columns,
                          const PixelPair<Real>& rows) {
  const auto row_color = [&](IntOf<Real> row) {
    return (1 - columns.weight) * image_pixel<Real>(image, columns.first, row) +
           columns.weight * image_pixel<Real>(image, columns.second, row);
  };
  return (1 - rows.weight) * row_color(rows.first) + rows.weight * row_color(rows.second);
}

// Colour at (x, y) with the picture on [0,1]^2, its first row at y = 1. Bilinear between pixel
// centres, or of the pixel that holds the point.
template <class Real>
inline Rgb<Real> image_color(const ImageView& image, Real x, Real y, ImageWrap wrap,
                             ImageFilter filter) {
  const Real across = folded(x, wrap), down = 1 - folded(y, wrap);
  if (filter == ImageFilter::nearest) {
    const auto column = static_cast<IntOf<Real>>(across * static_cast<Real>(image.width));
    const auto row = static_cast<IntOf<Real>>(down * static_cast<Real>(image.height));
    return image_pixel<Real>(image, neighbour(column, image.width, wrap),
                             neighbour(row, image.height, wrap));
  }
  return bilinear(image, pixel_pair(across, image.width, wrap),
                  pixel_pair(down, image.height, wrap));
}

}  // namespace alhazen::render

// render/surface: colours of a picture at a point of its unit square.
#pragma once

#include <cstddef>

#include "core/math/scalar.h"
#include "core/math/vec.h"
#include "core/scene/texture.h"

namespace alhazen::render {

// Three floats a pixel in the scene-linear working space, rows from the top. Not owned.
struct ImageView {
  const float* rgb = nullptr;
  int width = 0, height = 0;
};

// Precondition: 0 <= column < width, 0 <= row < height.
template <class Real>
inline Rgb<Real> image_pixel(const ImageView& image, int column, int row) {
  const std::size_t index = (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                             static_cast<std::size_t>(column)) *
                            3;
  return {static_cast<Real>(image.rgb[index]), static_cast<Real>(image.rgb[index + 1]),
          static_cast<Real>(image.rgb[index + 2])};
}

// A coordinate folded into [0, 1]; NaN and infinities go to 0 or 1.
template <class Real>
inline Real folded(Real x, ImageWrap wrap) {
  if (wrap == ImageWrap::repeat) x = x - round_down(x);
  if (wrap == ImageWrap::mirror) {
    x = x - 2 * round_down(x / 2);
    if (x > 1) x = 2 - x;
  }
  return x > 0 ? smaller(x, Real(1)) : Real(0);
}

// The pixel index of a neighbour at -1 or `count`: across the seam, or the border pixel again
// (which is also what a mirrored picture shows there).
inline int neighbour(int index, int count, ImageWrap wrap) {
  if (index < 0) return wrap == ImageWrap::repeat ? count - 1 : 0;
  if (index >= count) return wrap == ImageWrap::repeat ? 0 : count - 1;
  return index;
}

// Two pixels along one axis and the weight of the second. Pixel i has its centre at (i +
// 1/2)/count.
template <class Real>
struct PixelPair {
  int first = 0, second = 0;
  Real weight = 0;
};
template <class Real>
inline PixelPair<Real> pixel_pair(Real unit, int count, ImageWrap wrap) {
  const Real position = unit * static_cast<Real>(count) - Real(0.5);
  const Real below = round_down(position);
  const int first = static_cast<int>(below);
  return {neighbour(first, count, wrap), neighbour(first + 1, count, wrap), position - below};
}

template <class Real>
inline Rgb<Real> bilinear(const ImageView& image, const PixelPair<Real>& columns,
                          const PixelPair<Real>& rows) {
  const auto row_color = [&](int row) {
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
    const int column = static_cast<int>(across * static_cast<Real>(image.width));
    const int row = static_cast<int>(down * static_cast<Real>(image.height));
    return image_pixel<Real>(image, neighbour(column, image.width, wrap),
                             neighbour(row, image.height, wrap));
  }
  return bilinear(image, pixel_pair(across, image.width, wrap),
                  pixel_pair(down, image.height, wrap));
}

}  // namespace alhazen::render

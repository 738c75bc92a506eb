// tests/hard/pictures: from a scene to its pixels in each scalar type, and how far two pictures are
// from each other.
#pragma once

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "hard/figure.h"
#include "render/wave/render.h"
#include "support/scene_builder.h"

namespace alhazen::hard {

using render::Precision;
using testing::SceneBuilder;

inline constexpr Precision kScalars[] = {Precision::float64, Precision::float32};

inline const char* name_of(Precision p) {
  return p == Precision::float64 ? "double" : p == Precision::float32 ? "float" : "quad";
}
// Unit roundoff.
inline double eps_of(Precision p) {
  return p == Precision::float64 ? 0x1p-53 : 0x1p-24;
}
// The sizes of scenes to go through. Squares of lengths and their products with squares of
// directions have to stay in range, which is 2^+-1022 in double and 2^+-126 in float.
inline std::vector<double> sizes(Precision p) {
  if (p == Precision::float32) return {0x1p-40, 0x1p-10, 1, 0x1p10, 0x1p40};
  return {0x1p-300, 0x1p-100, 0x1p-10, 1, 0x1p10, 0x1p100, 0x1p300};
}

inline render::RenderOutput rendered(const Scene& scene, const render::RenderOptions& options) {
  Result<render::RenderOutput> output = render::render(scene, {}, options);
  EXPECT_TRUE(output) << (output ? "" : output.error().message);
  return output ? std::move(output).value() : render::RenderOutput{};
}
inline std::vector<double> pixels(const Scene& scene, Precision p) {
  render::RenderOptions options;
  options.precision = p;
  return rendered(scene, options).picture.rgb;
}

// Square pictures.
inline void set_size(SceneBuilder& b, int side) {
  b.scene.settings.width = b.scene.settings.height = side;
}
// A side that gives a picture `rays(side * side)` pixels.
inline int side_for(int side) {
  return static_cast<int>(std::sqrt(static_cast<double>(rays(std::size_t(side) * side))));
}

// Red of the only pixel of a scene that looks along the unit vector `forward` from `position`.
inline double seen(SceneBuilder& b, Vec3d position, Vec3d forward, Vec3d up, Precision p) {
  set_size(b, 1);
  b.look(position, forward, up, 1e-3);
  return pixels(b.scene, p)[0];
}

// The largest difference of two pictures; NaN if one has any.
inline double worst_difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double worst = 0;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
    const double difference = std::abs(a[i] - b[i]);
    if (!(difference <= worst)) worst = difference;
  }
  return worst;
}
// Pixels of which a channel differs by more than `limit`, or is NaN.
inline int bad_pixels(const std::vector<double>& a, const std::vector<double>& b,
                      double limit = 1.0 / 255) {
  EXPECT_EQ(a.size(), b.size());
  int bad = 0;
  for (std::size_t i = 0; i + 2 < a.size() && i + 2 < b.size(); i += 3) {
    bool good = true;
    for (std::size_t c = 0; c < 3; ++c)
      good = good && std::abs(a[i + c] - b[i + c]) <= limit;
    bad += !good;
  }
  return bad;
}

}  // namespace alhazen::hard

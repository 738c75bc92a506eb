// tests/unit/render/wave: one call from a scene to its pixels.
#pragma once

#include <gtest/gtest.h>

#include "render/wave/render.h"
#include "support/scene_builder.h"

namespace alhazen::render {

inline RenderOutput render_or_fail(const Scene& scene, const RenderOptions& options = {}) {
  Result<RenderOutput> output = alhazen::render::render(scene, {}, options);
  EXPECT_TRUE(output) << (output ? "" : output.error().message);
  return output ? std::move(output).value() : RenderOutput{};
}

inline std::vector<double> pixels_of(const Scene& scene, const RenderOptions& options = {}) {
  return render_or_fail(scene, options).picture.rgb;
}

inline Rgbd pixel_at(const Picture& picture, int x, int y) {
  const std::size_t p = 3 * (static_cast<std::size_t>(y - picture.window.y) *
                                 static_cast<std::size_t>(picture.window.width) +
                             static_cast<std::size_t>(x - picture.window.x));
  return {picture.rgb[p], picture.rgb[p + 1], picture.rgb[p + 2]};
}

// Red of the only pixel of a scene that looks along +z from `position` through a tiny angle.
inline double central_radiance(testing::SceneBuilder& builder, Vec3d position) {
  builder.scene.settings.width = builder.scene.settings.height = 1;
  builder.look(position, {0, 0, 1}, {0, 1, 0}, 1e-3);
  return pixels_of(builder.scene)[0];
}

}  // namespace alhazen::render

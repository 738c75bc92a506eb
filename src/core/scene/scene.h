// core/scene: what a scene text means, as plain data: the one thing that the parser and the
// renderer both know. Every record says which text made it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/scene/camera.h"
#include "core/scene/light.h"
#include "core/scene/material.h"
#include "core/scene/scene_shapes.h"
#include "core/scene/settings.h"
#include "core/scene/texture.h"

namespace alhazen {

struct Scene {
  Camera camera;
  Background background;
  RenderSettings settings;
  std::vector<Texture> textures;    // a texture refers to earlier ones only
  std::vector<Material> materials;  // no two are equal in all but name and span
  std::vector<ImageFile> images;
  std::vector<Light> lights;
  SceneShapes shapes;
  std::uint64_t hash = 0;  // of all texts and values that made it (core/base/hash.h)
};

// The scene as text, for `alhazen dump --scene` and for tests: stable, one record a line, numbers
// with all their digits.
std::string dump(const Scene& scene);

}  // namespace alhazen

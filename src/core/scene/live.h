// core/scene: what of a scene can make a difference to a pixel, record by record. The effects that
// a scene calls for follow from it (effect.h), and the renderer's tables keep nothing else, so that
// both are of one mind.
#pragma once

#include <optional>
#include <vector>

#include "core/scene/scene.h"

namespace alhazen {

// Whether a light adds anything to any picture.
bool shines(const Light& light);

// Of the lights that shine.
struct ShiningLights {
  bool any = false;     // ambient light among them
  bool placed = false;  // with a direction that they come from
  bool shadowing =
      false;  // that cast shadows; POV-Ray's fill lights do not, and make no highlights
};
ShiningLights shining_lights(const Scene& scene);

// For each texture the colour that it has everywhere, or nothing. What a picture file holds is not
// looked at.
using SolidColors = std::vector<std::optional<Rgbd>>;
SolidColors solid_colors(const Scene& scene);
bool is_black(const SolidColors& solid, TextureId texture);

// What the materials of a scene have to do with each other.
struct Surroundings {
  SolidColors solid;
  ShiningLights lights;
  bool bends_light = false;  // some solid that a shape wears has an index other than that of vacuum
};
Surroundings surroundings_of(const Scene& scene);

// Highlights answer to lights that have a place; an even sky would only make a surface brighter.
bool shows_highlight(const Diffuse& diffuse, const Surroundings& around);
// Whether lights are seen on a diffuse surface of this colour.
bool shows_color(TextureId color, const Surroundings& around);
bool reflects(const Metal& metal, const Surroundings& around);
bool reflects(const PovFinish& finish, const Surroundings& around);
// Whether the matt part, or any part, of such a finish answers to lights.
bool shows_diffuse(const PovFinish& finish, const Surroundings& around);
bool answers_to_lights(const PovFinish& finish, const Surroundings& around);
// Whether its ambient or emission is seen.
bool glows(const PovFinish& finish, const SolidColors& solid);
// Whether some light passes such a surface.
bool lets_light_through(const PovFinish& finish, const SolidColors& solid);

}  // namespace alhazen

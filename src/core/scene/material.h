// core/scene: materials as plain data. Colours are in the scene-linear working space. For each
// material reflected + transmitted + absorbed = incident, channel by channel (docs/physics.md).
#pragma once

#include <string>
#include <variant>

#include "core/scene/texture.h"

namespace alhazen {

enum class HighlightModel { phong, blinn };

// A glossy lobe that answers to lights only, normalised so that it reflects at most `strength` of
// the incident light; albedo + strength <= 1.
struct Highlight {
  HighlightModel model = HighlightModel::blinn;
  Rgbd strength;
  double exponent = 40;  // >= 1
};

// Lambert: radiance albedo / pi * irradiance.
struct Diffuse {
  TextureId albedo;
  Highlight highlight;  // strength 0: none
};
struct Mirror {
  TextureId reflectance;  // at every angle
};
// Fresnel reflection of a conductor with complex index n + i k per channel.
struct Metal {
  Rgbd n, k;
};
// A smooth dielectric solid. Where solids overlap the one of higher priority is there; of equal
// priorities the one entered last.
struct Glass {
  double ior = 1.5;  // > 0, of the inside, relative to vacuum
  Rgbd absorption;   // per unit of length in the world: exp(-absorption * distance)
  int priority = 0;
};
// A clear dielectric layer over a diffuse base: Fresnel reflection on top, the base seen through it
// with all internal reflections summed (docs/physics.md).
struct Coat {
  double ior = 1.5;  // > 1
  Rgbd absorption;   // optical depth of the layer at normal incidence
  TextureId base_albedo;
};
// Reflects nothing.
struct Black {};

using Scattering = std::variant<Diffuse, Mirror, Metal, Glass, Coat, Black>;

struct Material {
  Scattering scattering;
  Rgbd emission;  // radiance, of both sides or of the one that the normal points to
  bool one_sided_emission = false;
  std::string name;
  SourceSpan span;
};

}  // namespace alhazen

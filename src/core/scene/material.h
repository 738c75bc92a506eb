// core/scene: materials as plain data. Colours are in the scene-linear working space. For each
// material but PovFinish reflected + transmitted + absorbed = incident, channel by channel
// (docs/physics.md).
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
// R = min + k (max - min): k = (1 - cos)^falloff of the view, or Fresnel's reflectance.
struct PovReflection {
  Rgbd min, max;
  double falloff = 1;
  bool fresnel = false;
  double metallic = 0;  // in [0, 1]: how much of the colour is in it
};
// POV-Ray 3.7's own surface model (docs/pov_ray.md). The one material that may give off more light
// than it receives.
struct PovFinish {
  TextureId color;
  double filter = 0, transmit = 0;  // let through with the colour and without; sum at most 1
  Rgbd ambient{0.1, 0.1, 0.1}, emission;
  double diffuse = 0.6, brilliance = 1;
  double phong = 0, phong_size = 40;
  double specular = 0, roughness = 0.05;
  double metallic = 0;  // of the highlights
  PovReflection reflection;
  bool conserve_energy = false;
  double ior = 1;
  double fade_distance = 0, fade_power = 0;  // light fades inside if neither is 0
  Rgbd fade_color;
};

using Scattering = std::variant<Diffuse, Mirror, Metal, Glass, Coat, Black, PovFinish>;

// What is neither let through by colour nor clear, and so answers to light as a surface.
constexpr double opacity(const PovFinish& m) {
  return 1 - (m.filter + m.transmit);
}
constexpr bool fades(const PovFinish& m) {
  return m.fade_distance != 0 && m.fade_power != 0;
}

struct Material {
  Scattering scattering;
  Rgbd emission;  // radiance, of both sides or of the one that the normal points to
  bool one_sided_emission = false;
  std::string name;
  SourceSpan span;
};

}  // namespace alhazen

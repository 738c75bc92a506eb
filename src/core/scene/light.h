// core/scene: lights as plain data, in the world frame.
#pragma once

#include <string>
#include <variant>

#include "core/diag/source.h"
#include "core/math/vec.h"
#include "core/scene/shape.h"

namespace alhazen {

enum class Falloff {
  inverse_square,  // irradiance = intensity * cos / distance^2
  none,            // irradiance = intensity * cos at any distance, as POV-Ray's default
};

struct PointLight {
  Vec3d position;
  Rgbd intensity;
  Falloff falloff = Falloff::inverse_square;
};
struct DirectionalLight {
  Vec3d direction;  // the way the light travels; unit length to rounding
  Rgbd irradiance;  // on a surface that faces it
};
// Full intensity within `inner_angle_deg` of the axis, none beyond `outer_angle_deg`, a smoothstep
// in the cosine between; 0 <= inner <= outer < 90... 180.
struct SpotLight {
  Vec3d position, axis;  // unit length to rounding
  Rgbd intensity;
  double inner_angle_deg = 30, outer_angle_deg = 45;
  Falloff falloff = Falloff::inverse_square;
};
struct SphereLight {
  Vec3d center;
  double radius = 1;
  Rgbd radiance;
  int samples = 4;  // shadow rays per shaded point
};
// Shines on the side of cross(edge_u, edge_v).
struct RectangleLight {
  Vec3d corner, edge_u, edge_v;
  Rgbd radiance;
  int samples = 4;
};
// The same radiance from everywhere, unshadowed: adds albedo * radiance.
struct AmbientLight {
  Rgbd radiance;
};

using LightSource = std::variant<PointLight, DirectionalLight, SpotLight, SphereLight,
                                 RectangleLight, AmbientLight>;

struct Light {
  LightSource source;
  bool casts_shadows = true;
  ShapeId visible_shape = kNoId;  // area lights that can be seen have a shape in the scene
  std::string name;
  SourceSpan span;
};

}  // namespace alhazen

// core/scene: cameras and what they see where nothing is.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "core/diag/source.h"
#include "core/math/vec.h"
#include "core/scene/texture.h"

namespace alhazen {

// Orthonormal to rounding, left-handed: right x, up y, forward z.
struct CameraFrame {
  Vec3d position{0, 0, 0};
  Vec3d right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, 1};
};

struct ThinLens {
  double aperture_radius = 0;
  double focus_distance = 1;  // along `forward` from the lens to the plane in focus
};
struct PerspectiveCamera {
  double fov_deg = 60;  // the full horizontal angle, as POV-Ray's `angle`; (0, 180)
  std::optional<ThinLens> lens;
};
struct OrthographicCamera {
  double width = 2;  // of the picture, in world lengths
};

struct Camera {
  CameraFrame frame;
  std::variant<PerspectiveCamera, OrthographicCamera> projection;
  SourceSpan span;
};

struct SolidBackground {
  Rgbd color;
};
// By the elevation of the direction: position -1 straight down, 0 the horizon, 1 straight up,
// linear in the sine of the elevation.
struct GradientBackground {
  std::vector<GradientStop> stops;
};
// A latitude-longitude picture: its centre column is seen in direction +z of the world turned by
// `rotation_deg` about y, its top row in direction +y; x to the right of z.
struct EnvironmentBackground {
  ImageId image;
  double rotation_deg = 0;
  double intensity = 1;
};

struct Background {
  std::variant<SolidBackground, GradientBackground, EnvironmentBackground> source;
  SourceSpan span;
};

}  // namespace alhazen

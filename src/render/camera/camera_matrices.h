// render/camera: the camera as the 4x4 matrices that EXR files carry.
#pragma once

#include <array>

#include "core/scene/camera.h"

namespace alhazen::render {

// For row vectors, as OpenEXR's: (x y z 1) M, so the translation is the last row.
using RowMatrix = std::array<std::array<double, 4>, 4>;

// EXR's camera space is left-handed with +z along the view, which is ours.
RowMatrix world_to_camera(const CameraFrame& frame);

// To (0, 0) at the top left and (1, 1) at the bottom right of the picture after division by w.
// Depth: (z - 1) / z for a perspective camera (0 at distance 1, 1 at infinity: the camera has no
// clipping planes to put there), the distance along the view for an orthographic one.
RowMatrix world_to_ndc(const Camera& camera, int width, int height);

}  // namespace alhazen::render

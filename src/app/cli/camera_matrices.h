// app/cli: the camera as the matrices that compositing programs read from an EXR file.
#pragma once

#include <array>

#include "core/scene/camera.h"
#include "core/scene/settings.h"

namespace alhazen {

// EXR's camera frame is the scene's: left-handed, x right, y up, z the viewing direction.
Affined camera_from_world(const CameraFrame& frame);

// Homogeneous: for a point p, M (p, 1) = w (x, y, ., 1), (0, 0) being the upper left and (1, 1) the
// lower right corner of the frame. Invertible; a lens does not matter.
std::array<std::array<double, 4>, 4> ndc_from_world(const Camera& camera,
                                                    const RenderSettings& settings);

}  // namespace alhazen

// app/povray: the (u, v) of each shape's surface in POV-Ray's terms, as the kernels of render/shape
// define them.
#pragma once

#include <optional>
#include <string>

#include "core/scene/shape.h"

namespace alhazen {

struct UvFrame {
  // Flat shapes: u and v are linear in the point, and the third coordinate is the distance from the
  // surface.
  std::optional<Affined> uv_from_object;
  // The others: u and v as POV-Ray functions of x, y, z in the object frame.
  std::string u, v;
  // Where POV-Ray wraps pictures as we do: "spherical" or "cylindrical", and the frame that it
  // wraps in.
  const char* warp = nullptr;
  Affined object_from_warped;
};

UvFrame uv_frame(const Geometry& geometry);

}  // namespace alhazen

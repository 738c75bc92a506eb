#include "core/scene/shape.h"

#include "core/base/overloaded.h"

namespace alhazen {

bool is_closed(const Geometry& geometry) {
  return std::visit(
      Overloaded{[](const Sphere&) { return true; }, [](const Plane&) { return true; },
                 [](const Box&) { return true; }, [](const Disc&) { return false; },
                 [](const Cylinder& c) { return c.capped; }, [](const Cone& c) { return c.capped; },
                 [](const Triangle&) { return false; }, [](const Quad4&) { return false; }},
      geometry);
}

const char* kind_name(const Geometry& geometry) {
  static constexpr const char* kNames[] = {"sphere",   "plane", "box",      "disc",
                                           "cylinder", "cone",  "triangle", "quad"};
  return kNames[geometry.index()];
}

}  // namespace alhazen

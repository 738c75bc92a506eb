// app/nff: from NffScene to the text of a scene.
#pragma once

#include <string>
#include <string_view>

#include "app/nff/nff_scene.h"

namespace alhazen {

// The scene as `alhazen fmt` lays it out, every number as the shortest text that reads back as the
// same double. `name` is said in its first comment. y and z change places, which turns NFF's
// right-handed frame into a left-handed one; docs/nff.md has the rest.
std::string write_scn(const NffScene& scene, std::string_view name);

}  // namespace alhazen

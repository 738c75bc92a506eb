// render/color: the colour configuration that is used when the user brings none.
#pragma once

#include "render/color/ocio.h"

namespace alhazen::render {

// Names that scenes and the rest of the program rely on.
constexpr const char* kAcesCg = "ACEScg";
constexpr const char* kLinearRec709 = "Linear Rec.709 (sRGB)";
constexpr const char* kSrgbTexture = "sRGB - Texture";
constexpr const char* kRaw = "Raw";

// ACES 1.x for computer graphics, made of OpenColorIO's built-in transforms: no file is needed, and
// none of somebody else's is shipped (OpenColorIO 2.1 has no built-in configurations). Throws what
// OpenColorIO throws.
ocio::ConstConfigRcPtr make_builtin_config();

}  // namespace alhazen::render

// app/povray: the picture that POV-Ray wrote.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "render/image/pixel_buffer.h"

namespace alhazen {

// Its R, G and B; it has one part and no other channels. ErrorCode::io when it cannot be read or
// has another size.
Result<render::FloatBuffer> read_povray_picture(const std::filesystem::path& path, int width,
                                                int height);

}  // namespace alhazen

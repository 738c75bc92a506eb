// render/image: the headers of the parts of a written EXR file.
#pragma once

#include <vector>

#include "render/image/exr_output.h"
#include "render/image/exr_write.h"

namespace alhazen::render {

// The beauty part carries every attribute of the picture.
void add_beauty_part(ExrOutput& out, const ExrFile& file, const std::vector<ExrChannel>& channels,
                     const ExrReport& report);
// The data part carries what its own channels need, so that tools which split parts keep it.
void add_data_part(ExrOutput& out, const ExrFile& file, const std::vector<ExrChannel>& channels);

}  // namespace alhazen::render

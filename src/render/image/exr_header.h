// render/image: the headers of the parts of a written EXR file.
#pragma once

#include <OpenEXR/ImfHeader.h>
#include <string>
#include <vector>

#include "render/image/exr_file.h"
#include "render/image/exr_write.h"

namespace alhazen::render {

struct ExrChannel {
  std::string name;
  SampleType type;
};

// The beauty part carries every attribute of the picture.
Imf::Header beauty_header(const ExrFile& file, const std::vector<ExrChannel>& channels,
                          const ExrReport& report);
// The data part carries what its own channels need, so that tools which split parts keep it.
Imf::Header data_header(const ExrFile& file, const std::vector<ExrChannel>& channels);

}  // namespace alhazen::render

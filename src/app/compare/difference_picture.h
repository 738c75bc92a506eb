// app/compare: the difference of two pictures as a picture.
#pragma once

#include <string>
#include <vector>

#include "app/compare/compare.h"
#include "core/base/result.h"
#include "render/image/exr_file.h"

namespace alhazen {

struct DifferencePicture {
  render::ExrFile file;
  std::vector<std::string> left_out;  // sentences: parts that did not fit in
};

// A - B, signed, in 32-bit floats under the channels' own names; the first part has R, G and B
// only, so that no viewer multiplies them by a difference of alpha; all others are in the part
// `data`, with FLIP.E, or LAYER.FLIP.E for a layer other than RGB; HDRFLIP.E alike if it was made.
// A second part's channel whose name is taken is PART.NAME. Fails with ErrorCode::usage when
// nothing was compared.
Result<DifferencePicture> difference_picture(const Comparison& comparison);

}  // namespace alhazen

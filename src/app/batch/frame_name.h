// app/batch: the file name of one frame.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace alhazen {

// The first place for the frame number in `pattern`, as it is written: a run of `#`, or `%d` or
// `%04d`; "" if there is none.
std::string_view frame_place(std::string_view pattern);

// `pattern` with the frame number in its place, padded with zeros to the length of the run of `#`
// or to the width of `%04d`; a minus sign stands before the zeros and is not counted, so that
// `a.####.exr` gives a.0007.exr and a.-0007.exr.
// Fails with ErrorCode::usage when there is no place, or more than one.
Result<std::string> frame_name(std::string_view pattern, int frame);

}  // namespace alhazen

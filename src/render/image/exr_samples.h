// render/image: which samples an EXR channel can hold, and what is written instead of the others.
#pragma once

#include <span>

#include "render/image/exr_file.h"
#include "render/image/exr_write.h"

namespace alhazen::render {

// The largest finite half.
constexpr float kLargestHalf = 65504.0F;

// What stands in the file for `sample`: 0 for NaN and infinities, and +-65504 for what a half would
// turn into infinity, because one infinite pixel makes viewers and filters black out the rest.
float writable_sample(float sample, SampleType type);

// Whether writable_sample leaves all of them as they are: nearly always, and quickly told.
bool are_writable(std::span<const float> samples, SampleType type);

// Adds to `report` how many samples writable_sample changes.
void count_unwritable(std::span<const float> samples, SampleType type, ExrReport& report);

}  // namespace alhazen::render

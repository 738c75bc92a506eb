// app/batch: which frames of an animation to render.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace alhazen {

inline constexpr int kMaxFrame = 9'999'999;
inline constexpr std::size_t kMaxFrames = 1'000'000;

// The frames of a list as render farms write them, in the order given, each once:
//   7         one frame                       1-100    from 1 to 100
//   1-100x5   1, 6, 11, ... up to 100         10-1     downwards
//   -5--1     negative frames                 1-3,7    several of these
// Frames lie in [-kMaxFrame, kMaxFrame]; a list names at most kMaxFrames of them
// (ErrorCode::limit). A `:` is refused: farms disagree on whether 1-10:2 steps by two or
// interleaves.
Result<std::vector<int>> parse_frame_list(std::string_view text);

// The shortest list of ranges in canonical form that parse_frame_list reads as `frames`.
std::string format_frame_list(const std::vector<int>& frames);

}  // namespace alhazen

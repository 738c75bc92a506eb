// app/povray: whether two pictures of one scene, ours and POV-Ray's, are the same but for what is
// known to differ.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/compare/figures.h"
#include "app/compare/tolerance.h"
#include "core/math/vec.h"
#include "render/image/pixel_buffer.h"

namespace alhazen {

// POV-Ray writes half floats: 2^-11 relative to the nearest, and its colours are floats on the way.
inline constexpr Tolerance kHalfFloat{2e-5, 0x1p-10};
// Of all channels of all pixels, within the tolerance.
inline constexpr double kShareWithin = 0.999;

// What a scene that POV-Ray cannot say exactly is held to instead.
struct Allowance {
  double rmse = 0;
  std::string reason;
};

enum class Cause {
  silhouette,  // another object in one of the eight pixels around
  edge,  // a step of about the difference within those pixels: a terminator, a shadow's edge, an
         // object's in a mirror
  unexplained,
};
std::string_view name(Cause cause);

struct JudgedPixel {
  PixelPlace place;
  Rgb<float> ours, theirs;
  double error = 0;  // of the channel that differs most
  Cause cause = Cause::unexplained;
};

struct Verdict {
  bool passes = false;
  bool by_allowance = false;  // it was held to the scene's own tolerance
  std::string sentence;       // why, or why not
  std::uint64_t channels = 0, over = 0;
  std::uint64_t not_finite = 0;  // channels that are NaN or infinite in either picture
  double rmse = 0, largest = 0;
  std::vector<JudgedPixel> pixels;  // over the tolerance, in the order of rows
};

// "same", "same but for edges", "within its tolerance", "DIFFERENT".
std::string_view result_name(const Verdict& verdict);

// Planes R, G, B of one size, and the object that each pixel shows. Passes when all
// values are finite and at least kShareWithin of the channels agree to kHalfFloat and every other
// pixel is a silhouette or an edge; with an allowance when all are finite and the RMSE is at most
// as large.
Verdict judge(const render::FloatBuffer& ours, const render::FloatBuffer& theirs,
              const std::vector<std::uint32_t>& objects, const Allowance* allowance);

}  // namespace alhazen

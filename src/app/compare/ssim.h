// app/compare: structural similarity: Wang, Bovik, Sheikh and Simoncelli, "Image Quality
// Assessment: From Error Visibility to Structural Similarity", 2004.
#pragma once

#include <optional>
#include <span>

#include "render/image/pixel_buffer.h"

namespace alhazen {

// The paper's choice: a Gaussian window of 11 x 11 pixels with sigma 1.5, and constants
// C1 = (K1 L)^2, C2 = (K2 L)^2 with K1 = 0.01 and K2 = 0.03. Our codes are in 0 .. 1, so L = 1.
inline constexpr int kSsimRadius = 5;
inline constexpr double kSsimSigma = 1.5;
inline constexpr double kSsimC1 = 0.01 * 0.01;
inline constexpr double kSsimC2 = 0.03 * 0.03;

// Luma of `light` (channels R, G, B, linear Rec.709 in 0 .. 1): the codes of sRGB weighted as ITU-R
// BT.709 weights them. The paper has grey pictures; this is how one is made of a coloured one.
render::FloatBuffer luma(const render::FloatBuffer& light);

// The mean of the index over all windows that lie within the picture; 1 for equal pictures.
// Nothing for pictures of fewer than 11 pixels in a direction, which no window lies in.
// Precondition: `a` and `b` have the same size and one channel, of codes in 0 .. 1.
std::optional<double> mean_ssim(const render::FloatBuffer& a, const render::FloatBuffer& b);

}  // namespace alhazen

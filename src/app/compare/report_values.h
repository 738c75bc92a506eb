// app/compare: the words and numbers that the text, the page and the JSON share.
#pragma once

#include <string>
#include <string_view>

#include "app/compare/compare.h"

namespace alhazen {

// Five digits: 0.012346, 1.2346e-07; "infinite" and "none" (of a mean of nothing).
std::string figure_text(double value);
// (x, y) in the picture: the window's corner is added.
PixelPlace picture_place(const PartPair& parts, PixelPlace place);
std::string place_text(const PartPair& parts, PixelPlace place);

// What an odd pair is called: "NaN in A only".
std::string_view name(OddPair kind);
// "R: 3 x NaN in A only, the first at (12, 5)", one for each channel and kind there is.
std::vector<std::string> odd_sentences(const PartComparison& part);

// "SSIM 0.99, FLIP 0.01 on average and 0.5 at most, at (12, 5)".
std::string visible_text(const VisibleError& visible, const PartPair& parts);
// "HDR-FLIP 0.02 on average and 0.7 at most, at (12, 5), over 8 exposures from -3 to 4.5 stops".
std::string hdr_text(const HdrFlipResult& hdr, const PartPair& parts);

std::string part_title(const PartComparison& part);
// The limit in words: "more than 0.001", "more than max(2e-05, 0.001 |B|)".
std::string tolerance_text(const Tolerance& tolerance);
// The largest error, or "none" where none was taken.
std::string largest_text(const Figures& figures);
std::string largest_place_text(const PartPair& parts, const Figures& figures);
// The last word: "A and B differ by more than 0: 3 of 100 pixels".
std::string verdict(const Comparison& comparison);

}  // namespace alhazen

// app/page: pictures of one view beside each other, to be flickered between.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/page/html.h"
#include "core/base/result.h"

namespace alhazen {

struct PagePicture {
  int width{}, height{};
  std::vector<std::uint8_t> rgb;  // interleaved, sRGB, rows from the top
  std::string name;               // short: "A", "difference"
  std::string caption;            // what is seen, in a sentence or two
};

// The pictures in a row, or below each other where the screen is narrow, each with its caption. A
// click on one shows it large; there clicks and keys go through the pictures of this row on the
// same spot. Fails with ErrorCode::usage as encode_png does.
Result<Html> html_pictures(std::span<const PagePicture> pictures);

}  // namespace alhazen

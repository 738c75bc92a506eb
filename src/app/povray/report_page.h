// app/povray: the outcome of many cross-checks as one page and as data.
#pragma once

#include <string>
#include <vector>

#include "app/povray/cross_check.h"
#include "core/base/result.h"
#include "render/color/color_transform.h"

namespace alhazen {

// A scene that could not be compared, or was.
struct CheckOutcome {
  std::string name;
  Result<CrossCheck> check;
};

// One HTML page that needs no network: a summary, then for each scene both pictures as `view` shows
// them, where they differ, figures and times.
Result<std::string> report_page(const std::vector<CheckOutcome>& outcomes,
                                const render::ColorTransform& view);
std::string report_json(const std::vector<CheckOutcome>& outcomes);

}  // namespace alhazen

// app/compare: a comparison as JSON; docs/compare.md describes it.
#pragma once

#include <nlohmann/json.hpp>

#include "app/compare/compare.h"

namespace alhazen {

// JSON has no infinity and no NaN: an infinite figure is the string "infinite", one that there is
// none of is null.
nlohmann::ordered_json comparison_json(const Comparison& comparison, const ComparedPicture& a,
                                       const ComparedPicture& b);
nlohmann::ordered_json figures_json(const Figures& figures, const PartPair& parts);

}  // namespace alhazen

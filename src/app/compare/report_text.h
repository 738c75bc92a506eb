// app/compare: a comparison as text for a terminal.
#pragma once

#include <string>

#include "app/compare/compare.h"

namespace alhazen {

std::string comparison_text(const Comparison& comparison, const ComparedPicture& a,
                            const ComparedPicture& b);

}  // namespace alhazen

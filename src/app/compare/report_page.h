// app/compare: a comparison as a page, and as a section of a page that shows many.
#pragma once

#include <string>

#include "app/compare/compare.h"
#include "app/compare/page_view.h"
#include "app/page/html.h"
#include "core/base/result.h"

namespace alhazen {

// Verdict, what differs in shape, and for each part the figures and its layers: A, B, the
// difference and FLIP for colours, the difference in colours of a ramp for others.
Result<Html> comparison_section(const Comparison& comparison, const ComparedPicture& a,
                                const ComparedPicture& b, const PageView& view);

// The same as a whole page: one HTML file that needs no network.
Result<std::string> comparison_page(const Comparison& comparison, const ComparedPicture& a,
                                    const ComparedPicture& b, const PageView& view);

// The figures of one part as a table, a row for each channel and each layer of several channels.
Html figures_table(const PartComparison& part, const CompareSettings& settings);

}  // namespace alhazen

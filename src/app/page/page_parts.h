// app/page: the style sheet and the script that stand in every page.
#pragma once

#include <string_view>

namespace alhazen {

extern const std::string_view kPageStyle;   // CSS
extern const std::string_view kPageScript;  // JavaScript: the large view of html_pictures

}  // namespace alhazen

// app/page: a page in one file that needs no network: it loads nothing, and forbids itself to.
#pragma once

#include <string_view>

#include "app/page/html.h"

namespace alhazen {

// What a page has beside the style sheet and the script of every page.
struct PageExtras {
  std::string_view style, script;
};

// A whole HTML document, UTF-8. `title` is plain text: the name of the window and the heading.
// `body` follows the heading. Light or dark as the reader's system is, readable on a phone; without
// JavaScript only the large view of html_pictures is missing.
std::string html_page(std::string_view title, const Html& body, const PageExtras& extras = {});

}  // namespace alhazen

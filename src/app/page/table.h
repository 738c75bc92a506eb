// app/page: a table of figures.
#pragma once

#include <string>
#include <vector>

#include "app/page/html.h"

namespace alhazen {

struct HtmlColumn {
  std::string title;
  bool numeric = false;     // set to the right, in digits of one width
  std::string explanation;  // shown when the pointer rests on the title; may be empty
};

struct HtmlTable {
  std::vector<HtmlColumn> columns;
  std::vector<std::vector<Html>> rows;  // one cell for each column
};

// A table wider than the screen scrolls by itself; the page does not.
Html html_table(const HtmlTable& table);

}  // namespace alhazen

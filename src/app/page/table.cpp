#include "app/page/table.h"

namespace alhazen {
namespace {

std::vector<HtmlAttribute> cell_attributes(const HtmlColumn& column) {
  if (!column.numeric) return {};
  return {{"class", "number"}};
}

Html heading(const HtmlColumn& column) {
  std::vector<HtmlAttribute> attributes = cell_attributes(column);
  if (!column.explanation.empty()) attributes.emplace_back("title", column.explanation);
  return html_line("th", column.title, attributes);
}

}  // namespace

Html html_table(const HtmlTable& table) {
  Html head;
  for (const HtmlColumn& column : table.columns)
    head += heading(column);
  Html body;
  for (const std::vector<Html>& row : table.rows) {
    Html cells;
    for (std::size_t i = 0; i < row.size(); ++i)
      cells += html_element("td", row[i], cell_attributes(table.columns[i]));
    body += html_element("tr", cells);
  }
  const Html whole = html_element(
      "table", html_element("thead", html_element("tr", head)) + html_element("tbody", body));
  return html_element("div", whole, {{"class", "wide"}});
}

}  // namespace alhazen

#include "app/page/html.h"

#include <fmt/format.h>

namespace alhazen {

Html html_text(std::string_view text) {
  Html html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html.code += "&amp;";
        break;
      case '<':
        html.code += "&lt;";
        break;
      case '>':
        html.code += "&gt;";
        break;
      case '"':
        html.code += "&quot;";
        break;
      case '\'':
        html.code += "&#39;";
        break;
      default:
        html.code += c;
    }
  }
  return html;
}

Html html_element(std::string_view name, const Html& content,
                  const std::vector<HtmlAttribute>& attributes) {
  Html html{fmt::format("<{}", name)};
  for (const auto& [key, value] : attributes) {
    html.code += value.empty() ? fmt::format(" {}", key)
                               : fmt::format(" {}=\"{}\"", key, html_text(value).code);
  }
  html.code += fmt::format(">{}</{}>\n", content.code, name);
  return html;
}

Html html_line(std::string_view name, std::string_view text,
               const std::vector<HtmlAttribute>& attributes) {
  return html_element(name, html_text(text), attributes);
}

}  // namespace alhazen

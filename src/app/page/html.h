// app/page: HTML as a type of its own, so that text cannot get into a page without being escaped.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace alhazen {

// Ready HTML: tags, and text that is escaped already.
struct Html {
  std::string code;

  Html& operator+=(const Html& more) {
    code += more.code;
    return *this;
  }
  friend Html operator+(Html first, const Html& second) { return first += second; }
};

// Plain text as HTML; it may stand in an attribute between double quotes too.
Html html_text(std::string_view text);

// Name and plain value; the value is escaped. An empty value gives a bare attribute: open.
using HtmlAttribute = std::pair<std::string, std::string>;

// <name attributes>content</name>. Precondition: names are names of HTML, in small letters.
Html html_element(std::string_view name, const Html& content,
                  const std::vector<HtmlAttribute>& attributes = {});

// <p>text</p>, <h2>text</h2>: an element with plain text in it.
Html html_line(std::string_view name, std::string_view text,
               const std::vector<HtmlAttribute>& attributes = {});

}  // namespace alhazen

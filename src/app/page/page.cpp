#include "app/page/page.h"

#include <fmt/format.h>

#include "app/page/page_parts.h"

namespace alhazen {
namespace {

// Nothing but what stands in the file itself.
constexpr std::string_view kPolicy =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

}  // namespace

std::string html_page(std::string_view title, const Html& body, const PageExtras& extras) {
  const std::string name = html_text(title).code;
  return fmt::format(
      "<!DOCTYPE html>\n"
      "<html lang=\"en\">\n"
      "<head>\n"
      "<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<title>{}</title>\n"
      "<style>\n{}{}</style>\n"
      "</head>\n"
      "<body>\n"
      "<main>\n<h1>{}</h1>\n{}</main>\n"
      "<script>\n{}{}</script>\n"
      "</body>\n"
      "</html>\n",
      kPolicy, name, kPageStyle, extras.style, name, body.code, kPageScript, extras.script);
}

}  // namespace alhazen

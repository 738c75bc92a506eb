#include "app/page/pictures.h"

#include <fmt/format.h>

#include "app/page/base64.h"
#include "render/image/png_write.h"

namespace alhazen {
namespace {

// Pictures that the page makes larger show their pixels as squares.
constexpr int kSmallWidth = 400;

Result<Html> figure(const PagePicture& picture) {
  const Result<std::string> png = render::encode_png(picture.rgb, picture.width, picture.height, 3);
  if (!png) return png.error();
  const Html image{
      fmt::format("<img src=\"data:image/png;base64,{}\" alt=\"{}\" width=\"{}\" height=\"{}\"{}>",
                  base64(png.value()), html_text(picture.name).code, picture.width, picture.height,
                  picture.width < kSmallWidth ? " class=\"small\"" : "")};
  const Html button = html_element("button", image, {{"type", "button"}});
  const Html caption = html_element(
      "figcaption", html_line("strong", picture.name) + html_line("span", picture.caption));
  return html_element("figure", button + caption);
}

}  // namespace

Result<Html> html_pictures(std::span<const PagePicture> pictures) {
  Html figures;
  for (const PagePicture& picture : pictures) {
    const Result<Html> html = figure(picture);
    if (!html) return html.error();
    figures += html.value();
  }
  return html_element("div", figures,
                      {{"class", pictures.size() == 3 ? "pictures three" : "pictures"}});
}

}  // namespace alhazen

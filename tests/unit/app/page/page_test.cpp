#include "app/page/page.h"

#include <gmock/gmock.h>

#include "app/page/base64.h"
#include "app/page/pictures.h"
#include "app/page/table.h"
#include "render/image/png_write.h"

namespace alhazen {
namespace {

using testing::HasSubstr;
using testing::Not;

PagePicture red_pixel(std::string name) {
  return {1, 1, {255, 0, 0}, std::move(name), "one red pixel"};
}

TEST(Html, TextCannotOpenATagOrLeaveAnAttribute) {
  EXPECT_EQ(html_text("a<b> & \"c\" 'd'").code, "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
  EXPECT_EQ(html_line("p", "1 < 2", {{"title", "\">"}}).code,
            "<p title=\"&quot;&gt;\">1 &lt; 2</p>\n");
  EXPECT_EQ(html_element("details", html_line("b", "x"), {{"open", ""}}).code,
            "<details open><b>x</b>\n</details>\n");
}

TEST(Html, TableHasARowForEachRowAndNumbersToTheRight) {
  const Html table = html_table({{{"channel"}, {"MSE", true, "mean of (a - b)\u00b2"}},
                                 {{html_text("R"), html_text("0.5")}}});
  EXPECT_THAT(table.code, HasSubstr("<th class=\"number\" title=\"mean of (a - b)\u00b2\">MSE"));
  EXPECT_THAT(table.code, HasSubstr("<td>R</td>"));
  EXPECT_THAT(table.code, HasSubstr("<td class=\"number\">0.5</td>"));
}

TEST(Html, PicturesStandInThePage) {
  const std::vector<PagePicture> pictures{red_pixel("A"), red_pixel("<B>")};
  const Result<Html> html = html_pictures(pictures);
  ASSERT_TRUE(html);
  const Result<std::string> png = render::encode_png(pictures[0].rgb, 1, 1, 3);
  ASSERT_TRUE(png);
  EXPECT_THAT(html.value().code, HasSubstr("data:image/png;base64," + base64(png.value())));
  EXPECT_THAT(html.value().code, HasSubstr("alt=\"&lt;B&gt;\""));
}

TEST(Html, PictureThatContradictsItselfIsAnError) {
  PagePicture picture = red_pixel("A");
  picture.width = 2;
  const Result<Html> html = html_pictures(std::vector{picture});
  ASSERT_FALSE(html);
  EXPECT_EQ(html.error().code, ErrorCode::usage);
}

TEST(Page, TitleIsText) {
  const std::string page = html_page("a<b", html_line("p", "body"));
  EXPECT_THAT(page, HasSubstr("<title>a&lt;b</title>"));
  EXPECT_THAT(page, HasSubstr("<h1>a&lt;b</h1>"));
  EXPECT_THAT(page, HasSubstr("<p>body</p>"));
}

TEST(Page, LoadsNothing) {
  const std::vector<PagePicture> pictures{red_pixel("A")};
  const std::string page = html_page("t", html_pictures(pictures).value());
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, Not(HasSubstr("://")));
  EXPECT_THAT(page, Not(HasSubstr("url(")));
  EXPECT_THAT(page, Not(HasSubstr("@import")));
  EXPECT_THAT(page, Not(HasSubstr("<link")));
  for (std::size_t at = 0; (at = page.find("src=\"", at)) != std::string::npos; ++at)
    EXPECT_EQ(page.substr(at, 10), "src=\"data:");
}

TEST(Page, IsForLightAndDarkAndPhones) {
  const std::string page = html_page("t", {});
  EXPECT_THAT(page, HasSubstr("prefers-color-scheme: dark"));
  EXPECT_THAT(page, HasSubstr("width=device-width"));
}

}  // namespace
}  // namespace alhazen

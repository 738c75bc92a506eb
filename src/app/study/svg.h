// app/study: the few shapes that charts are drawn with. Coordinates are rounded to a tenth.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/page/html.h"
#include "app/study/chart.h"

namespace alhazen {

struct SvgPlace {
  double x = 0, y = 0;
};

Html svg_line(SvgPlace from, SvgPlace to, std::string_view css_class);
Html svg_path(const std::vector<SvgPlace>& places, std::string_view css_class);
Html svg_box(SvgPlace corner, double width, double height, std::string_view css_class);
// `anchor`: start, middle, end.
Html svg_text(SvgPlace at, std::string_view text, std::string_view anchor,
              std::string_view css_class);
// `base` with `exponent` raised.
Html svg_power(SvgPlace at, std::string_view base, std::string_view exponent,
               std::string_view css_class);
Html svg_marker(Marker marker, SvgPlace at, double radius, std::string_view css_class);

}  // namespace alhazen

#include "app/study/svg.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <span>

namespace alhazen {
namespace {

std::string number(double value) {
  const double tenths = std::round(10 * value) / 10;
  return fmt::format("{:g}", tenths == 0 ? 0.0 : tenths);
}

std::string place(SvgPlace p) {
  return number(p.x) + " " + number(p.y);
}

// Corners on a circle, the first at `turn` of a full turn from above.
Html polygon(SvgPlace at, std::span<const double> radii, double turn, std::string_view css_class) {
  std::string d;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double angle =
        2 * std::numbers::pi * (turn + static_cast<double>(i) / static_cast<double>(radii.size()));
    const SvgPlace p{at.x + radii[i] * std::sin(angle), at.y - radii[i] * std::cos(angle)};
    d += (i == 0 ? "M" : "L") + place(p);
  }
  return {fmt::format("<path class=\"{}\" d=\"{}Z\"/>", css_class, d)};
}

Html crossed_lines(SvgPlace at, double radius, double turn, std::string_view css_class) {
  std::string d;
  for (const double add : {0.0, 0.25}) {
    const double angle = 2 * std::numbers::pi * (turn + add);
    const double x = radius * std::sin(angle), y = radius * std::cos(angle);
    d += "M" + place({at.x - x, at.y + y}) + "L" + place({at.x + x, at.y - y});
  }
  return {fmt::format("<path class=\"{} stroke\" d=\"{}\"/>", css_class, d)};
}

}  // namespace

Html svg_line(SvgPlace from, SvgPlace to, std::string_view css_class) {
  return {fmt::format("<line class=\"{}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>", css_class,
                      number(from.x), number(from.y), number(to.x), number(to.y))};
}

Html svg_path(const std::vector<SvgPlace>& places, std::string_view css_class) {
  std::string d;
  for (const SvgPlace& p : places)
    d += (d.empty() ? "M" : "L") + place(p);
  return {fmt::format("<path class=\"{}\" d=\"{}\"/>", css_class, d)};
}

Html svg_box(SvgPlace corner, double width, double height, std::string_view css_class) {
  return {fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
                      css_class, number(corner.x), number(corner.y), number(width),
                      number(height))};
}

Html svg_text(SvgPlace at, std::string_view text, std::string_view anchor,
              std::string_view css_class) {
  return {fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>",
                      css_class, number(at.x), number(at.y), anchor, html_text(text).code)};
}

Html svg_power(SvgPlace at, std::string_view base, std::string_view exponent,
               std::string_view css_class) {
  return {fmt::format(
      "<text class=\"{}\" x=\"{}\" y=\"{}\">{}<tspan dy=\"-4\" "
      "class=\"raised\">{}</tspan></text>",
      css_class, number(at.x), number(at.y), html_text(base).code, html_text(exponent).code)};
}

Html svg_marker(Marker marker, SvgPlace at, double radius, std::string_view css_class) {
  const auto regular = [&](std::size_t corners, double turn, double size) {
    return polygon(at, std::vector<double>(corners, size * radius), turn, css_class);
  };
  switch (marker) {
    case Marker::circle:
      return {fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>", css_class,
                          number(at.x), number(at.y), number(radius))};
    case Marker::square:
      return regular(4, 0.125, 1.25);
    case Marker::triangle:
      return regular(3, 0, 1.3);
    case Marker::diamond:
      return regular(4, 0, 1.3);
    case Marker::point_down:
      return regular(3, 0.5, 1.3);
    case Marker::plus:
      return crossed_lines(at, 1.2 * radius, 0, css_class);
    case Marker::cross:
      return crossed_lines(at, 1.2 * radius, 0.125, css_class);
    case Marker::star:
      break;
  }
  std::vector<double> radii;
  for (int i = 0; i < 10; ++i)
    radii.push_back(radius * (i % 2 == 0 ? 2 : 0.85));
  return polygon(at, radii, 0, css_class);
}

}  // namespace alhazen

#include "app/study/chart.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "app/study/axis.h"
#include "app/study/label_places.h"
#include "app/study/number_text.h"
#include "app/study/svg.h"

namespace alhazen {
namespace {

constexpr double kLeft = 84, kRight = 16, kTop = 14, kBottom = 44;  // around the plot
constexpr double kLetter = 6.3, kLineHeight = 13;                   // of labels, about
constexpr double kTickLetter = 7.2, kTickGap = 8;
constexpr double kRadius = 4.5, kFaintRadius = 2.2;

// Letters, not bytes, of UTF-8.
double letters_of(const std::string& text) {
  return static_cast<double>(
      std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; }));
}
double text_width(const std::string& text) {
  return kLetter * letters_of(text);
}

bool can_be_drawn(CostPoint p) {
  return p.seconds > 0 && p.error > 0;
}

struct Ranges {
  double low = std::numeric_limits<double>::infinity(), high = 0;

  void include(double value) {
    if (!(value > 0)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

class ChartWriter {
 public:
  explicit ChartWriter(const Chart& chart) : chart_(chart) {
    Ranges seconds, errors;
    for (const ChartSeries& series : chart.series) {
      for (const ChartPoint& p : series.points) {
        if (!can_be_drawn(p.at)) continue;
        seconds.include(p.at.seconds);
        errors.include(p.at.error);
      }
    }
    is_empty_ = !(seconds.high > 0);
    if (is_empty_) return;
    // The floor is shown where there is room for it anyway.
    if (chart.floor > 0 && chart.floor > errors.low / 20) errors.include(chart.floor);
    x_ = log_axis(seconds.low, seconds.high, duration_text);
    y_ = log_axis(errors.low, errors.high, print_number);
  }

  Html write() {
    Html body;
    if (is_empty_) {
      body += svg_text({chart_.width / 2.0, chart_.height / 2.0}, "nothing can be shown here",
                       "middle", "tick");
    } else {
      body += plot();
    }
    return {fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">{}</svg>\n",
                        chart_.width, chart_.height, html_text(chart_.title).code, body.code)};
  }

 private:
  double right() const { return chart_.width - kRight; }
  double bottom() const { return chart_.height - kBottom; }
  SvgPlace at(CostPoint p) const {
    return {kLeft + x_.place(p.seconds) * (right() - kLeft),
            bottom() - y_.place(p.error) * (bottom() - kTop)};
  }

  Html plot() {
    Html html = grid();
    html += floor_and_mark();
    html += guides();
    html += front();
    for (const ChartSeries& series : chart_.series)
      html += lines(series);
    // What is in the background is drawn first.
    for (const bool faint : {true, false}) {
      for (const ChartSeries& series : chart_.series) {
        if (series.is_faint == faint) html += points(series);
      }
    }
    return html + labels();
  }

  Html grid() const {
    Html html;
    double last_label = -1e9;
    for (const AxisTick& tick : x_.ticks) {
      const double x = at({tick.value, y_.low}).x;
      html += svg_line({x, kTop}, {x, bottom()}, tick.label.empty() ? "grid thin" : "grid");
      const double half = kTickLetter * letters_of(tick.label) / 2;
      if (tick.label.empty() || x - half < last_label + kTickGap) continue;
      html += svg_text({x, bottom() + 17}, tick.label, "middle", "tick");
      last_label = x + half;
    }
    for (const AxisTick& tick : y_.ticks) {
      const double y = at({x_.low, tick.value}).y;
      html += svg_line({kLeft, y}, {right(), y}, tick.label.empty() ? "grid thin" : "grid");
      html += svg_text({kLeft - 7, y + 4}, tick.label, "end", "tick");
    }
    html +=
        svg_text({(kLeft + right()) / 2, chart_.height - 8.0}, chart_.x_title, "middle", "axis");
    const double middle = (kTop + bottom()) / 2;
    html += Html{fmt::format("<g transform=\"rotate(-90 12 {:.0f})\">{}</g>", middle,
                             svg_text({12, middle}, chart_.y_title, "middle", "axis").code)};
    return html;
  }

  Html floor_and_mark() {
    Html html;
    if (chart_.floor > y_.low && chart_.floor < y_.high) {
      const double y = at({x_.low, chart_.floor}).y;
      html += svg_box({kLeft, y}, right() - kLeft, bottom() - y, "floor");
      taken_.push_back(
          {kLeft + 4, y + 2, text_width("the reference knows no better"), kLineHeight});
      html += svg_text({kLeft + 6, y + 13}, "the reference knows no better", "start", "note");
    }
    if (chart_.mark > y_.low && chart_.mark < y_.high) {
      const double y = at({x_.low, chart_.mark}).y;
      html += svg_line({kLeft, y}, {right(), y}, "mark");
      taken_.push_back({right() - text_width(chart_.mark_label) - 6, y - 15,
                        text_width(chart_.mark_label) + 4, kLineHeight});
      html += svg_text({right() - 5, y - 4}, chart_.mark_label, "end", "note");
    }
    return html;
  }

  Html guides() {
    Html html;
    const double low = chart_.floor > y_.low ? std::min(chart_.floor, y_.high) : y_.low;
    for (const CostPoint& anchor : chart_.guides_from) {
      for (const Guide& guide : chart_.guides) {
        const auto line = guide_line(guide, anchor, {x_.low, x_.high, low, y_.high});
        if (!line) continue;
        const SvgPlace from = at(line->first), to = at(line->second);
        html += svg_line(from, to, "guide");
        const double width = kLetter * (1 + 0.7 * letters_of(guide.label));
        const bool to_right = to.x + width + 4 > right();
        const double x = to_right ? to.x - width - 3 : to.x + 3, y = to_right ? to.y - 9 : to.y - 5;
        const LabelBox box{x, y - kLineHeight + 3, width, kLineHeight};
        const auto covers = [&](const LabelBox& other) { return overlap(box, other); };
        if (std::ranges::any_of(taken_, covers)) continue;
        taken_.push_back(box);
        html += svg_power({x, y}, "N", guide.label, "note");
      }
    }
    return html;
  }

  Html front() const {
    std::vector<SvgPlace> places;
    for (const CostPoint& p : chart_.front) {
      if (can_be_drawn(p)) places.push_back(at(p));
    }
    return places.size() < 2 ? Html{} : svg_path(places, "front");
  }

  // Labels beside a line, not on it.
  void keep_clear(const std::vector<SvgPlace>& places) {
    constexpr double kApart = 6, kSide = 2;
    for (std::size_t i = 1; i < places.size(); ++i) {
      const SvgPlace a = places[i - 1], b = places[i];
      const int steps = static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / kApart) + 1;
      for (int k = 0; k <= steps; ++k) {
        const double along = static_cast<double>(k) / steps;
        taken_.push_back({a.x + along * (b.x - a.x) - kSide / 2,
                          a.y + along * (b.y - a.y) - kSide / 2, kSide, kSide});
      }
    }
  }

  Html lines(const ChartSeries& series) {
    if (!series.has_line) return {};
    std::vector<SvgPlace> places;
    for (const ChartPoint& p : series.points) {
      if (can_be_drawn(p.at)) places.push_back(at(p.at));
    }
    if (places.size() < 2) return {};
    keep_clear(places);
    return svg_path(places,
                    fmt::format("line s{}{}", series.color, series.is_hollow ? " dashed" : ""));
  }

  Html points(const ChartSeries& series) {
    Html html;
    for (const ChartPoint& p : series.points) {
      if (!can_be_drawn(p.at)) continue;
      const SvgPlace place = at(p.at);
      if (series.is_faint) {
        html += svg_marker(Marker::circle, place, kFaintRadius, "faint");
        continue;
      }
      Html drawn = {fmt::format("<title>{}</title>", html_text(p.title).code)};
      if (p.seconds_low > x_.low && p.seconds_high < x_.high && p.seconds_low < p.seconds_high) {
        const SvgPlace from = at({p.seconds_low, p.at.error});
        const SvgPlace to = at({p.seconds_high, p.at.error});
        keep_clear({from, to});
        drawn += svg_line(from, to, fmt::format("spread s{}", series.color));
      }
      // A finger needs more room than a marker.
      drawn += svg_marker(Marker::circle, place, 2.2 * kRadius, "touch");
      if (p.is_scene) drawn += svg_marker(Marker::circle, place, 2 * kRadius, "own");
      drawn += svg_marker(series.marker, place, kRadius,
                          fmt::format("s{}{}", series.color, series.is_hollow ? " hollow" : ""));
      html += html_element("a", drawn, {{"href", "#" + p.target}, {"data-point", p.target}});
      taken_.push_back({place.x - kRadius, place.y - kRadius, 2 * kRadius, 2 * kRadius});
      (p.is_scene || on_front(p.at) ? important_ : others_).push_back({&p, place, series.color});
    }
    return html;
  }

  bool on_front(CostPoint p) const {
    return std::ranges::any_of(
        chart_.front, [&](CostPoint q) { return q.seconds == p.seconds && q.error == p.error; });
  }

  Html labels() const {
    std::vector<Labelled> all = important_;
    all.insert(all.end(), others_.begin(), others_.end());
    std::vector<LabelWish> wishes;
    for (const Labelled& l : all)
      wishes.push_back({l.place.x, l.place.y, text_width(l.point->label), kLineHeight - 2});
    const LabelBox bounds{kLeft + 1, kTop + 1, right() - kLeft - 2, bottom() - kTop - 2};
    constexpr double kReach = 12;
    const auto places = place_labels(wishes, taken_, bounds, kReach);
    Html html;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!places[i]) continue;
      const SvgPlace base{places[i]->x + places[i]->width / 2, places[i]->y + kLineHeight - 4};
      html += svg_text(base, all[i].point->label, "middle", fmt::format("label s{}", all[i].color));
    }
    return html;
  }

  struct Labelled {
    const ChartPoint* point;
    SvgPlace place;
    int color;
  };

  const Chart& chart_;
  LogAxis x_, y_;
  bool is_empty_ = false;
  std::vector<LabelBox> taken_;
  std::vector<Labelled> important_, others_;
};

}  // namespace

Html chart_svg(const Chart& chart) {
  return ChartWriter(chart).write();
}

Html legend_marker(const ChartSeries& series) {
  const Html marker =
      svg_marker(series.marker, {8, 8}, kRadius,
                 fmt::format("s{}{}", series.color, series.is_hollow ? " hollow" : ""));
  return {fmt::format("<svg class=\"key\" viewBox=\"0 0 16 16\" aria-hidden=\"true\">{}</svg>",
                      marker.code)};
}

}  // namespace alhazen

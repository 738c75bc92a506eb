// app/study: a log-log chart as SVG: made once, without a script, in the page's own colours.
#pragma once

#include <string>
#include <vector>

#include "app/page/html.h"
#include "app/study/front.h"
#include "app/study/guides.h"

namespace alhazen {

enum class Marker { circle, square, triangle, diamond, point_down, plus, cross, star };

struct ChartPoint {
  CostPoint at;
  double seconds_low = 0, seconds_high = 0;  // the spread of its runs
  std::string label;
  std::string target;  // the id of what a click leads to
  std::string title;   // read out, and shown by a browser without scripts
  bool is_scene = false;
};

struct ChartSeries {
  std::string name;
  int color = 0;  // class s0, s1, ... of the style sheet
  Marker marker = Marker::circle;
  bool has_line = false, is_hollow = false;
  bool is_faint = false;  // context: small, without labels
  std::vector<ChartPoint> points;
};

struct Chart {
  std::string title;  // for those who cannot see it
  std::string x_title, y_title;
  int width = 0, height = 0;  // in units of the page's pixels
  std::vector<ChartSeries> series;
  std::vector<CostPoint> front;
  std::vector<Guide> guides;
  std::vector<CostPoint> guides_from;  // one anchor, or none
  double floor = 0;                    // below it nothing can be known; 0: no such line
  double mark = 0;                     // a horizontal line at this error, or 0
  std::string mark_label;
};

// Points and lines with a number that is not positive are left out.
Html chart_svg(const Chart& chart);

// The marker of a series, as it stands in a legend.
Html legend_marker(const ChartSeries& series);

}  // namespace alhazen

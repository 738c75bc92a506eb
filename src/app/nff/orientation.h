// app/nff: on which side of a line a point lies, without rounding.
#pragma once

namespace alhazen {

struct Point2 {
  double x = 0, y = 0;
  friend bool operator==(const Point2&, const Point2&) = default;
};

// 1 if a, b, c run counterclockwise, -1 if clockwise, 0 if they lie on one line: the exact sign, as
// long as no product of coordinates overflows or comes near the smallest double.
int orientation(Point2 a, Point2 b, Point2 c);

}  // namespace alhazen

// app/nff: the orientation of three points after J. R. Shewchuk, "Adaptive Precision Floating-Point
// Arithmetic and Fast Robust Geometric Predicates", 1997: plain arithmetic where its error bound
// settles the sign, otherwise an exact sum.
#include "app/nff/orientation.h"

#include <array>
#include <cmath>

#include "core/math/error_free.h"

namespace alhazen {
namespace {

// An exact sum of doubles as parts that do not overlap, the smallest first, zeros among them
// (Shewchuk's Grow-Expansion, figure 6).
class ExactSum {
 public:
  void add(double value) {
    for (std::size_t i = 0; i < count_; ++i) {
      const DoubleWord<double> sum = two_sum(value, parts_[i]);
      parts_[i] = sum.lo;
      value = sum.hi;
    }
    parts_[count_++] = value;
  }
  void add(DoubleWord<double> value) {
    add(value.lo);
    add(value.hi);
  }
  // The largest part that is not 0 is larger than all that follow together.
  int sign() const {
    for (std::size_t i = count_; i-- > 0;) {
      if (parts_[i] != 0) return parts_[i] > 0 ? 1 : -1;
    }
    return 0;
  }

 private:
  std::array<double, 12> parts_{};
  std::size_t count_ = 0;
};

// The determinant multiplied out: six products, each exact in two words.
int exact_orientation(Point2 a, Point2 b, Point2 c) {
  ExactSum sum;
  sum.add(two_product(a.x, b.y));
  sum.add(two_product(-a.y, b.x));
  sum.add(two_product(b.x, c.y));
  sum.add(two_product(-b.y, c.x));
  sum.add(two_product(c.x, a.y));
  sum.add(two_product(-c.y, a.x));
  return sum.sign();
}

}  // namespace

int orientation(Point2 a, Point2 b, Point2 c) {
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
  const double determinant = left - right;
  // Shewchuk's ccwerrboundA, with u = 2^-53.
  constexpr double kUnit = 0x1p-53;
  const double bound = (3 + 16 * kUnit) * kUnit * (std::fabs(left) + std::fabs(right));
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  return exact_orientation(a, b, c);
}

}  // namespace alhazen

// render/film: the cubic pieces of the reconstruction filters.
#include "render/film/filter_profile.h"

#include <algorithm>

#include "core/math/elementary.h"
#include "core/math/scalar.h"

namespace alhazen::render {
namespace {

double cubic_value(const std::array<double, 4>& c, double t) {
  return ((c[3] * t + c[2]) * t + c[1]) * t + c[0];
}

double cubic_integral(const std::array<double, 4>& c, double t) {
  return (((c[3] / 4 * t + c[2] / 3) * t + c[1] / 2) * t + c[0]) * t;
}

// a + b x + c x^2 + d x^3 on [start, end], as a cubic in t from 0 to 1.
std::array<double, 4> in_piece(const std::array<double, 4>& p, double start, double end) {
  const double w = end - start;
  return {cubic_value(p, start), w * (p[1] + start * (2 * p[2] + start * 3 * p[3])),
          w * w * (p[2] + 3 * start * p[3]), w * w * w * p[3]};
}

// The t in [0, 1] at which the integral of the cubic, positive inside, reaches `target`: Newton's
// steps, and bisection where one would leave the bracket. Ends when t no longer changes. The
// quotients of cubic_integral() are taken once.
double integral_inverted(const std::array<double, 4>& c, double target) {
  const std::array<double, 4> antiderivative{c[0], c[1] / 2, c[2] / 3, c[3] / 4};
  double low = 0, high = 1;
  double t = smaller(1.0, target / cubic_value(antiderivative, 1));
  for (;;) {
    const double excess = cubic_value(antiderivative, t) * t - target;
    if (excess == 0) return t;
    (excess > 0 ? high : low) = t;
    double next = t - excess / cubic_value(c, t);
    if (!(next > low && next < high)) next = low + (high - low) / 2;
    if (next == t || next == low || next == high) return t;
    t = next;
  }
}

}  // namespace

FilterProfile::FilterProfile(FilterKind kind, double radius) : kind_(kind), radius_(radius) {
  switch (kind) {
    case FilterKind::box:
      append(0, 1, 1, {1, 0, 0, 0});
      break;
    case FilterKind::tent:
      append(0, 1, 1, {1, -1, 0, 0});
      break;
    case FilterKind::gaussian:
      build_gaussian();
      break;
    case FilterKind::mitchell:
      build_mitchell();
      break;
  }
  normalise();
}

void FilterProfile::append(double start, double end, double sign,
                           const std::array<double, 4>& cubic) {
  const double before = pieces_.empty() ? 0 : pieces_.back().mass_before + pieces_.back().mass;
  pieces_.push_back(
      {start, end - start, sign, cubic, before, (end - start) * cubic_integral(cubic, 1)});
}

void FilterProfile::build_gaussian() {
  constexpr int kPieces = 128;
  constexpr double kRate = 4.5;  // exp(-(x / sigma)^2 / 2) at x = radius = 3 sigma is exp(-4.5)
  const double floor = exp_of(-kRate);
  const auto value = [&](double s) { return exp_of(-kRate * s * s) - floor; };
  const auto slope = [&](double s) { return -2 * kRate * s * exp_of(-kRate * s * s); };
  for (int i = 0; i < kPieces; ++i) {
    const double a = static_cast<double>(i) / kPieces, w = 1.0 / kPieces, b = a + w;
    const double fa = value(a), fb = value(b), da = w * slope(a), db = w * slope(b);
    append(a, b, 1, {fa, da, 3 * (fb - fa) - 2 * da - db, 2 * (fa - fb) + da + db});
  }
}

// D. Mitchell and A. Netravali, "Reconstruction filters in computer graphics", 1988, with
// B = C = 1/3, in x = 2 |distance| / radius. It is negative from 8/7 to 2, where it is
// 7/18 (x - 2)^2 (8/7 - x).
void FilterProfile::build_mitchell() {
  const std::array<double, 4> inner{16.0 / 3, 0, -12 * 4.0, 7 * 8.0};
  const std::array<double, 4> outer{32.0 / 3, -20 * 2.0, 12 * 4.0, -7.0 / 3 * 8};
  const auto negated = [](std::array<double, 4> p) {
    for (double& coefficient : p)
      coefficient = -coefficient;
    return p;
  };
  const double crossing = 4.0 / 7;
  append(0, 0.5, 1, in_piece(inner, 0, 0.5));
  append(0.5, crossing, 1, in_piece(outer, 0.5, crossing));
  append(crossing, 1, -1, in_piece(negated(outer), crossing, 1));
  // The value and, at 2, the slope vanish exactly at the ends of the lobe.
  pieces_[1].c[0] = 1.0 / 3;
  pieces_[2].c[0] = 0;
}

void FilterProfile::normalise() {
  double positive = 0, negative = 0;
  for (const Piece& piece : pieces_)
    (piece.sign > 0 ? positive : negative) += piece.mass;
  const double whole = 2 * (positive - negative);
  for (Piece& piece : pieces_) {
    for (double& coefficient : piece.c)
      coefficient /= whole;
    piece.mass /= whole;
    piece.mass_before /= whole;
  }
  negative_ = 2 * negative / whole;
  positive_ = 1 + negative_;
}

const FilterProfile::Piece& FilterProfile::piece_at(double distance) const {
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), distance,
                                      [](double d, const Piece& piece) { return d < piece.start; });
  return *std::prev(after);
}

double FilterProfile::value(double x) const {
  const double distance = absolute(x) / radius_;
  if (distance > 1) return 0;
  const Piece& piece = piece_at(distance);
  const double t = (distance - piece.start) / piece.width;
  return piece.sign * cubic_value(piece.c, t) / radius_;
}

bool FilterProfile::is_negative(double x) const {
  return negative_ > 0 && piece_at(absolute(x) / radius_).sign < 0;
}

double FilterProfile::quantile(double u) const {
  if (kind_ == FilterKind::box) return (2 * u - 1) * radius_;
  const double side = u < 0.5 ? -radius_ : radius_;
  const double share = absolute(2 * u - 1);  // of the mass of that side, from the centre outwards
  if (kind_ == FilterKind::tent) return side * (1 - square_root(1 - share));
  const Piece& last = pieces_.back();
  const double target = share * (last.mass_before + last.mass);
  const auto after =
      std::upper_bound(pieces_.begin(), pieces_.end(), target,
                       [](double mass, const Piece& piece) { return mass < piece.mass_before; });
  const Piece& piece = *std::prev(after);
  const double t = integral_inverted(piece.c, (target - piece.mass_before) / piece.width);
  return side * (piece.start + piece.width * t);
}

}  // namespace alhazen::render

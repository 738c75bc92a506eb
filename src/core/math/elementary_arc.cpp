// core/math: the inverse circular functions in double. All come down to the angle of a point.
#include <bit>
#include <cstdint>
#include <initializer_list>

#include "core/math/elementary.h"
#include "core/math/error_free.h"

namespace alhazen {
namespace {

using Word = DoubleWord<double>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr Word kTurnsPerRadian{0x1.45f306dc9c883p-3, -0x1.6b01ec5417056p-57};

// atan(i/8) in turns (tests/golden/elementary/make.py --constants prints them).
constexpr Word kTurnOfEighths[] = {{0, 0},
                                   {0x1.4444750777668p-6, 0x1.b7f9255cb1f1ep-60},
                                   {0x1.3f670b6bdc73dp-5, 0x1.bbe87e7941244p-61},
                                   {0x1.d3c3a482f3ab5p-5, -0x1.16f02508c9309p-61},
                                   {0x1.2e4051d9df308p-4, 0x1.995a23db6b8d4p-58},
                                   {0x1.6c266f6edfc1ep-4, 0x1.f0066ff5b8be7p-59},
                                   {0x1.a37f5c4c419efp-4, 0x1.9a97709251caep-59},
                                   {0x1.d49ab3ac8b1bbp-4, 0x1.41af9789432fbp-58},
                                   {0x1p-3, 0}};

// atan(y/x) in turns for 0 <= y <= x, x > 0, neither near the ends of the exponent range. With
// c = i/8 next to y/x: atan(y/x) = atan(c) + atan(t), t = (y - c x)/(x + c y), |t| <= 1/16.
// Relative error < 2^-60: the series from the second term on is below 2^-9.5 of t.
Word turn_in_octant(Word y, Word x) {
  const int i = static_cast<int>(round_down(8 * (y.hi / x.hi) + 0.5));
  const double c = 0.125 * i;
  const Word t = (y - x * c) / (x + y * c);
  const double z = t.hi * t.hi;
  double series = -1. / 15;
  for (const double term : {1. / 13, -1. / 11, 1. / 9, -1. / 7, 1. / 5, -1. / 3}) {
    series = fused_multiply_add(series, z, term);
  }
  const Word angle = quick_two_sum(t.hi, fused_multiply_add(t.hi * z, series, t.lo));
  return kTurnOfEighths[i] + angle * kTurnsPerRadian;
}

// The angle of (x, y) in [0, 1/2] turns for y >= 0, under the precondition above.
Word turn_in_half_plane(Word y, Word x) {
  const bool behind = x.hi < 0;
  const Word side = behind ? -x : x;
  const Word octant = y.hi <= side.hi ? turn_in_octant(y, side) : -turn_in_octant(side, y) + 0.25;
  return behind ? -octant + 0.5 : octant;
}

struct Parts {
  double significand;  // in [1, 2)
  int exponent;
};

Parts parts_of(double positive) {
  if (positive < 0x1p-1022) {
    const Parts larger_parts = parts_of(positive * 0x1p54);
    return {larger_parts.significand, larger_parts.exponent - 54};
  }
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(positive);
  return {std::bit_cast<double>((bits & 0x000fffffffffffffULL) | 0x3ff0000000000000ULL),
          static_cast<int>(bits >> 52) - 1023};
}

// value * 2^exponent for exponent <= 64 and value between 2^-8 and 2^10, rounded at most once.
double scaled_by_power_of_two(double value, int exponent) {
  if (exponent < -1100) return 0;
  const int first = exponent < -900 ? exponent + 900 : exponent;
  const double part = value * std::bit_cast<double>(static_cast<std::uint64_t>(first + 1023) << 52);
  return exponent < -900 ? part * 0x1p-900 : part;
}

// The angle of (x, y) for y >= 0, in units of which a turn has `per_turn`. Where one coordinate is
// 2^64 times the other the arc is its chord, which also keeps subnormal results to one rounding.
double angle_in_half_plane(double y, double x, double per_turn) {
  const double side = absolute(x);
  if (y == 0) return ScalarTraits<double>::sign_bit(x) ? 0.5 * per_turn : 0;
  if (side == 0) return 0.25 * per_turn;
  if (y == infinity<double>() && side == y) return (x < 0 ? 0.375 : 0.125) * per_turn;
  if (y == infinity<double>()) return 0.25 * per_turn;
  if (side == infinity<double>()) return x < 0 ? 0.5 * per_turn : 0;
  const Parts up = parts_of(y), along = parts_of(side);
  const int difference = up.exponent - along.exponent;
  if (difference > 64) return 0.25 * per_turn;
  if (difference < -64) {
    if (x < 0) return 0.5 * per_turn;
    const Word slope = Word{up.significand, 0} / Word{along.significand, 0};
    return scaled_by_power_of_two((slope * kTurnsPerRadian * per_turn).hi, difference);
  }
  const Word height{scaled_by_power_of_two(up.significand, difference), 0};
  const Word width{x < 0 ? -along.significand : along.significand, 0};
  return (turn_in_half_plane(height, width) * per_turn).hi;
}

double with_sign_of(double argument, double value) {
  return ScalarTraits<double>::sign_bit(argument) ? -value : value;
}

// sqrt(1 - x^2) for |x| < 1, without cancellation.
Word other_leg(double x) {
  return square_root(two_sum(1.0, -x) * two_sum(1.0, x));
}

double acos_in(double x, double per_turn) {
  if (!(absolute(x) <= 1)) return kNaN;
  if (absolute(x) == 1) return x < 0 ? 0.5 * per_turn : 0;
  return (turn_in_half_plane(other_leg(x), {x, 0}) * per_turn).hi;
}

}  // namespace

double asin_deg(double x) {
  const double size = absolute(x);
  if (!(size <= 1)) return kNaN;
  if (size == 1) return with_sign_of(x, 90);
  // Below 2^-32 the arc is its sine to within 2^-65.
  if (size < 0x1p-32) return with_sign_of(x, angle_in_half_plane(size, 1, 360));
  return with_sign_of(x, (turn_in_half_plane({size, 0}, other_leg(size)) * 360.0).hi);
}

double acos_deg(double x) {
  return acos_in(x, 360);
}

double atan2_deg(double y, double x) {
  if (is_nan(x) || is_nan(y)) return kNaN;
  const double angle = with_sign_of(y, angle_in_half_plane(absolute(y), x, 360));
  return angle == -180 ? 180 : angle;
}

double acos_turns(double x) {
  return acos_in(x, 1);
}

double atan2_turns(double y, double x) {
  if (is_nan(x) || is_nan(y)) return kNaN;
  return with_sign_of(y, angle_in_half_plane(absolute(y), x, 1));
}

float acos_turns(float x) {
  return static_cast<float>(acos_turns(static_cast<double>(x)));
}
float atan2_turns(float y, float x) {
  return static_cast<float>(atan2_turns(static_cast<double>(y), static_cast<double>(x)));
}

}  // namespace alhazen

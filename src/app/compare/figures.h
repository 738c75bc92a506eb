// app/compare: the errors of one plane of numbers against another, in figures.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "app/compare/tolerance.h"

namespace alhazen {

// Column and row of the compared planes, from the upper left; windows are added where it is told.
struct PixelPlace {
  int column{}, row{};
  friend bool operator==(const PixelPlace&, const PixelPlace&) = default;
};

// Pairs of values that are not two numbers.
enum class OddPair { nan_in_a, nan_in_b, nan_in_both, unequal_infinity, equal_infinity };
inline constexpr std::size_t kOddPairs = 5;

struct OddCount {
  std::uint64_t count = 0;
  PixelPlace first;  // in the order of rows; of meaning when count > 0
};

struct LargestError {
  double error = 0.0;
  PixelPlace place;  // the first with this error
  double a = 0.0, b = 0.0;
};

// Of a in A against b in B, the reference; mean is over the pairs that have a difference: two
// numbers, or the same infinity, whose difference is 0. Without any, the means are NaN.
struct Figures {
  std::uint64_t pairs = 0;     // all, odd ones too
  std::uint64_t compared = 0;  // those in the means
  double mse = 0.0;            // mean of (a - b)^2
  double rmse = 0.0;           // its square root
  double relative_mse = 0.0;   // mean of (a - b)^2 / (b^2 + kRelativeEpsilon)
  double mae = 0.0;            // mean of |a - b|
  double psnr = 0.0;           // 10 log10(peak^2 / mse) dB; infinite when mse is 0
  LargestError largest;        // of |a - b|
  std::uint64_t over = 0;      // pairs over the tolerance, odd ones that differ too
  std::array<OddCount, kOddPairs> odd;

  const OddCount& odd_count(OddPair kind) const { return odd[static_cast<std::size_t>(kind)]; }
};

// Keeps dark pixels from ruling the relative error: Rousselle, Knaus and Zwicker, "Adaptive
// Sampling and Reconstruction using Greedy Error Minimization", 2011, and most papers on denoising
// since.
inline constexpr double kRelativeEpsilon = 0.01;

// What the figures are made of, so that those of several channels can be made of their sums.
class FigureSums {
 public:
  // `width` samples a row. Precondition: the planes have the same size.
  FigureSums(std::span<const float> a, std::span<const float> b, int width,
             const Tolerance& tolerance);

  // Leaves the counts only: of ids, which are names, no mean says anything.
  void drop_means();
  // Takes another channel of the same picture in.
  void add(const FigureSums& other);
  // `peak`: the largest value that a signal has, for the PSNR.
  Figures figures(double peak) const;

 private:
  void add_pair(double a, double b, PixelPlace place);

  Figures counts_;  // everything that is not a mean
  double squares_ = 0.0, relative_squares_ = 0.0, absolutes_ = 0.0;
};

}  // namespace alhazen

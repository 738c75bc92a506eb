// tests: the worst error that a sweep has met, printed beside its bound.
#pragma once

#include <cstdio>
#include <gtest/gtest.h>
#include <string>

#include "core/math/scalar.h"

namespace alhazen::test {

// Collects errors; when it goes out of scope it prints the worst one and demands the bound.
class Worst {
 public:
  Worst(std::string what, double bound, const char* unit = "")
      : what_(std::move(what)), unit_(unit), bound_(bound) {}
  Worst(const Worst&) = delete;
  Worst& operator=(const Worst&) = delete;
  ~Worst() {
    std::printf("    %-58s worst %.3g %s (bound %.3g)\n", what_.c_str(), worst_, unit_, bound_);
    EXPECT_GT(count_, 0) << what_;
    EXPECT_LE(worst_, bound_) << what_;
  }

  void add(double error) {
    ++count_;
    if (!(error <= worst_)) worst_ = error;  // a NaN stays and fails
  }
  // |a - b| in units of rounding (2^-53 for double) relative to b.
  template <class Real>
  void add_relative(Real a, Real b) {
    const Real error = absolute(a - b) / absolute(b);
    add(a == b ? 0 : static_cast<double>(error) / static_cast<double>(0x1p-53));
  }

 private:
  std::string what_;
  const char* unit_;
  double bound_, worst_ = 0;
  int count_ = 0;
};

// Gauss and Legendre's rule with 16 points on each of `pieces` equal parts of [low, high].
template <class Integrand>
double integral(double low, double high, int pieces, Integrand integrand) {
  static constexpr double kNode[8] = {
      0.0950125098376374402, 0.2816035507792589132, 0.4580167776572273863, 0.6178762444026437484,
      0.7554044083550030339, 0.8656312023878317439, 0.9445750230732325761, 0.9894009349916499326};
  static constexpr double kWeight[8] = {
      0.1894506104550684963, 0.1826034150449235889, 0.1691565193950025382, 0.1495959888165767321,
      0.1246289712555338720, 0.0951585116824927848, 0.0622535239386478929, 0.0271524594117540949};
  double sum = 0;
  const double half = (high - low) / pieces / 2;
  for (int piece = 0; piece < pieces; ++piece) {
    const double middle = low + (2 * piece + 1) * half;
    for (int i = 0; i < 8; ++i) {
      sum += half * kWeight[i] *
             (integrand(middle - half * kNode[i]) + integrand(middle + half * kNode[i]));
    }
  }
  return sum;
}

}  // namespace alhazen::test

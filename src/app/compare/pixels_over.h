// app/compare: which pixels are over a tolerance, one by one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/compare/figures.h"
#include "app/compare/tolerance.h"

namespace alhazen {

// One channel of both pictures, row by row.
struct PlanePair {
  std::span<const float> a, b;
  bool ids = false;  // values are names: no tolerance lets one pass for another
};

struct PixelOver {
  PixelPlace place;
  int channels = 0;            // how many are over
  double largest_error = 0.0;  // |a - b| of those; infinite when one is not a number
};

struct PixelsOver {
  std::uint64_t samples = 0;      // values compared: pixels times channels
  std::uint64_t over = 0;         // of them
  std::vector<PixelOver> pixels;  // that have at least one, in the order of rows
};

// B is the reference. Precondition: all planes have the same size, `width` samples a row.
PixelsOver pixels_over(std::span<const PlanePair> channels, int width, const Tolerance& tolerance);

}  // namespace alhazen

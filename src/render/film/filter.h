// render/film: the reconstruction filter of the picture, by importance sampling: each pixel draws
// its own samples with the density of the filter's absolute value (M. Ernst, M. Stamminger,
// G. Greiner, "Filter Importance Sampling", 2006), so that no sample is shared between pixels and
// pieces of a picture can be made anywhere.
#pragma once

#include "core/scene/settings.h"
#include "render/film/filter_profile.h"

namespace alhazen::render {

constexpr double usual_radius(FilterKind kind) {
  switch (kind) {
    case FilterKind::box:
      return 0.5;
    case FilterKind::tent:
      return 1;
    case FilterKind::gaussian:
      return 1.5;
    case FilterKind::mitchell:
      break;
  }
  return 2;
}

// Where to sample, from the pixel's centre in pixels, and the filter's sign there. In double for
// every precision of rendering, so that pictures of different precisions share their samples.
struct FilterSample {
  double x = 0, y = 0;
  bool negative = false;
};

class Filter {
 public:
  explicit Filter(const ReconstructionFilter& filter) : profile_(filter.kind, filter.radius) {}

  // Of integral 1 over the plane.
  double value(double x, double y) const { return profile_.value(x) * profile_.value(y); }

  // (u, v) in [0, 1]^2.
  FilterSample sample(double u, double v) const {
    const double x = profile_.quantile(u), y = profile_.quantile(v);
    return {x, y, profile_.is_negative(x) != profile_.is_negative(y)};
  }

  // A+ and A-: the integrals of the positive part and of minus the negative part; A+ - A- = 1.
  double positive_integral() const {
    const double p = profile_.positive_integral(), n = profile_.negative_integral();
    return p * p + n * n;
  }
  double negative_integral() const {
    return 2 * profile_.positive_integral() * profile_.negative_integral();
  }

 private:
  FilterProfile profile_;
};

}  // namespace alhazen::render

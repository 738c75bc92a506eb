#include "app/compare/flip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/compare/flip_color.h"
#include "app/compare/flip_view.h"

namespace alhazen {
namespace {

// The paper's constants.
constexpr double kColorExponent = 0.7;    // q_c
constexpr double kFeatureExponent = 0.5;  // q_f
constexpr double kBendIn = 0.4;           // p_c: below this share of the largest difference ...
constexpr double kBendOut = 0.95;         // p_t: ... errors take this share of the scale

Rgbd adjusted(Rgbd light) {
  return hunt_adjusted(lab_of_xyz(xyz_of_light(light)));
}

// Green and blue are as far apart as two colours of a display can be.
double largest_color_difference() {
  return std::pow(hyab(adjusted({0, 1, 0}), adjusted({0, 0, 1})), kColorExponent);
}

}  // namespace

double flip_color_error(Rgbd a, Rgbd b) {
  static const double kLargest = largest_color_difference();
  const double difference = std::pow(hyab(a, b), kColorExponent);
  const double bend = kBendIn * kLargest;
  if (difference < bend) return kBendOut / bend * difference;
  return std::min(1.0, kBendOut + (difference - bend) / (kLargest - bend) * (1.0 - kBendOut));
}

double flip_feature_error(double edges, double points) {
  const double largest = std::max(std::fabs(edges), std::fabs(points));
  return std::min(1.0, std::pow(largest / std::numbers::sqrt2, kFeatureExponent));
}

double flip_error(double color_error, double feature_error) {
  return std::pow(color_error, 1.0 - feature_error);
}

FlipResult flip(const render::FloatBuffer& a, const render::FloatBuffer& b,
                double pixels_per_degree) {
  FlipView view_a(a, pixels_per_degree), view_b(b, pixels_per_degree);
  FlipResult result{render::FloatBuffer(a.width(), a.height(), {"FLIP.E"}), 0.0, {}};
  double sum = 0.0;
  for (int y = 0; y < a.height(); ++y) {
    const FlipView::Row p = view_a.row(y), q = view_b.row(y);
    for (int x = 0; x < a.width(); ++x) {
      const auto i = static_cast<std::size_t>(x);
      const double error =
          flip_error(flip_color_error(p.colors[i], q.colors[i]),
                     flip_feature_error(p.edges[i] - q.edges[i], p.points[i] - q.points[i]));
      result.errors.at(0, x, y) = static_cast<float>(error);
      sum += error;
      if (error > result.largest.error) result.largest = {error, {x, y}};
    }
  }
  result.mean = sum / static_cast<double>(a.pixel_count());
  return result;
}

}  // namespace alhazen

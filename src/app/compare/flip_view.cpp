#include "app/compare/flip_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/compare/flip_color.h"

namespace alhazen {
namespace {

render::FloatBuffer opponent_colors(const render::FloatBuffer& light) {
  render::FloatBuffer result(light.width(), light.height(), {"Yy", "Cx", "Cz"});
  for (std::size_t i = 0; i < light.pixel_count(); ++i) {
    const Rgbd color(light.channel(0)[i], light.channel(1)[i], light.channel(2)[i]);
    const Rgbd ycxcz = ycxcz_of_xyz(xyz_of_light(color));
    result.channel(0)[i] = static_cast<float>(ycxcz.r);
    result.channel(1)[i] = static_cast<float>(ycxcz.g);
    result.channel(2)[i] = static_cast<float>(ycxcz.b);
  }
  return result;
}

// Sums of filters that blur can lie a little outside of what a display shows.
Rgbd displayable(Rgbd light) {
  const auto in_range = [](double value) { return std::clamp(value, 0.0, 1.0); };
  return {in_range(light.r), in_range(light.g), in_range(light.b)};
}

}  // namespace

FlipView::FlipView(const render::FloatBuffer& light, double pixels_per_degree)
    : opponent_(opponent_colors(light)),
      sensitivity_(sensitivity_kernels(pixels_per_degree)),
      features_(feature_kernels(pixels_per_degree)),
      blur_(light.width(), sensitivity_.radius),
      detector_(light.width(), features_.radius) {}

PlaneView FlipView::plane(std::size_t channel) const {
  return {opponent_.channel(channel), opponent_.width(), opponent_.height()};
}

FlipView::Row FlipView::row(int y) {
  Row row;
  row.colors = blurred_colors(y);
  find_features(y, row);
  return row;
}

std::vector<Rgbd> FlipView::blurred_colors(int y) {
  const auto width = static_cast<std::size_t>(opponent_.width());
  std::array<std::vector<double>, 3> channels;
  for (std::size_t c = 0; c < 3; ++c) {
    channels[c].assign(width, 0.0);
    for (const auto& [weight, kernel] : sensitivity_.channels[c]) {
      blur_.down(plane(c), y, kernel);
      blur_.add_across(kernel, weight, channels[c]);
    }
  }
  std::vector<Rgbd> colors(width);
  for (std::size_t x = 0; x < width; ++x) {
    const Rgbd ycxcz(channels[0][x], channels[1][x], channels[2][x]);
    const Rgbd light = displayable(light_of_xyz(xyz_of_ycxcz(ycxcz)));
    colors[x] = hunt_adjusted(lab_of_xyz(xyz_of_light(light)));
  }
  return colors;
}

void FlipView::find_features(int y, Row& row) {
  const auto width = static_cast<std::size_t>(opponent_.width());
  // Derivatives of Y_y; 1/116 of it is that of the luminance, which goes from 0 to 1.
  constexpr double kOfLuminance = 1.0 / 116.0;
  std::vector<double> edge_x(width), edge_y(width), point_x(width), point_y(width);
  detector_.down(plane(0), y, features_.smooth);
  detector_.add_across(features_.first, kOfLuminance, edge_x);
  detector_.add_across(features_.second, kOfLuminance, point_x);
  detector_.down(plane(0), y, features_.first);
  detector_.add_across(features_.smooth, kOfLuminance, edge_y);
  detector_.down(plane(0), y, features_.second);
  detector_.add_across(features_.smooth, kOfLuminance, point_y);
  row.edges.resize(width);
  row.points.resize(width);
  for (std::size_t x = 0; x < width; ++x) {
    row.edges[x] = std::hypot(edge_x[x], edge_y[x]);
    row.points[x] = std::hypot(point_x[x], point_y[x]);
  }
}

}  // namespace alhazen

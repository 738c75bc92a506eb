// app/compare: one picture as FLIP's model of the eye takes it in, row by row.
#pragma once

#include <vector>

#include "app/compare/flip_kernels.h"
#include "app/compare/row_filter.h"
#include "core/math/vec.h"
#include "render/image/pixel_buffer.h"

namespace alhazen {

class FlipView {
 public:
  // `light`: channels R, G, B, linear Rec.709 in 0 .. 1.
  FlipView(const render::FloatBuffer& light, double pixels_per_degree);

  // One row: the colours after the eye's blur as Hunt-adjusted L*, a*, b*, and the strengths of
  // edges and of points in the luminance, 0 .. sqrt(2).
  struct Row {
    std::vector<Rgbd> colors;
    std::vector<double> edges, points;
  };
  Row row(int y);

 private:
  PlaneView plane(std::size_t channel) const;
  std::vector<Rgbd> blurred_colors(int y);
  void find_features(int y, Row& row);

  render::FloatBuffer opponent_;  // Y_y, C_x, C_z
  SensitivityKernels sensitivity_;
  FeatureKernels features_;
  RowFilter blur_, detector_;
};

}  // namespace alhazen

#include "app/compare/row_filter.h"

#include <cmath>
#include <gtest/gtest.h>

namespace alhazen {
namespace {

// 3 x 4 samples: 10 for each row, 1 for each column.
const std::vector<float> kRamp{0, 1, 2, 10, 11, 12, 20, 21, 22, 30, 31, 32};

std::vector<double> filtered(int row, const Kernel& down, const Kernel& across,
                             double weight = 1.0) {
  RowFilter filter(3, static_cast<int>(down.size() / 2));
  filter.down({kRamp, 3, 4}, row, down);
  std::vector<double> sums(3, 0.5);
  filter.add_across(across, weight, sums);
  return sums;
}

TEST(RowFilter, WeightsOfOneOffsetMoveThePicture) {
  const Kernel stay{0, 1, 0}, next{0, 0, 1}, previous{1, 0, 0};
  EXPECT_EQ(filtered(1, stay, stay), (std::vector<double>{10.5, 11.5, 12.5}));
  EXPECT_EQ(filtered(1, next, stay), (std::vector<double>{20.5, 21.5, 22.5}));
  EXPECT_EQ(filtered(2, stay, previous), (std::vector<double>{20.5, 20.5, 21.5}));
  EXPECT_EQ(filtered(2, stay, next, 2.0), (std::vector<double>{42.5, 44.5, 44.5}));
}

TEST(RowFilter, OutermostPixelsGoOnBeyondTheEdges) {
  const Kernel far{1, 0, 0, 0, 0, 0, 0, 0, 0}, stay{0, 0, 0, 0, 1, 0, 0, 0, 0};
  Kernel other_far(9, 0.0);
  other_far[8] = 1.0;
  EXPECT_EQ(filtered(1, far, stay), (std::vector<double>{0.5, 1.5, 2.5}));
  EXPECT_EQ(filtered(1, other_far, stay), (std::vector<double>{30.5, 31.5, 32.5}));
  EXPECT_EQ(filtered(1, stay, far), (std::vector<double>{10.5, 10.5, 10.5}));
  EXPECT_EQ(filtered(1, stay, other_far), (std::vector<double>{12.5, 12.5, 12.5}));
}

TEST(RowFilter, GaussianKernelFallsByItsSigma) {
  const Kernel kernel = gaussian_kernel(1.5, 5);
  ASSERT_EQ(kernel.size(), 11u);
  EXPECT_NEAR(kernel[5 + 3] / kernel[5], std::exp(-2.0), 1e-15);  // two sigmas
  EXPECT_EQ(kernel[5 - 3], kernel[5 + 3]);
}

}  // namespace
}  // namespace alhazen

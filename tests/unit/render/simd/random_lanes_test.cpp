// Random numbers drawn for lanes are those drawn one by one.
#include <gtest/gtest.h>

#include "core/math/random.h"
#include "render/simd/lanes.h"

namespace alhazen::render {
namespace {

template <int W>
void expect_same_samples() {
  using Seeds = Lanes<std::uint64_t, W>;
  using Indices = Lanes<std::uint32_t, W>;
  for (std::uint64_t start = 0; start < 2000; ++start) {
    Seeds seed;
    Indices index;
    for (int i = 0; i < W; ++i) {
      const std::uint64_t name = W * start + static_cast<std::uint64_t>(i);
      seed.set(i, mix_64(5, name));
      index.set(i, static_cast<std::uint32_t>(start % 3 == 0 ? mix_64(6, name) : name));
    }
    const Seeds light = mix_64(seed, 16);
    const Sample2dOf<Indices> drawn = sample_2d(light, index);
    const auto x = unit_real<Lanes<double, W>>(drawn.x);
    const auto y = unit_real<Lanes<float, W>>(drawn.y);
    for (int i = 0; i < W; ++i) {
      ASSERT_EQ(light[i], mix_64(seed[i], 16));
      const Sample2d one = sample_2d(light[i], index[i]);
      ASSERT_EQ(drawn.x[i], one.x);
      ASSERT_EQ(drawn.y[i], one.y);
      ASSERT_EQ(x[i], unit_real<double>(one.x));
      ASSERT_EQ(y[i], unit_real<float>(one.y));
    }
  }
}

TEST(RandomLanes, DrawWhatSingleNumbersDraw) {
  expect_same_samples<1>();
  expect_same_samples<2>();
  expect_same_samples<4>();
  expect_same_samples<8>();
  expect_same_samples<16>();
}

}  // namespace
}  // namespace alhazen::render

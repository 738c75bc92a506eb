// J1 to J3: what the average of many samples is; and I3: the machine's state of rounding.
#include <cfenv>
#include <fmt/format.h>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include "hard/relations/pictures.h"
#include "support/scene_builder.h"

namespace alhazen::hard {
namespace {

using testing::SceneBuilder;

// The state that threads of the renderer start with is that of the thread that starts them.
TEST(Hard, I3_RoundingMode) {
  const auto faults = [] {
    double count = std::fegetround() == FE_TONEAREST ? 0 : 1;
#if defined(__SSE__)
    constexpr unsigned kFlushToZero = 1u << 15, kDenormalsAreZero = 1u << 6, kRounding = 3u << 13;
    count += (_mm_getcsr() & (kFlushToZero | kDenormalsAreZero | kRounding)) == 0 ? 0 : 1;
#endif
    volatile double smallest = 0x1p-1074;  // of all that are not 0
    volatile double half = 0x1p-1022 * 0.5;
    return count + (smallest * 1 > 0 ? 0 : 1) + (half > 0 ? 0 : 1);
  };
  double in_render = 0;
  SceneBuilder b;
  const Result<render::RenderOutput> output = render::render(
      b.scene, {}, {.threads = 2}, [&](std::uint64_t, std::uint64_t) { in_render += faults(); });
  EXPECT_TRUE(output);
  figure("I3", "double", "faults of the rounding mode at the start", faults(), 0);
  figure("I3", "double", "faults of the rounding mode in the renderer's threads", in_render, 0);
}

// A picture of nothing but a constant: its mean may be off by the roundings of the sum, not by a
// float's.
TEST(Hard, J1_ConstantScene) {
  double worst = 0;
  for (int samples = 1; samples <= 65536; samples *= 4) {
    SceneBuilder b;
    b.background(0.1);
    b.scene.settings.width = b.scene.settings.height = 2;
    b.scene.settings.samples = samples;
    for (const double value : picture_of(b.scene).rgb) {
      worst = std::max(worst, std::abs(value - 0.1) / 0.1 * 0x1p24);
    }
  }
  figure("J1", "double", "error of 0.1, 1 .. 65536 samples", worst, 1, "times 2^-24");
}

// A glowing half-plane whose edge crosses one pixel; `covered` of it is light. A line cuts at most
// 2 sqrt(N) of N strata, so stratified points are off by less than their share, 2 / sqrt(N).
SceneBuilder half_plane(double slope, double shift, int samples, std::uint64_t seed) {
  SceneBuilder b;
  const MaterialId light = b.material(Black{}, Rgbd(1));
  // The pixel is [-1/2, 1/2]^2 at z = 1; light is where y < slope x + shift.
  b.add(Quad4{{-8, -8 * slope + shift - 16, 1}, {16, 16 * slope, 0}, {0, 16, 0}}, light);
  b.scene.settings.width = b.scene.settings.height = 1;
  b.scene.settings.samples = samples;
  b.scene.settings.seed = seed;
  b.scene.camera.frame = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  b.scene.camera.projection = OrthographicCamera{1};
  return b;
}

TEST(Hard, J2_EdgeCoverage) {
  const double slope = 0.375, shift = 0.0625;
  const double covered = 0.5 + shift;  // the edge leaves the pixel on its left and its right
  double worst = 0;
  for (const int samples : {16, 64, 256, 1024, 4096}) {
    for (std::uint64_t seed = 0; seed < 16; ++seed) {
      const double f = picture_of(half_plane(slope, shift, samples, seed).scene).rgb[0];
      worst = std::max(worst, std::abs(f - covered) * std::sqrt(samples));
    }
  }
  figure("J2", "double", "largest error of the coverage times sqrt(N), N = 16 .. 4096", worst, 2);

  // Unbiased: the mean of many seeds, in its own standard errors (z-test).
  const std::size_t seeds = rays(512);
  double sum = 0, squares = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const double error = picture_of(half_plane(slope, shift, 16, seed).scene).rgb[0] - covered;
    sum += error;
    squares += error * error;
  }
  const double n = static_cast<double>(seeds);
  const double z = std::abs(sum / n) / std::sqrt((squares - sum * sum / n) / (n - 1) / n);
  // 4 standard errors are left by chance in one of 16000 runs; the seeds are fixed.
  figure("J2", "double", fmt::format("bias over {} seeds", seeds), z, 4, "standard errors");
}

// A glowing ball of a tenth of a pixel and a bar of a twentieth, in the middle of pixels and across
// them: what adaptive sampling sees of them.
TEST(Hard, J3_AdaptiveSamplingAndSmallThings) {
  SceneBuilder b;
  const MaterialId light = b.material(Black{}, Rgbd(1));
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      b.add(Sphere{{-3.5 + x + 0.09 * y - 0.3, -3.5 + y + 0.07 * x - 0.25, 2}, 0.1}, light);
    }
  }
  b.add(Quad4{{-4, 0.31, 1}, {8, 0.5, 0}, {0, 0.05, 0}}, light);
  b.scene.settings.width = b.scene.settings.height = 8;
  b.scene.camera.frame = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  b.scene.camera.projection = OrthographicCamera{8};
  b.scene.settings.samples = 4096;
  const Picture reference = picture_of(b.scene);
  b.scene.settings.samples = 1024;
  b.scene.settings.adaptive = AdaptiveSampling{0.01, 16};
  const Picture adaptive = picture_of(b.scene, {.aovs = {.samples = true}});
  double energy = 0, found = 0, missed = 0, lit = 0, taken = 0;
  for (std::size_t p = 0; p < reference.rgb.size() / 3; ++p) {
    energy += reference.rgb[3 * p];
    found += adaptive.rgb[3 * p];
    taken += static_cast<double>(adaptive.samples[p]);
    if (reference.rgb[3 * p] == 0) continue;
    ++lit;
    missed += adaptive.rgb[3 * p] == 0 ? 1 : 0;
  }
  // 16 samples see a ball of a share pi / 100 of the pixel with the chance 1 - (1 - pi/100)^16 =
  // 0.40 when they are independent, and a pixel in which the first 16 agree is not looked at again.
  // Each miss loses a ball's light: the mean loss is what the misses are, no more.
  figure("J3", "double",
         fmt::format("missed of {} lit pixels, {:.0f} samples a pixel", lit, taken / 64),
         missed / lit, 0.6, "share");
  figure("J3", "double", "total light that is not found", std::abs(found - energy) / energy,
         missed / lit, "share");
}

}  // namespace
}  // namespace alhazen::hard

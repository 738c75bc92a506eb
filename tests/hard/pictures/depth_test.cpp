// tests/hard/pictures: D4 and D5, deep recursion: what it needs, and what cutting it short costs.
#include <functional>
#include <pthread.h>

#include "hard/pictures/support.h"

namespace alhazen::hard {
namespace {

// Runs `work` on a stack of `bytes`.
void on_stack(std::size_t bytes, std::function<void()> work) {
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, bytes), 0);
  pthread_t thread;
  const auto call = [](void* argument) -> void* {
    (*static_cast<std::function<void()>*>(argument))();
    return nullptr;
  };
  ASSERT_EQ(pthread_create(&thread, &attributes, call, &work), 0);
  EXPECT_EQ(pthread_join(thread, nullptr), 0);
  pthread_attr_destroy(&attributes);
}

// One thread, which is the caller's: the stack is the one given.
render::RenderOutput rendered_here(const SceneBuilder& b, Precision p) {
  render::RenderOptions options;
  options.precision = p;
  options.threads = 1;
  return rendered(b.scene, options);
}

constexpr std::size_t kStack = 256 << 10;  // a thirty-second of the usual 8 MiB

TEST(Hard, D4_DepthOfAHundredThousand) {
  for (const Precision p : kScalars) {
    on_stack(kStack, [p] {
      SceneBuilder b;
      b.add(Sphere{{0, 0, 0}, 1}, b.material(Mirror{b.color(Rgbd(1))}, Rgbd(1)));
      b.scene.settings.max_depth = 100000;
      set_size(b, 2);
      b.look({0.1, 0.2, 0.3}, {0, 0, 1}, {0, 1, 0}, 60);
      const render::RenderOutput output = rendered_here(b, p);
      double worst = 0;
      for (const double value : output.picture.rgb)
        worst = std::max(worst, std::abs(value - 100001));
      figure("D4", name_of(p), "100 000 reflections on a stack of 256 KiB: error of the sum", worst,
             0);
      figure("D4", name_of(p), "rays over those of four paths",
             static_cast<double>(output.statistics.rays()) - 4 * 100001, 0);
    });
  }
}

// A room of mirrors with three balls of glass in it: nothing gets out, every meeting splits the
// path, and only the cutoff c ends it. The weights of a path's children sum to its own at most, so
// that in each generation at most 1/c paths of a sample have a weight of c: N/c + 1 rays.
TEST(Hard, D4_GlassTree) {
  for (const Precision p : kScalars) {
    on_stack(kStack, [p] {
      SceneBuilder b;
      b.add(Box{{-3, -3, -3}, {3, 3, 3}}, b.mirror(1));
      const MaterialId glass = b.glass(1.5);
      for (const double x : {-1.8, 0.0, 1.8})
        b.add(Sphere{{x, 0.2 * x, 1}, 0.8}, glass);
      b.scene.settings.max_depth = 1000;
      b.scene.settings.cutoff = 1.0 / 64;
      set_size(b, 3);
      b.look({0, 0, -2}, {0, 0, 1}, {0, 1, 0}, 60);
      const render::RenderOutput output = rendered_here(b, p);
      figure("D4", name_of(p), "glass in a room of mirrors, cutoff 1/64, depth 1000: rays a sample",
             static_cast<double>(output.statistics.rays()) / 9, 1000 * 64 + 1);
    });
  }
}

// Without a cutoff: the whole binary tree, 2^(N+1) - 1 rays at most.
TEST(Hard, D4_WholeTree) {
  SceneBuilder b;
  b.background(1);
  const MaterialId glass = b.glass(1.5);
  for (int i = 0; i < 6; ++i)
    b.add(Box{{-9, -9, double(i)}, {9, 9, i + 0.5}}, glass);
  b.scene.settings.max_depth = 14;
  set_size(b, 1);
  b.look({0, 0, -2}, {0, 0, 1}, {0, 1, 0}, 1);
  figure("D4", "double", "panes of glass, depth 14, no cutoff: rays",
         static_cast<double>(rendered_here(b, Precision::float64).statistics.rays()),
         (1 << 15) - 1);
}

// The sky is 1 at most and no surface adds light, so what a path of weight w would have brought is
// w at most: the picture with a cutoff differs from the one without by the weights dropped.
TEST(Hard, D5_CutoffIsBounded) {
  const auto scene = [](double cutoff) {
    SceneBuilder b;
    b.scene.background.source = GradientBackground{{{-1, Rgbd(0.1)}, {1, Rgbd(1)}}};
    b.add(Box{{-9, -2, -9}, {9, -1, 9}}, b.mirror(0.8));
    b.add(Sphere{{-0.9, 0, 0.5}, 1}, b.glass(1.5));
    b.add(Sphere{{1.2, 0, 0}, 1}, b.glass(1.7, Rgbd(0.1)));
    b.scene.settings.max_depth = 12;
    b.scene.settings.cutoff = cutoff;
    set_size(b, side_for(20));
    b.look({0, 0.5, -5}, {0, 0, 1}, {0, 1, 0}, 50);
    return b.scene;
  };
  for (const Precision p : kScalars) {
    const std::vector<double> whole = pixels(scene(0), p);
    int beyond = 0;
    double closest = 0, largest = 0;
    for (const double cutoff : {1e-4, 1e-3, 1e-2, 1e-1}) {
      const Scene cut = scene(cutoff);
      const int side = cut.settings.width;
      for (int i = 0; i < side * side; ++i) {
        // One pixel at a time, since that is what the figure of dropped weights is then of.
        render::RenderOptions options;
        options.precision = p;
        options.threads = 1;
        options.crop = {i % side, i / side, 1, 1};
        const render::RenderOutput output = rendered(cut, options);
        const double dropped = output.statistics.dropped_weight_max;
        const double error =
            std::abs(output.picture.rgb[0] - whole[3 * static_cast<std::size_t>(i)]);
        largest = std::max(largest, error);
        // The two sums are rounded: at most 2^12 terms that sum to 1 at most.
        const double rounding = 4096 * eps_of(p);
        beyond += !(error <= dropped + rounding);
        if (dropped > 0) closest = std::max(closest, error / dropped);
      }
    }
    EXPECT_GT(largest, 0.01);  // or nothing was cut
    figure("D5", name_of(p), "pixels off by more than the dropped weights", beyond, 0);
    figure("D5", name_of(p), "largest share of the bound that was used", closest, 1);
  }
}

}  // namespace
}  // namespace alhazen::hard

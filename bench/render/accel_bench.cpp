// How fast rays find shapes, by the tree and by the loop over all, and how long the tree takes to
// build. Balls at random in a cube, as in scenes/perf/spheres.scn; rays from in front of it
// (Camera) and from everywhere to everywhere (Random), at 1 ray per iteration.
#include <benchmark/benchmark.h>
#include <cmath>
#include <vector>

#include "core/base/hash.h"
#include "render/accel/closest_hit.h"
#include "render/accel/shape_tree.h"

namespace alhazen::render {
namespace {

constexpr std::size_t kRays = 1 << 14;

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(mix_64(seed)) {}
  double next() {  // in [-1, 1)
    state_ = mix_64(state_, 1);
    return static_cast<double>(state_ >> 11) * 0x1p-52 - 1;
  }
  Vec3d in_cube() {
    const double x = next(), y = next();
    return {x, y, next()};
  }

 private:
  std::uint64_t state_;
};

std::vector<Shape> balls(std::int64_t count) {
  Numbers numbers(1);
  std::vector<Shape> shapes(static_cast<std::size_t>(count));
  const double radius = 0.45 / std::cbrt(static_cast<double>(count));
  for (Shape& shape : shapes)
    shape.geometry = alhazen::Sphere{numbers.in_cube(), radius};
  return shapes;
}

template <class Real>
std::vector<Ray<Real>> camera_rays() {
  std::vector<Ray<Real>> rays;
  for (std::size_t i = 0; i < kRays; ++i) {
    const double x = static_cast<double>(i % 128) / 64 - 1,
                 y = static_cast<double>(i / 128) / 64 - 1;
    rays.push_back(
        {{Real(0), Real(0), Real(-2.6)}, normalized(Vec3<Real>(Vec3d{0.45 * x, 0.45 * y, 1}))});
  }
  return rays;
}

template <class Real>
std::vector<Ray<Real>> random_rays() {
  Numbers numbers(2);
  std::vector<Ray<Real>> rays;
  for (std::size_t i = 0; i < kRays; ++i) {
    const Vec3d from = numbers.in_cube();
    rays.push_back({Vec3<Real>(from), normalized(Vec3<Real>(numbers.in_cube() - from))});
  }
  return rays;
}

template <class Finder, class Real>
void find(benchmark::State& state, const Finder& finder, const std::vector<Ray<Real>>& rays) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(closest_hit(finder, rays[i++ % kRays], Source(), infinity<Real>()));
  }
  state.SetItemsProcessed(state.iterations());
}

template <class Real>
void camera_by_tree(benchmark::State& state) {
  const ShapeTable<Real> table(balls(state.range(0)), Vec3d{});
  const ShapeTree<Real> tree(table);
  find(state, tree, camera_rays<Real>());
  state.counters["bytes_per_shape"] =
      static_cast<double>(tree.bytes()) / static_cast<double>(table.size());
}
template <class Real>
void random_by_tree(benchmark::State& state) {
  const ShapeTable<Real> table(balls(state.range(0)), Vec3d{});
  find(state, ShapeTree<Real>(table), random_rays<Real>());
}
template <class Real>
void random_by_loop(benchmark::State& state) {
  find(state, ShapeTable<Real>(balls(state.range(0)), Vec3d{}), random_rays<Real>());
}
template <class Real>
void camera_by_loop(benchmark::State& state) {
  find(state, ShapeTable<Real>(balls(state.range(0)), Vec3d{}), camera_rays<Real>());
}
void build(benchmark::State& state) {
  const ShapeTable<double> table(balls(state.range(0)), Vec3d{});
  for (auto _ : state)
    benchmark::DoNotOptimize(ShapeTree<double>(table, static_cast<int>(state.range(1))));
}

BENCHMARK(camera_by_tree<double>)->DenseRange(1, 10)->RangeMultiplier(10)->Range(100, 1000000);
BENCHMARK(camera_by_loop<double>)->DenseRange(1, 10)->RangeMultiplier(10)->Range(100, 10000);
BENCHMARK(random_by_tree<double>)->DenseRange(1, 10)->RangeMultiplier(10)->Range(100, 1000000);
BENCHMARK(random_by_loop<double>)->DenseRange(1, 10)->RangeMultiplier(10)->Range(100, 10000);
BENCHMARK(random_by_tree<float>)->Arg(10000)->Arg(1000000);
BENCHMARK(build)
    ->ArgsProduct({{1000, 10000, 100000, 1000000}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace alhazen::render

// How fast rays find shapes: one by one by the tree and by the loop over all, and in packets as
// wide as the registers; and how long the tree takes to build. Balls at random in a cube, as in
// scenes/perf/spheres.scn. Times are per ray. To see what a wider instruction set does:
// -DCMAKE_CXX_FLAGS=-march=x86-64-v4.
#include <array>
#include <benchmark/benchmark.h>
#include <cmath>
#include <type_traits>
#include <vector>

#include "core/base/hash.h"
#include "render/accel/closest_hit.h"
#include "render/accel/shape_tree_lanes.h"
#include "render/simd/wide.h"

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

// Rays with their sources, and the components of the rays for lanes.
template <class Real>
struct Rays {
  std::array<std::vector<Real>, 6> parts;
  std::vector<Source> sources;
  Real t_max = infinity<Real>();

  void add(const Ray<Real>& ray, const Source& source) {
    for (int axis = 0; axis < 3; ++axis) {
      parts[static_cast<std::size_t>(axis)].push_back(ray.origin[axis]);
      parts[static_cast<std::size_t>(axis) + 3].push_back(ray.direction[axis]);
    }
    sources.push_back(source);
  }
  std::size_t size() const { return sources.size(); }
  template <class L>
  Ray<L> lanes(std::size_t first) const {
    const auto part = [&](std::size_t k) {
      if constexpr (std::is_same_v<L, Real>) {
        return parts[k][first];
      } else {
        return L::load(&parts[k][first]);
      }
    };
    return {{part(0), part(1), part(2)}, {part(3), part(4), part(5)}};
  }
};

// From in front of the cube, in tiles of 16 x 16 pixels of a picture of 1000 x 1000.
template <class Real>
Rays<Real> camera_rays(const ShapeTree<Real>&) {
  Rays<Real> rays;
  for (std::size_t i = 0; i < kRays; ++i) {
    const std::size_t tile = i / 256, x = i % 16, y = i / 16 % 16;
    const double across = (static_cast<double>(tile % 8) + static_cast<double>(x) / 62.5) / 4 - 1;
    const double up = (static_cast<double>(tile / 8) + static_cast<double>(y) / 62.5) / 4 - 1;
    rays.add({{Real(0), Real(0), Real(-2.6)},
              normalized(Vec3<Real>(Vec3d{0.45 * across, 0.45 * up, 1}))},
             Source());
  }
  return rays;
}

// From anywhere in the cube to anywhere.
template <class Real>
Rays<Real> random_rays(const ShapeTree<Real>&) {
  Numbers numbers(2);
  Rays<Real> rays;
  for (std::size_t i = 0; i < kRays; ++i) {
    const Vec3d from = numbers.in_cube();
    rays.add({Vec3<Real>(from), normalized(Vec3<Real>(numbers.in_cube() - from))}, Source());
  }
  return rays;
}

// From what the camera sees to a lamp.
template <class Real>
Rays<Real> shadow_rays(const ShapeTree<Real>& tree) {
  const Rays<Real> seen = camera_rays(tree);
  const Vec3<Real> lamp{Real(3), Real(4), Real(-5)};
  Rays<Real> rays;
  rays.t_max = 1;
  for (std::size_t i = 0; rays.size() < kRays; i = (i + 1) % kRays) {
    const Ray<Real> ray = seen.template lanes<Real>(i);
    const auto hit = closest_hit(tree, ray, Source(), infinity<Real>());
    if (!hit) continue;
    const auto at = tree.table().plain_surface(hit->shape, ray, hit->crossing()).position;
    rays.add({at, lamp - at}, source_after(Source(), ray.direction, *hit, false));
  }
  return rays;
}

template <class Real>
using MakeRays = Rays<Real> (*)(const ShapeTree<Real>&);

template <class Real, MakeRays<Real> make_rays, bool by_tree>
void single(benchmark::State& state) {
  const ShapeTable<Real> table(balls(state.range(0)), Vec3d{});
  const ShapeTree<Real> tree(table);
  const Rays<Real> rays = make_rays(tree);
  std::size_t i = 0;
  for (auto _ : state) {
    const Ray<Real> ray = rays.template lanes<Real>(i);
    const Source& source = rays.sources[i];
    const auto ask = [&](const auto& finder) {
      if (rays.t_max < infinity<Real>()) {
        benchmark::DoNotOptimize(any_hit(finder, ray, source, rays.t_max));
      } else {
        benchmark::DoNotOptimize(closest_hit(finder, ray, source, rays.t_max));
      }
    };
    if constexpr (by_tree) {
      ask(tree);
    } else {
      ask(table);
    }
    i = (i + 1) % kRays;
  }
  state.counters["bytes_per_shape"] =
      static_cast<double>(tree.bytes()) / static_cast<double>(table.size());
}

template <class Real, MakeRays<Real> make_rays>
void packet(benchmark::State& state) {
  using L = Packet<Real>;
  using Word = ScalarOf<IntOf<L>>;
  constexpr auto kWidth = static_cast<std::size_t>(L::kWidth);
  const ShapeTable<Real> table(balls(state.range(0)), Vec3d{});
  const ShapeTree<Real> tree(table);
  const Rays<Real> rays = make_rays(tree);
  std::size_t first = 0;
  while (state.KeepRunningBatch(static_cast<benchmark::IterationCount>(kWidth))) {
    const Ray<L> ray = rays.template lanes<L>(first);
    DepartureLanes<L> from;
    for (int i = 0; i < L::kWidth; ++i) {
      const Source& source = rays.sources[first + static_cast<std::size_t>(i)];
      if (source.shape == kNoId) continue;
      from.shape.set(i, static_cast<Word>(source.shape));
      from.face.set(i, static_cast<Word>(source.face));
      from.side.set(i, static_cast<Word>(source.side));
    }
    const auto source_of = [&](int i) -> const Source& {
      return rays.sources[first + static_cast<std::size_t>(i)];
    };
    if (rays.t_max < infinity<Real>()) {
      benchmark::DoNotOptimize(
          any_hits(tree, ray, from, source_of, L(rays.t_max), IntOf<L>(-1), MaskOf<L>(true)));
    } else {
      benchmark::DoNotOptimize(
          closest_hits(tree, ray, from, source_of, L(rays.t_max), IntOf<L>(-1), MaskOf<L>(true)));
    }
    first = (first + kWidth) % kRays;
  }
}

void build(benchmark::State& state) {
  const ShapeTable<double> table(balls(state.range(0)), Vec3d{});
  for (auto _ : state)
    benchmark::DoNotOptimize(ShapeTree<double>(table, static_cast<int>(state.range(1))));
}

void counts(benchmark::internal::Benchmark* bench) {
  for (const int count : {1, 5, 10, 20, 100, 10000, 1000000})
    bench->Arg(count);
}

BENCHMARK(single<double, camera_rays<double>, false>)
    ->Name("camera/loop")
    ->RangeMultiplier(10)
    ->Range(1, 1000);
BENCHMARK(single<double, camera_rays<double>, true>)->Name("camera/single")->Apply(counts);
BENCHMARK(packet<double, camera_rays<double>>)->Name("camera/packet")->Apply(counts);
BENCHMARK(single<double, shadow_rays<double>, true>)->Name("shadow/single")->Apply(counts);
BENCHMARK(packet<double, shadow_rays<double>>)->Name("shadow/packet")->Apply(counts);
BENCHMARK(single<double, random_rays<double>, true>)->Name("random/single")->Apply(counts);
BENCHMARK(packet<double, random_rays<double>>)->Name("random/packet")->Apply(counts);
BENCHMARK(packet<float, camera_rays<float>>)->Name("camera/packet of float")->Apply(counts);
BENCHMARK(build)
    ->ArgsProduct({{1000, 10000, 100000, 1000000}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace alhazen::render

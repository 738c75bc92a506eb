// What one ray costs with one shape of each kind, alone and side by side, from the table as the
// tree asks it. `hits` says how many of the rays meet the shape.
#include <benchmark/benchmark.h>

#include "render/shape/shape_table.h"
#include "render/simd/wide.h"

namespace alhazen::render {
namespace {

constexpr int kRays = 1024;  // a multiple of every width

// The same numbers on every run.
class Dice {
 public:
  double uniform() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11) * 0x1p-52 - 1;
  }
  Vec3d in_cube(double size) { return size * Vec3d{uniform(), uniform(), uniform()}; }

 private:
  std::uint64_t state_ = 1;
};

// From one eye to points in a cube around the origin: `size` 1 is a shape's own, in 4 most miss.
std::vector<Ray<double>> rays_to(double size) {
  Dice dice;
  std::vector<Ray<double>> rays(kRays);
  for (Ray<double>& ray : rays)
    ray = {{3, 4, -9}, normalized(dice.in_cube(size) - Vec3d{3, 4, -9})};
  return rays;
}

template <class L>
Ray<L> lanes_from(const std::vector<Ray<double>>& rays, int first) {
  if constexpr (std::is_same_v<L, double>) {
    return rays[static_cast<std::size_t>(first)];
  } else {
    Ray<L> result;
    for (int i = 0; i < L::kWidth; ++i) {
      const Ray<double>& ray = rays[static_cast<std::size_t>(first + i)];
      for (int axis = 0; axis < 3; ++axis) {
        result.origin[axis].set(i, static_cast<ScalarOf<L>>(ray.origin[axis]));
        result.direction[axis].set(i, static_cast<ScalarOf<L>>(ray.direction[axis]));
      }
    }
    return result;
  }
}

int count_of(bool mask) {
  return mask ? 1 : 0;
}
template <int bytes, int width>
int count_of(LaneMask<bytes, width> mask) {
  return count(mask);
}

template <class L, template <class> class RayKind = Ray>
void meet(benchmark::State& state, const Geometry& geometry, double size) {
  constexpr int kWidth = LaneTraits<L>::kWidth;
  Shape shape;
  shape.geometry = geometry;
  const ShapeTable<ScalarOf<L>> table({shape}, Vec3d());
  std::vector<RayKind<L>> rays;
  const auto single = rays_to(size);
  for (int first = 0; first < kRays; first += kWidth)
    rays.push_back(RayKind<L>(lanes_from<L>(single, first)));
  int hits = 0;
  for (auto _ : state) {
    hits = 0;
    for (const RayKind<L>& ray : rays) {
      const CrossingPair<L> found = table.crossings(0, ray);
      benchmark::DoNotOptimize(found);
      hits += count_of(found.has_near);
    }
  }
  state.SetItemsProcessed(state.iterations() * kRays);
  state.counters["hits"] = hits;
}

void add(const char* kind, const Geometry& geometry) {
  for (const double size : {1.0, 4.0}) {
    const std::string name = std::string(kind) + (size > 1 ? "/most_miss" : "/most_hit");
    benchmark::RegisterBenchmark((name + "/single").c_str(), meet<double>, geometry, size);
    benchmark::RegisterBenchmark((name + "/lanes").c_str(), meet<Wide<double>>, geometry, size);
    benchmark::RegisterBenchmark((name + "/sheared_lanes").c_str(), meet<Wide<double>, ShearedRay>,
                                 geometry, size);
    benchmark::RegisterBenchmark((name + "/float_lanes").c_str(), meet<Wide<float>>, geometry,
                                 size);
  }
}

}  // namespace
}  // namespace alhazen::render

int main(int argc, char** argv) {
  using namespace alhazen;
  render::add("sphere", Sphere{{}, 1});
  render::add("plane", Plane{{0, 1, 0}, -1});
  render::add("box", Box{{-1, -1, -1}, {1, 1, 1}});
  render::add("triangle", Triangle{{Vec3d{-2, -1, 0}, Vec3d{2, -1, 0}, Vec3d{0, 2, 0}}, {}});
  render::add("frustum", Cone{{0, -1, 0}, {0, 1, 0}, 1, 0.5, true});
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}

// What it costs to ask a surface for one ray: Fresnel's equations, refraction and the patterns of
// textures, alone and side by side.
#include <benchmark/benchmark.h>

#include "render/simd/wide.h"
#include "render/surface/refract.h"
#include "render/surface/texture_table.h"

namespace alhazen::render {
namespace {

constexpr int kRays = 1024;  // a multiple of every width

// The same numbers in [0, 1) on every run.
class Dice {
 public:
  double uniform() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_ = 1;
};

// kRays numbers between two bounds, as many in each element as it has lanes.
template <class L>
std::vector<L> drawn(Dice& dice, double low, double high) {
  constexpr int kWidth = LaneTraits<L>::kWidth;
  std::vector<L> numbers(kRays / kWidth);
  for (L& number : numbers) {
    for (int i = 0; i < kWidth; ++i) {
      const auto value = static_cast<ScalarOf<L>>(low + (high - low) * dice.uniform());
      if constexpr (kWidth == 1) {
        number = value;
      } else {
        number.set(i, value);
      }
    }
  }
  return numbers;
}

// `ask(i)` for each of the elements.
template <class L, class Ask>
void measure(benchmark::State& state, Ask ask) {
  constexpr std::size_t kElements = kRays / LaneTraits<L>::kWidth;
  for (auto _ : state) {
    for (std::size_t i = 0; i < kElements; ++i)
      benchmark::DoNotOptimize(ask(i));
  }
  state.SetItemsProcessed(state.iterations() * kRays);
}

template <class L>
void dielectric(benchmark::State& state) {
  Dice dice;
  const auto cosines = drawn<L>(dice, 0, 1);
  measure<L>(state, [&](std::size_t i) {
    const L eta(ScalarOf<L>(1 / 1.5));
    return dielectric_interface(cosines[i], eta);
  });
}

// From inside, where about half of the directions are totally reflected.
template <class L>
void dielectric_from_inside(benchmark::State& state) {
  Dice dice;
  const auto cosines = drawn<L>(dice, 0.5, 1);
  measure<L>(state, [&](std::size_t i) {
    const L eta(ScalarOf<L>(1.5));
    return dielectric_interface(cosines[i], eta);
  });
}

template <class L>
void conductor(benchmark::State& state) {
  Dice dice;
  const auto cosines = drawn<L>(dice, 0, 1);
  measure<L>(state, [&](std::size_t i) {
    const L n(ScalarOf<L>(0.2)), k(ScalarOf<L>(3.9));
    return conductor_reflectance(cosines[i], n, k);
  });
}

template <class L>
void refraction(benchmark::State& state) {
  Dice dice;
  const auto x = drawn<L>(dice, -0.5, 0.5), y = drawn<L>(dice, -0.5, 0.5);
  measure<L>(state, [&](std::size_t i) {
    const L one(ScalarOf<L>(1)), zero(ScalarOf<L>(0)), eta(ScalarOf<L>(1 / 1.5));
    const Vec3<L> direction = normalized(Vec3<L>(x[i], y[i], -one));
    const Vec3<L> normal(zero, zero, one);
    return refracted(direction, normal, eta, dielectric_interface(-direction.z, eta));
  });
}

// Two colours, and over them the pattern to be asked, the last of the table.
std::vector<Texture> textures_of(Pattern pattern) {
  return {{SolidPattern{{0.9, 0.1, 0.2}}, Mapping::object, {}, {}},
          {SolidPattern{{0.1, 0.8, 0.3}}, Mapping::object, {}, {}},
          {CheckerPattern{0, 1}, Mapping::object, scaling({3, 3, 3}), {}},
          {std::move(pattern), Mapping::object, rotation({1, 2, 3}, 25), {}}};
}

template <class L>
void texture(benchmark::State& state, const Pattern& pattern) {
  Dice dice;
  const TextureTable<ScalarOf<L>> table(textures_of(pattern), {}, Vec3d());
  const auto x = drawn<L>(dice, -9, 9), y = drawn<L>(dice, -9, 9), z = drawn<L>(dice, -9, 9);
  measure<L>(state, [&](std::size_t i) {
    TexturePoint<L> point;
    point.object = point.rebased = {x[i], y[i], z[i]};
    return table.template color<L>(IntOf<L>(3), point);
  });
}

void add_texture(const std::string& name, const Pattern& pattern) {
  benchmark::RegisterBenchmark((name + "/single").c_str(), texture<double>, pattern);
  benchmark::RegisterBenchmark((name + "/lanes").c_str(), texture<Wide<double>>, pattern);
  benchmark::RegisterBenchmark((name + "/float_lanes").c_str(), texture<Wide<float>>, pattern);
}

BENCHMARK(dielectric<double>)->Name("dielectric/single");
BENCHMARK(dielectric<Wide<double>>)->Name("dielectric/lanes");
BENCHMARK(dielectric<Wide<float>>)->Name("dielectric/float_lanes");
BENCHMARK(dielectric_from_inside<double>)->Name("dielectric_from_inside/single");
BENCHMARK(dielectric_from_inside<Wide<double>>)->Name("dielectric_from_inside/lanes");
BENCHMARK(dielectric_from_inside<Wide<float>>)->Name("dielectric_from_inside/float_lanes");
BENCHMARK(conductor<double>)->Name("conductor/single");
BENCHMARK(conductor<Wide<double>>)->Name("conductor/lanes");
BENCHMARK(conductor<Wide<float>>)->Name("conductor/float_lanes");
BENCHMARK(refraction<double>)->Name("refraction/single");
BENCHMARK(refraction<Wide<double>>)->Name("refraction/lanes");
BENCHMARK(refraction<Wide<float>>)->Name("refraction/float_lanes");

}  // namespace
}  // namespace alhazen::render

int main(int argc, char** argv) {
  using namespace alhazen;
  render::add_texture("checker", CheckerPattern{0, 1});
  render::add_texture("nested_checker", CheckerPattern{0, 2});
  render::add_texture("brick", BrickPattern{0, 1, {1, 0.5, 0.25}, 0.1});
  render::add_texture("gradient",
                      GradientPattern{{{-5, {1, 0, 0}}, {0, {0, 1, 0}}, {5, {0, 0, 1}}}});
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}

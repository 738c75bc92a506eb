// bench: which pattern of samples a pixel should have. Prints, as Markdown, the RMSE of small
// pictures at equal numbers of samples, for random samples, jittered ones, the points that Alhazen
// draws (core/math/random.h), and one point set turned by an offset of each pixel's own, a mask
// without low frequencies ("blue-noise dithering"; I. Georgiev, M. Fajardo 2016). The pictures are
// what a pixel sees of an edge, of the penumbra of a square lamp, of an edge out of focus, and of a
// smooth gradient: a sample is a point in the pixel and one on the lamp or the lens.
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>
#include <vector>

#include "core/math/random.h"

namespace {

using alhazen::mix_64;
constexpr int kSide = 96;

struct Point {
  double x, y;
};
struct Sample {
  Point pixel, second;
};

double unit(std::uint64_t word) {
  return static_cast<double>(word >> 11) * 0x1p-53;
}
double fraction(double x) {
  return x - std::floor(x);
}

// Of pixel `seed`, dimension pair `pair`, sample `i` of `n`, a power of four.
using Pattern = Point (*)(std::uint64_t seed, int x, int y, int pair, std::uint32_t i,
                          std::uint32_t n);

Point random_point(std::uint64_t seed, int, int, int pair, std::uint32_t i, std::uint32_t) {
  const std::uint64_t at = mix_64(mix_64(seed, static_cast<std::uint64_t>(pair)), i);
  return {unit(mix_64(at, 1)), unit(mix_64(at, 2))};
}

// One random point in each of n cells; the cells of the second pair in another order: a bijection
// of [0, n) by a hash, of n's bits.
Point jittered(std::uint64_t seed, int, int, int pair, std::uint32_t i, std::uint32_t n) {
  const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(n)));
  const std::uint64_t own = mix_64(seed, static_cast<std::uint64_t>(pair));
  const std::uint32_t cell = static_cast<std::uint32_t>(alhazen::scrambled_upward(
                                 i, static_cast<std::uint32_t>(mix_64(own, 7)))) &
                             (n - 1);
  const Point p = random_point(own, 0, 0, 0, i, n);
  return {(cell % side + p.x) / side, (static_cast<double>(cell / side) + p.y) / side};
}

Point owen_sobol(std::uint64_t seed, int, int, int pair, std::uint32_t i, std::uint32_t) {
  const auto bits = alhazen::sample_2d(mix_64(seed, static_cast<std::uint64_t>(pair)), i);
  return {bits.x * 0x1p-32, bits.y * 0x1p-32};
}

// The same points in all pixels, turned on the torus by a mask: M. Roberts's R2 sequence over the
// picture ("The unreasonable effectiveness of quasirandom sequences", 2018), whose neighbours are
// far apart.
Point dithered(std::uint64_t, int x, int y, int pair, std::uint32_t i, std::uint32_t n) {
  const Point p = owen_sobol(12345, 0, 0, pair, i, n);
  const double mask = fraction(0.7548776662466927 * x + 0.5698402909980532 * y + 0.31 * pair);
  const double other = fraction(0.5698402909980532 * x - 0.7548776662466927 * y + 0.57 * pair);
  return {fraction(p.x + mask), fraction(p.y + other)};
}

using Scene = double (*)(int x, int y, const Sample& sample);

// Straight edges of all directions, between black and white.
double edges(int x, int y, const Sample& s) {
  const double px = x + s.pixel.x - kSide / 2.0, py = y + s.pixel.y - kSide / 2.0;
  const double angle = std::atan2(py, px) * 24 / 3.14159265358979;
  return fraction(angle / 2) < 0.5 ? 1 : 0;
}

// A square lamp above a floor, half covered by a plate: the penumbra is as wide as the picture.
double penumbra(int x, int y, const Sample& s) {
  const double px = (x + s.pixel.x) / kSide, py = (y + s.pixel.y) / kSide;
  const double u = s.second.x, v = s.second.y;
  const bool lit = u + 0.7 * v + 0.4 * (py - 0.5) > 1.7 * px;
  return lit ? 0.6 + 0.2 * u : 0;
}

// An edge out of focus, by as much as half the picture.
double out_of_focus(int x, int y, const Sample& s) {
  const double radius = std::sqrt(s.second.x), angle = 6.283185307179586 * s.second.y;
  const double px = (x + s.pixel.x) / kSide - 0.5, py = (y + s.pixel.y) / kSide - 0.5;
  const double moved = px + 0.35 * radius * std::cos(angle);
  const double bent = py + 0.35 * radius * std::sin(angle);
  return moved + 0.3 * bent > 0 ? 1 : 0;
}

double gradient(int x, int y, const Sample& s) {
  const double px = (x + s.pixel.x) / kSide, py = (y + s.pixel.y) / kSide;
  return 0.5 + 0.5 * std::sin(40 * px) * std::cos(37 * py + s.second.x);
}

std::vector<double> picture(Scene scene, Pattern pattern, std::uint32_t n, std::uint64_t seed) {
  std::vector<double> pixels;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const std::uint64_t own =
          mix_64(mix_64(seed, static_cast<std::uint64_t>(x)), static_cast<std::uint64_t>(y));
      double sum = 0;
      for (std::uint32_t i = 0; i < n; ++i)
        sum += scene(x, y, {pattern(own, x, y, 0, i, n), pattern(own, x, y, 1, i, n)});
      pixels.push_back(sum / n);
    }
  }
  return pixels;
}

// What is left for an eye that does not see single pixels: means of 5 x 5, binomial.
std::vector<double> seen(const std::vector<double>& picture) {
  constexpr std::array<double, 5> kWeights = {1 / 16.0, 4 / 16.0, 6 / 16.0, 4 / 16.0, 1 / 16.0};
  std::vector<double> result;
  for (int y = 2; y < kSide - 2; ++y) {
    for (int x = 2; x < kSide - 2; ++x) {
      double sum = 0;
      for (int j = -2; j <= 2; ++j) {
        for (int i = -2; i <= 2; ++i) {
          sum += kWeights[static_cast<std::size_t>(i + 2)] *
                 kWeights[static_cast<std::size_t>(j + 2)] *
                 picture[static_cast<std::size_t>((y + j) * kSide + x + i)];
        }
      }
      result.push_back(sum);
    }
  }
  return result;
}

double rmse(const std::vector<double>& a, const std::vector<double>& b) {
  const double sum = std::transform_reduce(a.begin(), a.end(), b.begin(), 0.0, std::plus<>(),
                                           [](double p, double q) { return (p - q) * (p - q); });
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace

int main() {
  struct {
    const char* name;
    Scene scene;
  } const scenes[] = {{"edges", edges},
                      {"penumbra", penumbra},
                      {"out of focus", out_of_focus},
                      {"gradient", gradient}};
  struct {
    const char* name;
    Pattern pattern;
  } const patterns[] = {{"random", random_point},
                        {"jittered", jittered},
                        {"Owen-scrambled Sobol", owen_sobol},
                        {"Sobol turned by a mask", dithered}};
  constexpr std::uint32_t kCounts[] = {1, 4, 16, 64, 256};
  std::printf("| picture | pattern | 1 | 4 | 16 | 64 | 256 | slope | seen: 1 | 4 | 16 |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const auto& scene : scenes) {
    const auto reference = picture(scene.scene, owen_sobol, 1u << 14, 99);
    const auto seen_reference = seen(reference);
    for (const auto& pattern : patterns) {
      std::printf("| %s | %s |", scene.name, pattern.name);
      std::array<double, std::size(kCounts)> errors{}, seen_errors{};
      for (std::size_t k = 0; k < std::size(kCounts); ++k) {
        const auto pixels = picture(scene.scene, pattern.pattern, kCounts[k], 1);
        errors[k] = rmse(pixels, reference);
        seen_errors[k] = rmse(seen(pixels), seen_reference);
        std::printf(" %.5f |", errors[k]);
      }
      std::printf(" %.2f |", std::log(errors[4] / errors[2]) / std::log(16.0));
      for (std::size_t k = 0; k < 3; ++k)
        std::printf(" %.5f |", seen_errors[k]);
      std::printf("\n");
    }
  }
  return 0;
}

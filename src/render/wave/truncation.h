// render/wave: how deep rays are to be followed for a picture of a given accuracy, by trying it out
// on some of its pixels.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/base/hash.h"
#include "render/wave/crew.h"

namespace alhazen::render {

// What of a ray tree is followed, and what is then missing from the picture: RMS of the pixels, in
// the measure of the target.
struct Truncation {
  int max_depth = 0;
  double cutoff = 0;
  double error = 0;
};

// Each rung follows rays twice as deep and four times as weak as the one before. How much light
// this adds to the first samples of the pixels that are tried says what the rung before was
// missing, up to there; what lies beyond the last falls on as it did between the last two, and at
// least by half. Light only adds, so the errors of the rungs add up, too.
template <class Real>
class TruncationLadder {
 public:
  TruncationLadder(const ErrorTarget& target, PixelRect window, std::uint64_t seed)
      : target_(target), loss_(target) {
    const std::size_t pixels =
        static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height);
    const std::size_t count = std::min(pixels, std::clamp(pixels / 16, kFewest, kMost));
    for (std::size_t i = 0; i < count; ++i) {
      // One pixel of each of `count` equal parts of the picture.
      const std::size_t from = i * pixels / count, to = (i + 1) * pixels / count;
      const std::size_t p = from + mix_64(seed ^ kPlaceDimension, i) % (to - from);
      const auto width = static_cast<std::size_t>(window.width);
      places_.push_back({window.x + static_cast<std::int32_t>(p % width),
                         window.y + static_cast<std::int32_t>(p / width)});
    }
  }

  // The cheapest rung whose error is a small share of the target's, or the last; the world is left
  // with that. Nothing if the run was cancelled. Where no ray is sent on there is nothing to try.
  std::optional<Truncation> climb(const StagePlan& plan, World<Real>& world, Crew<Real>& crew) {
    bool has_trees = false;
    plan.for_each(
        [&](const PlannedStage& stage) { has_trees = has_trees || sends_rays_on(stage.id); });
    if (!has_trees) return choose(world, true);
    std::vector<Value> below;
    for (int rung = 0;; ++rung) {
      set(world, rung);
      const std::uint64_t cut_before = cut(crew);
      std::vector<Value> radiance(places_.size());
      if (!trace(crew, radiance)) return std::nullopt;
      if (rung > 0) steps_.push_back(difference(below, radiance));
      const bool is_whole = cut(crew) == cut_before;
      const bool is_small = rung > 0 && steps_.back() <= kSmallShare * target_.error / 4;
      if (is_whole || is_small || rung == kLastRung) return choose(world, is_whole);
      below = std::move(radiance);
    }
  }

 private:
  using Value = std::array<double, 4>;
  static constexpr std::size_t kFewest = 256, kMost = 4096, kBatch = 64;
  static constexpr std::uint64_t kPlaceDimension = 0x706c616365732121;  // no sample's
  static constexpr int kFirstDepth = 8, kLastRung = 7;
  static constexpr double kSmallShare = 0.25;  // 1/16 of the target's square

  int depth(int rung) const { return kFirstDepth << rung; }
  double cutoff(int rung) const { return std::ldexp(target_.error, -2 * rung); }

  void set(World<Real>& world, int rung) const {
    world.max_depth = depth(rung);
    world.cutoff = static_cast<Real>(cutoff(rung));
  }

  static std::uint64_t cut(const Crew<Real>& crew) {
    std::uint64_t sum = 0;
    for (const auto& worker : crew.workers()) {
      const WaveCounters& counters = worker->renderer.counters();
      sum += counters.cut_by_depth + counters.cut_by_weight;
    }
    return sum;
  }

  bool trace(Crew<Real>& crew, std::vector<Value>& radiance) const {
    return crew.for_all((places_.size() + kBatch - 1) / kBatch, [&](auto& renderer, std::size_t i) {
      const std::size_t first = i * kBatch, count = std::min(kBatch, places_.size() - first);
      return renderer.probe(std::span(places_).subspan(first, count),
                            std::span(radiance).subspan(first, count));
    });
  }

  double difference(const std::vector<Value>& a, const std::vector<Value>& b) const {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += loss_.squared({b[i][0] - a[i][0], b[i][1] - a[i][1], b[i][2] - a[i][2]});
    return square_root(sum / static_cast<double>(a.size()));
  }

  Truncation choose(World<Real>& world, bool is_whole) const {
    double beyond = 0;
    if (!is_whole && !steps_.empty()) {
      const double last = steps_.back();
      const double fall = steps_.size() > 1 && last > 0 ? last / steps_[steps_.size() - 2] : 0.5;
      // Geometric with the ratio of the last two; what does not fall has no end.
      beyond =
          fall < 1 ? last * std::max(fall, 0.5) / (1 - std::max(fall, 0.5)) : infinity<double>();
    }
    auto rung = static_cast<int>(steps_.size());
    double error = beyond;
    while (rung > 0 &&
           error + steps_[static_cast<std::size_t>(rung - 1)] <= kSmallShare * target_.error)
      error += steps_[static_cast<std::size_t>(--rung)];
    set(world, rung);
    return {depth(rung), cutoff(rung), error};
  }

  ErrorTarget target_;
  ErrorLoss loss_;
  std::vector<typename TileRenderer<Real>::Place> places_;
  std::vector<double> steps_;  // from each rung to the next
};

}  // namespace alhazen::render

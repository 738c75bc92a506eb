#include "app/povray/judge.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "app/compare/pixels_over.h"

namespace alhazen {
namespace {

// Calls `visit` with each pixel of the three by three around `place` that there is.
template <class Visit>
void around(PixelPlace place, const render::FloatBuffer& picture, const Visit& visit) {
  for (int row = std::max(place.row - 1, 0); row <= std::min(place.row + 1, picture.height() - 1);
       ++row) {
    for (int column = std::max(place.column - 1, 0);
         column <= std::min(place.column + 1, picture.width() - 1); ++column) {
      visit(column, row);
    }
  }
}

class Judge {
 public:
  Judge(const render::FloatBuffer& ours, const render::FloatBuffer& theirs,
        const std::vector<std::uint32_t>& objects)
      : ours_(ours), theirs_(theirs), objects_(objects) {}

  JudgedPixel pixel(const PixelOver& over) const {
    JudgedPixel out{over.place, color(ours_, over.place), color(theirs_, over.place),
                    over.largest_error, Cause::unexplained};
    if (!std::isfinite(over.largest_error)) return out;
    if (shows_several_objects(over.place)) {
      out.cause = Cause::silhouette;
    } else if (is_step(over.place)) {
      out.cause = Cause::edge;
    }
    return out;
  }

 private:
  static Rgb<float> color(const render::FloatBuffer& picture, PixelPlace place) {
    return {picture.at(0, place.column, place.row), picture.at(1, place.column, place.row),
            picture.at(2, place.column, place.row)};
  }

  bool shows_several_objects(PixelPlace place) const {
    const auto object = [&](int column, int row) {
      return objects_[static_cast<std::size_t>(row) * static_cast<std::size_t>(ours_.width()) +
                      static_cast<std::size_t>(column)];
    };
    bool several = false;
    around(place, ours_, [&](int column, int row) {
      several |= object(column, row) != object(place.column, place.row);
    });
    return several;
  }

  // Whether in each channel the pixels around, in one of the pictures, span at least the
  // difference: then an edge may lie there, which the two programs put on different sides of the
  // pixel's centre. Not the pixel itself: a speck in one of the pictures would be its own edge. A
  // smooth shade passes for an edge, too, when the difference is small; but an error in a shade is
  // in many pixels, and those are limited by kShareWithin.
  bool is_step(PixelPlace place) const {
    for (std::size_t c = 0; c < 3; ++c) {
      const float difference =
          std::abs(ours_.at(c, place.column, place.row) - theirs_.at(c, place.column, place.row));
      if (!(spread(ours_, c, place) >= difference) && !(spread(theirs_, c, place) >= difference)) {
        return false;
      }
    }
    return true;
  }

  static float spread(const render::FloatBuffer& picture, std::size_t channel, PixelPlace place) {
    float low = std::numeric_limits<float>::infinity(), high = -low;
    around(place, picture, [&](int column, int row) {
      if (PixelPlace{column, row} == place) return;
      low = std::min(low, picture.at(channel, column, row));
      high = std::max(high, picture.at(channel, column, row));
    });
    return high - low;
  }

  const render::FloatBuffer& ours_;
  const render::FloatBuffer& theirs_;
  const std::vector<std::uint32_t>& objects_;
};

std::uint64_t count_not_finite(const std::vector<PlanePair>& planes) {
  std::uint64_t count = 0;
  for (const PlanePair& plane : planes) {
    for (std::size_t i = 0; i < plane.a.size(); ++i)
      count += std::isfinite(plane.a[i]) && std::isfinite(plane.b[i]) ? 0 : 1;
  }
  return count;
}

void decide(Verdict& verdict, const Allowance* allowance) {
  if (verdict.not_finite > 0) {
    verdict.passes = false;
    verdict.sentence =
        fmt::format("{} channels are not finite in one picture or both", verdict.not_finite);
    return;
  }
  if (allowance != nullptr) {
    verdict.by_allowance = true;
    verdict.passes = verdict.rmse <= allowance->rmse;
    verdict.sentence = fmt::format("RMSE {:.3g}, allowed {:.3g}: {}", verdict.rmse, allowance->rmse,
                                   allowance->reason);
    return;
  }
  const double share =
      1 - static_cast<double>(verdict.over) / static_cast<double>(verdict.channels);
  const auto unexplained =
      std::ranges::count(verdict.pixels, Cause::unexplained, &JudgedPixel::cause);
  verdict.passes = share >= kShareWithin && unexplained == 0;
  if (verdict.over == 0) {
    verdict.sentence = "all channels agree to the rounding of a half float";
    return;
  }
  verdict.sentence = fmt::format(
      "{:.4f} % of the channels agree to the rounding of a half float; {} pixels differ",
      100 * share, verdict.pixels.size());
  // Beyond that share it is no matter of edges.
  if (share < kShareWithin) return;
  verdict.sentence +=
      unexplained == 0 ? ", all at edges" : fmt::format(", {} of them at no edge", unexplained);
}

}  // namespace

std::string_view name(Cause cause) {
  static constexpr std::string_view kNames[] = {"silhouette", "edge", "unexplained"};
  return kNames[static_cast<std::size_t>(cause)];
}

std::string_view result_name(const Verdict& verdict) {
  if (!verdict.passes) return "DIFFERENT";
  if (verdict.over == 0) return "same";
  return verdict.by_allowance ? "within its tolerance" : "same but for edges";
}

Verdict judge(const render::FloatBuffer& ours, const render::FloatBuffer& theirs,
              const std::vector<std::uint32_t>& objects, const Allowance* allowance) {
  std::vector<PlanePair> planes;
  FigureSums sums(ours.channel(0), theirs.channel(0), ours.width(), kHalfFloat);
  for (std::size_t c = 0; c < 3; ++c) {
    planes.push_back({ours.channel(c), theirs.channel(c)});
    if (c > 0) sums.add({ours.channel(c), theirs.channel(c), ours.width(), kHalfFloat});
  }
  const PixelsOver over = pixels_over(planes, ours.width(), kHalfFloat);
  const Figures figures = sums.figures(1);
  Verdict verdict;
  verdict.channels = over.samples;
  verdict.over = over.over;
  verdict.not_finite = count_not_finite(planes);
  verdict.rmse = figures.rmse;
  verdict.largest = figures.largest.error;
  const Judge judge(ours, theirs, objects);
  for (const PixelOver& pixel : over.pixels)
    verdict.pixels.push_back(judge.pixel(pixel));
  decide(verdict, allowance);
  return verdict;
}

}  // namespace alhazen

#include "app/compare/report_values.h"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace alhazen {
namespace {

constexpr OddPair kAllKinds[] = {OddPair::nan_in_a, OddPair::nan_in_b, OddPair::nan_in_both,
                                 OddPair::unequal_infinity, OddPair::equal_infinity};

// "3 of 100 pixels", "in part rgba 3 of 100 pixels, in part data 5 of 100 pixels".
std::string pixels_that_differ(const Comparison& comparison) {
  std::vector<std::string> texts;
  for (const PartComparison& part : comparison.parts) {
    if (part.over.pixels.empty()) continue;
    const std::string& name = part.parts.a->name;
    texts.push_back(fmt::format("{}{} of {} pixels", name.empty() ? "" : "in part " + name + " ",
                                part.over.pixels.size(), part.parts.a->pixels.pixel_count()));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string flip_text(const FlipResult& flip, const PartPair& parts) {
  if (flip.largest.error == 0.0) return "0";
  return fmt::format("{} on average and {} at most, at {}", figure_text(flip.mean),
                     figure_text(flip.largest.error), place_text(parts, flip.largest.place));
}

}  // namespace

std::string figure_text(double value) {
  if (std::isnan(value)) return "none";
  if (std::isinf(value)) return "infinite";
  return fmt::format("{:.5g}", value);
}

PixelPlace picture_place(const PartPair& parts, PixelPlace place) {
  const render::PixelWindow& window = parts.a->data_window;
  return {place.column + window.x, place.row + window.y};
}

std::string place_text(const PartPair& parts, PixelPlace place) {
  const PixelPlace at = picture_place(parts, place);
  return fmt::format("({}, {})", at.column, at.row);
}

std::string_view name(OddPair kind) {
  switch (kind) {
    case OddPair::nan_in_a:
      return "NaN in A only";
    case OddPair::nan_in_b:
      return "NaN in B only";
    case OddPair::nan_in_both:
      return "NaN in both, which counts as equal";
    case OddPair::unequal_infinity:
      return "infinite in one, or of different signs";
    case OddPair::equal_infinity:
      return "the same infinity in both";
  }
  return "";
}

std::vector<std::string> odd_sentences(const PartComparison& part) {
  std::vector<std::string> sentences;
  for (const ChannelComparison& channel : part.channels) {
    for (const OddPair kind : kAllKinds) {
      const OddCount& odd = channel.figures.odd_count(kind);
      if (odd.count == 0) continue;
      sentences.push_back(fmt::format("{}: {} x {}; the first at {}", channel.channel.name,
                                      odd.count, name(kind), place_text(part.parts, odd.first)));
    }
  }
  return sentences;
}

std::string visible_text(const VisibleError& visible, const PartPair& parts) {
  const std::string ssim =
      visible.ssim ? figure_text(*visible.ssim) : "none (under 11 pixels there is no window)";
  return fmt::format("SSIM {}, FLIP {}", ssim, flip_text(visible.flip, parts));
}

std::string hdr_text(const HdrFlipResult& hdr, const PartPair& parts) {
  return fmt::format("HDR-FLIP {}, over {} exposures from {:.3g} to {:.3g} stops",
                     flip_text(hdr.flip, parts), hdr.exposures.count, hdr.exposures.first,
                     hdr.exposures.last);
}

std::string part_title(const PartComparison& part) {
  const render::PixelWindow& window = part.parts.a->data_window;
  const std::string& name = part.parts.a->name;
  return fmt::format("{}{} x {} pixels", name.empty() ? "" : fmt::format("part {}: ", name),
                     window.width, window.height);
}

std::string tolerance_text(const Tolerance& tolerance) {
  if (tolerance.relative == 0.0) return fmt::format("more than {}", tolerance.absolute);
  return fmt::format("more than max({}, {} |B|)", tolerance.absolute, tolerance.relative);
}

std::string largest_text(const Figures& figures) {
  return figures.compared == 0 ? "none" : figure_text(figures.largest.error);
}

std::string largest_place_text(const PartPair& parts, const Figures& figures) {
  return figures.largest.error > 0.0 ? place_text(parts, figures.largest.place) : "-";
}

std::string verdict(const Comparison& comparison) {
  const std::string limit = tolerance_text(comparison.settings.tolerance);
  if (comparison.passed())
    return fmt::format("A and B are the same: no value differs by {}", limit);
  if (comparison.pixels_over() > 0) {
    return fmt::format("A and B differ by {}: {}", limit, pixels_that_differ(comparison));
  }
  if (comparison.parts.empty()) return "A and B differ: there is nothing in them to compare";
  return fmt::format("A and B differ in shape; of what both have, no value differs by {}", limit);
}

}  // namespace alhazen

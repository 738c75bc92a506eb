#include "app/compare/report_text.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/compare/report_values.h"

namespace alhazen {
namespace {

std::string row(const std::string& name, const Figures& f, const PartPair& parts,
                std::size_t width) {
  return fmt::format("{:<{}}  {:>10}  {:>10}  {:>10}  {:>10}  {:>8}  {:>10}  {:>12}  {:>8}\n", name,
                     width, figure_text(f.mse), figure_text(f.rmse), figure_text(f.relative_mse),
                     figure_text(f.mae), figure_text(f.psnr), largest_text(f),
                     largest_place_text(parts, f), f.over);
}

std::string table(const PartComparison& part) {
  std::size_t width = 7;
  for (const ChannelComparison& channel : part.channels)
    width = std::max(width, channel.channel.name.size());
  std::string text = fmt::format(
      "{:<{}}  {:>10}  {:>10}  {:>10}  {:>10}  {:>8}  {:>10}  {:>12}  {:>8}\n", "channel", width,
      "MSE", "RMSE", "rel. MSE", "MAE", "PSNR dB", "max |A-B|", "at (x, y)", "over");
  for (const LayerComparison& layer : part.layers) {
    for (const ChannelComparison& channel : part.channels) {
      const bool belongs = std::ranges::any_of(layer.channels, [&](const ChannelPair& pair) {
        return pair.name == channel.channel.name;
      });
      if (belongs) text += row(channel.channel.name, channel.figures, part.parts, width);
    }
    if (layer.channels.size() > 1) text += row(layer.name, layer.figures, part.parts, width);
  }
  return text;
}

std::string visible_lines(const PartComparison& part, const CompareSettings& settings) {
  std::string text;
  for (const LayerComparison& layer : part.layers) {
    if (!layer.visible) continue;
    text += fmt::format("{}: {} (exposure {}, {:.4g} pixels a degree)\n", layer.name,
                        visible_text(*layer.visible, part.parts), settings.exposure,
                        settings.pixels_per_degree);
    if (!layer.visible->hdr_flip) continue;
    text += fmt::format("{}: {}\n", layer.name, hdr_text(*layer.visible->hdr_flip, part.parts));
  }
  return text;
}

}  // namespace

std::string comparison_text(const Comparison& comparison, const ComparedPicture& a,
                            const ComparedPicture& b) {
  std::string text = fmt::format("A  {}\nB  {}  (the reference)\n", a.name, b.name);
  for (const PartComparison& part : comparison.parts) {
    text += fmt::format("\n{}\n{}", part_title(part), table(part));
    text += visible_lines(part, comparison.settings);
    for (const std::string& sentence : odd_sentences(part))
      text += sentence + "\n";
  }
  text += "\n";
  for (const std::string& note : comparison.notes)
    text += "note: " + note + "\n";
  for (const std::string& difference : comparison.differences)
    text += difference + "\n";
  return text + verdict(comparison) + "\n";
}

}  // namespace alhazen

// app/compare: the table of figures on a page.
#include <fmt/format.h>

#include "app/compare/report_page.h"
#include "app/compare/report_values.h"
#include "app/page/table.h"

namespace alhazen {
namespace {

Html text(const std::string& words) {
  return html_text(words);
}

std::vector<Html> row(const std::string& name, const Figures& figures, const PartPair& parts) {
  return {text(name),
          text(figure_text(figures.mse)),
          text(figure_text(figures.rmse)),
          text(figure_text(figures.relative_mse)),
          text(figure_text(figures.mae)),
          text(figure_text(figures.psnr)),
          text(largest_text(figures)),
          text(largest_place_text(parts, figures)),
          text(fmt::format("{}", figures.over))};
}

}  // namespace

Html figures_table(const PartComparison& part, const CompareSettings& settings) {
  HtmlTable table;
  table.columns = {
      {"channel"},
      {"MSE", true, "mean of (A - B)\u00b2"},
      {"RMSE", true, "square root of MSE"},
      {"relative MSE", true,
       fmt::format("mean of (A - B)\u00b2 / (B\u00b2 + {})", kRelativeEpsilon)},
      {"MAE", true, "mean of |A - B|"},
      {"PSNR, dB", true, fmt::format("10 log10(peak\u00b2 / MSE), peak {}", settings.peak)},
      {"largest |A \u2212 B|", true},
      {"at (x, y)", true},
      {"over", true, "values that differ by " + tolerance_text(settings.tolerance)}};
  for (const LayerComparison& layer : part.layers) {
    for (const ChannelPair& pair : layer.channels) {
      for (const ChannelComparison& channel : part.channels) {
        if (channel.channel.name != pair.name) continue;
        table.rows.push_back(row(pair.name, channel.figures, part.parts));
      }
    }
    if (layer.channels.size() == 1) continue;
    table.rows.push_back(row(layer.name + " together", layer.figures, part.parts));
  }
  return html_table(table);
}

}  // namespace alhazen

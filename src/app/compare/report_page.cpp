#include "app/compare/report_page.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

#include "app/compare/color_ramp.h"
#include "app/compare/layer.h"
#include "app/compare/report_values.h"
#include "app/page/page.h"
#include "app/page/pictures.h"

namespace alhazen {
namespace {

Html list(const std::vector<std::string>& sentences) {
  Html items;
  for (const std::string& sentence : sentences)
    items += html_line("li", sentence);
  return sentences.empty() ? Html{} : html_element("ul", items);
}

std::string visible_sentence(const LayerComparison& layer, const PartPair& parts,
                             const CompareSettings& settings) {
  const std::string sentence = fmt::format(
      "{}. Both see light from 0 to 1 after an exposure of {} stops; FLIP at {:.4g} pixels a "
      "degree.",
      visible_text(*layer.visible, parts), settings.exposure, settings.pixels_per_degree);
  if (!layer.visible->hdr_flip) return sentence;
  return fmt::format("{} {}.", sentence, hdr_text(*layer.visible->hdr_flip, parts));
}

// For readers without a pointer to rest on a title.
Html explanations(const CompareSettings& settings) {
  const std::pair<const char*, std::string> kFigures[] = {
      {"MSE, RMSE, MAE", "mean of (A \u2212 B)\u00b2, its square root, mean of |A \u2212 B|"},
      {"relative MSE",
       fmt::format("mean of (A \u2212 B)\u00b2 / (B\u00b2 + {})", kRelativeEpsilon)},
      {"PSNR", fmt::format("10 log10(peak\u00b2 / MSE) for a peak of {}", settings.peak)},
      {"over", "how many values differ by " + tolerance_text(settings.tolerance)},
      {"SSIM", "structural similarity of the luma, windows of 11 pixels; 1 for equal pictures"},
      {"FLIP", "how visible the difference is when A and B alternate on one spot, 0 to 1"},
      {"none", "there is no such figure: of ids, and where no pair is of two numbers"}};
  Html list;
  for (const auto& [name, meaning] : kFigures)
    list += html_line("dt", name) + html_line("dd", meaning);
  return html_element("details",
                      html_line("summary", "What the figures are") + html_element("dl", list));
}

class SectionWriter {
 public:
  SectionWriter(const Comparison& comparison, const ComparedPicture& a, const ComparedPicture& b,
                const PageView& view)
      : comparison_(comparison), a_(a), b_(b), view_(view) {}

  Result<Html> part(const PartComparison& part) const {
    Html html = html_line("h2", part_title(part));
    for (const LayerComparison& layer : part.layers) {
      // The picture itself is shown even where it is the same; data only where they are not.
      const bool differs = layer.figures.largest.error > 0.0;
      if (!differs && layer.name != "RGB") continue;
      const Result<Html> more = layer.visible ? colors(part, layer) : data(part, layer);
      if (!more) return more.error();
      html += more.value();
    }
    html += figures_table(part, comparison_.settings);
    return html + list(odd_sentences(part));
  }

 private:
  Result<Html> colors(const PartComparison& part, const LayerComparison& layer) const {
    const PartPair& parts = part.parts;
    std::vector<std::string> names;
    for (const ChannelPair& channel : layer.channels)
      names.push_back(channel.name);
    const std::array<std::size_t, 3> rgb = colors_of(names).value();
    const std::array<ChannelPair, 3> channels{layer.channels[rgb[0]], layer.channels[rgb[1]],
                                              layer.channels[rgb[2]]};
    const double exposure = comparison_.settings.exposure;
    const double gain = difference_gain(parts, channels);
    const bool differs = layer.figures.largest.error > 0.0;
    std::vector<PagePicture> pictures{
        picture(parts, "A", a_.name,
                view_.shown(parts.a->pixels, {channels[0].a, channels[1].a, channels[2].a},
                            display_look(a_, *parts.a, exposure))),
        picture(parts, "B", b_.name + " (the reference)",
                view_.shown(parts.b->pixels, {channels[0].b, channels[1].b, channels[2].b},
                            display_look(b_, *parts.b, exposure))),
        picture(
            parts, "|A \u2212 B|",
            differs ? fmt::format("of each channel, \u00d7 {:g}", gain) : "black: no difference",
            shown_difference(parts, channels, gain, a_.encoding)),
        picture(parts, "FLIP", "how visible the difference is when A and B alternate",
                ramp_picture(layer.visible->flip.errors.channel(0), 1.0))};
    if (const auto& hdr = layer.visible->hdr_flip) {
      pictures.push_back(picture(parts, "HDR-FLIP", "the largest FLIP of several exposures",
                                 ramp_picture(hdr->flip.errors.channel(0), 1.0)));
    }
    const Result<Html> shown = html_pictures(pictures);
    if (!shown) return shown.error();
    return html_line("h3", layer.name) +
           html_line("p", visible_sentence(layer, parts, comparison_.settings)) + shown.value() +
           ramp_legend("FLIP 0", "1");
  }

  Result<Html> data(const PartComparison& part, const LayerComparison& layer) const {
    const double largest = layer.figures.largest.error;
    std::vector<float> errors(part.parts.a->pixels.pixel_count());
    for (const ChannelPair& channel : layer.channels) {
      const std::span<const float> a = part.parts.a->pixels.channel(channel.a);
      const std::span<const float> b = part.parts.b->pixels.channel(channel.b);
      for (std::size_t i = 0; i < errors.size(); ++i) {
        const float error = std::fabs(a[i] - b[i]);
        if (error > errors[i]) errors[i] = error;
      }
    }
    const std::vector<PagePicture> pictures{picture(
        part.parts, "|A \u2212 B|", "the largest of its channels", ramp_picture(errors, largest))};
    const Result<Html> shown = html_pictures(pictures);
    if (!shown) return shown.error();
    return html_line("h3", layer.name) + shown.value() + ramp_legend("0", figure_text(largest));
  }

  static PagePicture picture(const PartPair& parts, std::string name, std::string caption,
                             std::vector<std::uint8_t> rgb) {
    return {parts.a->pixels.width(), parts.a->pixels.height(), std::move(rgb), std::move(name),
            std::move(caption)};
  }

  const Comparison& comparison_;
  const ComparedPicture& a_;
  const ComparedPicture& b_;
  const PageView& view_;
};

}  // namespace

Result<Html> comparison_section(const Comparison& comparison, const ComparedPicture& a,
                                const ComparedPicture& b, const PageView& view) {
  Html html =
      html_line("p", verdict(comparison), {{"class", comparison.passed() ? "good" : "bad"}});
  html += list(comparison.differences);
  html += list(comparison.notes);
  const SectionWriter writer(comparison, a, b, view);
  for (const PartComparison& part : comparison.parts) {
    const Result<Html> more = writer.part(part);
    if (!more) return more.error();
    html += more.value();
  }
  return html;
}

Result<std::string> comparison_page(const Comparison& comparison, const ComparedPicture& a,
                                    const ComparedPicture& b, const PageView& view) {
  const Result<Html> section = comparison_section(comparison, a, b, view);
  if (!section) return section.error();
  const auto short_name = [](const std::string& file) {
    return std::filesystem::path(file).filename().string();
  };
  const Html names = html_line("p", fmt::format("A: {}", a.name)) +
                     html_line("p", fmt::format("B, the reference: {}", b.name));
  return html_page(fmt::format("{} and {}", short_name(a.name), short_name(b.name)),
                   names + section.value() + explanations(comparison.settings));
}

}  // namespace alhazen

#include "app/compare/report_json.h"

#include <algorithm>
#include <cmath>

#include "app/compare/report_values.h"

namespace alhazen {
namespace {

using Json = nlohmann::ordered_json;

// How many of the pixels over the tolerance are listed one by one.
constexpr std::size_t kListedPixels = 100;

constexpr std::pair<OddPair, const char*> kOddNames[] = {
    {OddPair::nan_in_a, "nan_in_a"},
    {OddPair::nan_in_b, "nan_in_b"},
    {OddPair::nan_in_both, "nan_in_both"},
    {OddPair::unequal_infinity, "unequal_infinity"},
    {OddPair::equal_infinity, "equal_infinity"}};

Json number(double value) {
  if (std::isnan(value)) return nullptr;
  if (std::isinf(value)) return value > 0 ? "infinite" : "-infinite";
  return value;
}

Json place(const PartPair& parts, PixelPlace local) {
  const PixelPlace at = picture_place(parts, local);
  return {at.column, at.row};
}

Json flip_json(const FlipResult& flip, const PartPair& parts) {
  return {{"mean", flip.mean},
          {"largest", flip.largest.error},
          {"at", place(parts, flip.largest.place)}};
}

Json layer_json(const LayerComparison& layer, const PartPair& parts) {
  Json json = {{"name", layer.name}, {"channels", Json::array()}};
  for (const ChannelPair& channel : layer.channels)
    json["channels"].push_back(channel.name);
  json["figures"] = figures_json(layer.figures, parts);
  if (!layer.visible) return json;
  json["ssim"] = layer.visible->ssim ? Json(*layer.visible->ssim) : Json(nullptr);
  json["flip"] = flip_json(layer.visible->flip, parts);
  if (!layer.visible->hdr_flip) return json;
  const FlipExposures& exposures = layer.visible->hdr_flip->exposures;
  json["hdr_flip"] = flip_json(layer.visible->hdr_flip->flip, parts);
  json["hdr_flip"]["exposures"] = {
      {"first", exposures.first}, {"last", exposures.last}, {"count", exposures.count}};
  return json;
}

Json part_json(const PartComparison& part) {
  const render::PixelWindow& window = part.parts.a->data_window;
  Json json = {{"name", part.parts.a->name},
               {"window", {window.x, window.y, window.width, window.height}},
               {"pixels", part.parts.a->pixels.pixel_count()},
               {"pixels_over", part.over.pixels.size()},
               {"samples", part.over.samples},
               {"samples_over", part.over.over},
               {"first_pixels_over", Json::array()},
               {"channels", Json::array()},
               {"layers", Json::array()}};
  const std::size_t listed = std::min(kListedPixels, part.over.pixels.size());
  for (const PixelOver& pixel : std::span(part.over.pixels).first(listed)) {
    json["first_pixels_over"].push_back({{"at", place(part.parts, pixel.place)},
                                         {"channels", pixel.channels},
                                         {"largest_error", number(pixel.largest_error)}});
  }
  for (const ChannelComparison& channel : part.channels) {
    json["channels"].push_back(
        {{"name", channel.channel.name}, {"figures", figures_json(channel.figures, part.parts)}});
  }
  for (const LayerComparison& layer : part.layers)
    json["layers"].push_back(layer_json(layer, part.parts));
  return json;
}

Json settings_json(const CompareSettings& settings) {
  return {{"max_error", number(settings.tolerance.absolute)},
          {"max_relative", number(settings.tolerance.relative)},
          {"relative_epsilon", kRelativeEpsilon},
          {"peak", settings.peak},
          {"exposure", settings.exposure},
          {"pixels_per_degree", settings.pixels_per_degree}};
}

}  // namespace

Json figures_json(const Figures& figures, const PartPair& parts) {
  Json json = {
      {"pairs", figures.pairs},
      {"compared", figures.compared},
      {"mse", number(figures.mse)},
      {"rmse", number(figures.rmse)},
      {"relative_mse", number(figures.relative_mse)},
      {"mae", number(figures.mae)},
      {"psnr", number(figures.psnr)},
      {"largest_error", figures.compared == 0 ? Json(nullptr) : Json(figures.largest.error)},
      {"over", figures.over}};
  if (figures.largest.error > 0.0) {
    json["largest_at"] = place(parts, figures.largest.place);
    json["largest_values"] = {figures.largest.a, figures.largest.b};
  }
  for (const auto& [kind, name] : kOddNames) {
    const OddCount& odd = figures.odd_count(kind);
    if (odd.count == 0) continue;
    json["odd"][name] = {{"count", odd.count}, {"first", place(parts, odd.first)}};
  }
  return json;
}

Json comparison_json(const Comparison& comparison, const ComparedPicture& a,
                     const ComparedPicture& b) {
  Json json = {{"a", a.name},
               {"b", b.name},
               {"passed", comparison.passed()},
               {"verdict", verdict(comparison)},
               {"settings", settings_json(comparison.settings)},
               {"differences", comparison.differences},
               {"notes", comparison.notes},
               {"parts", Json::array()}};
  for (const PartComparison& part : comparison.parts)
    json["parts"].push_back(part_json(part));
  return json;
}

}  // namespace alhazen

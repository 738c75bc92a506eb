#include "app/compare/compare.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/compare/layer.h"
#include "app/compare/ssim.h"

namespace alhazen {
namespace {

using Colors = std::array<std::size_t, 3>;

class PartComparer {
 public:
  PartComparer(const ComparedPicture& a, const ComparedPicture& b, const CompareSettings& settings)
      : a_(a), b_(b), settings_(settings) {}

  PartComparison compare(const PartPair& parts) const {
    PartComparison result{parts, {}, {}, {}};
    std::vector<FigureSums> layer_sums;
    std::vector<PlanePair> planes;
    for (const ChannelPair& channel : parts.channels) {
      const PlanePair plane{parts.a->pixels.channel(channel.a), parts.b->pixels.channel(channel.b),
                            holds_ids(channel.name)};
      FigureSums sums(plane.a, plane.b, parts.a->pixels.width(),
                      plane.ids ? Tolerance{} : settings_.tolerance);
      if (plane.ids) sums.drop_means();
      result.channels.push_back({channel, sums.figures(settings_.peak)});
      add_to_layer(channel, sums, result.layers, layer_sums);
      planes.push_back(plane);
    }
    for (std::size_t i = 0; i < result.layers.size(); ++i) {
      result.layers[i].figures = layer_sums[i].figures(settings_.peak);
      result.layers[i].visible = visible_error(parts, result.layers[i]);
    }
    result.over = pixels_over(planes, parts.a->pixels.width(), settings_.tolerance);
    return result;
  }

 private:
  static void add_to_layer(const ChannelPair& channel, const FigureSums& sums,
                           std::vector<LayerComparison>& layers,
                           std::vector<FigureSums>& layer_sums) {
    const std::string name = layer_of(channel.name);
    const auto found = std::ranges::find(layers, name, &LayerComparison::name);
    if (found == layers.end()) {
      layers.push_back({name, {channel}, {}, {}});
      layer_sums.push_back(sums);
    } else {
      found->channels.push_back(channel);
      layer_sums[static_cast<std::size_t>(found - layers.begin())].add(sums);
    }
  }

  std::optional<VisibleError> visible_error(const PartPair& parts,
                                            const LayerComparison& layer) const {
    std::vector<std::string> names;
    for (const ChannelPair& channel : layer.channels)
      names.push_back(channel.name);
    const auto colors = colors_of(names);
    if (!colors) return std::nullopt;
    Colors in_a{}, in_b{};
    for (std::size_t c = 0; c < 3; ++c) {
      in_a[c] = layer.channels[(*colors)[c]].a;
      in_b[c] = layer.channels[(*colors)[c]].b;
    }
    const render::FloatBuffer light_a =
        display_light(parts.a->pixels, in_a, display_look(a_, *parts.a, settings_.exposure));
    const render::FloatBuffer light_b =
        display_light(parts.b->pixels, in_b, display_look(b_, *parts.b, settings_.exposure));
    VisibleError error{mean_ssim(luma(light_a), luma(light_b)),
                       flip(light_a, light_b, settings_.pixels_per_degree), std::nullopt};
    if (settings_.hdr_flip) {
      error.hdr_flip =
          hdr_flip(rec709_light(parts.a->pixels, in_a, display_look(a_, *parts.a, 0.0)),
                   rec709_light(parts.b->pixels, in_b, display_look(b_, *parts.b, 0.0)),
                   settings_.pixels_per_degree);
    }
    return error;
  }

  const ComparedPicture& a_;
  const ComparedPicture& b_;
  const CompareSettings& settings_;
};

}  // namespace

std::uint64_t Comparison::pixels_over() const {
  std::uint64_t count = 0;
  for (const PartComparison& part : parts)
    count += part.over.pixels.size();
  return count;
}

DisplayLook display_look(const ComparedPicture& picture, const render::ExrPart& part,
                         double exposure) {
  if (picture.encoding == PixelEncoding::srgb) return {picture.encoding, {}, exposure};
  return {picture.encoding, rec709_from(chromaticities_of(part).value_or(kRec709)), exposure};
}

Result<Comparison> compare_pictures(const ComparedPicture& a, const ComparedPicture& b,
                                    const CompareSettings& settings) {
  if (settings.hdr_flip && a.encoding == PixelEncoding::srgb) {
    return Error{ErrorCode::usage,
                 "HDR-FLIP is for light (EXR); codes of a display have no more "
                 "range than FLIP looks at"};
  }
  Result<Pairing> pairing = pair_pictures(a, b, settings.channels);
  if (!pairing) return pairing.error();
  Comparison result{
      settings, std::move(pairing.value().differences), std::move(pairing.value().notes), {}};
  const PartComparer comparer(a, b, settings);
  for (const PartPair& parts : pairing.value().parts)
    result.parts.push_back(comparer.compare(parts));
  return result;
}

}  // namespace alhazen

#include "app/compare/difference_picture.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/compare/layer.h"

namespace alhazen {
namespace {

// Channels in the making: names, and samples for each.
class Channels {
 public:
  bool has(const std::string& name) const {
    return std::ranges::find(names_, name) != names_.end();
  }
  void add(std::string name, std::vector<float> samples) {
    names_.push_back(std::move(name));
    planes_.push_back(std::move(samples));
  }
  bool empty() const { return names_.empty(); }
  render::FloatBuffer buffer(const render::PixelWindow& window) const {
    if (names_.empty()) return {};
    render::FloatBuffer result(window.width, window.height, names_);
    for (std::size_t i = 0; i < planes_.size(); ++i)
      std::ranges::copy(planes_[i], result.channel(i).begin());
    return result;
  }

 private:
  std::vector<std::string> names_;
  std::vector<std::vector<float>> planes_;
};

// Equal infinities, and NaN in both, do not differ.
float difference(float a, float b) {
  return a == b || (a != a && b != b) ? 0.0F : a - b;
}

std::vector<float> differences(std::span<const float> a, std::span<const float> b) {
  std::vector<float> result(a.size());
  std::ranges::transform(a, b, result.begin(), difference);
  return result;
}

struct Parts {
  Channels beauty, data;

  void add(const PartComparison& part) {
    const std::string& prefix = part.parts.a->name;
    const auto free_name = [&](const std::string& name) {
      return beauty.has(name) || data.has(name) ? prefix + "." + name : name;
    };
    for (const ChannelPair& channel : part.parts.channels) {
      const std::string name = free_name(channel.name);
      Channels& target = layer_of(name) == "RGB" ? beauty : data;
      target.add(name, differences(part.parts.a->pixels.channel(channel.a),
                                   part.parts.b->pixels.channel(channel.b)));
    }
    for (const LayerComparison& layer : part.layers) {
      if (!layer.visible) continue;
      const std::span<const float> errors = layer.visible->flip.errors.channel(0);
      data.add(free_name(layer.name == "RGB" ? "FLIP.E" : layer.name + ".FLIP.E"),
               {errors.begin(), errors.end()});
      if (!layer.visible->hdr_flip) continue;
      const std::span<const float> hdr = layer.visible->hdr_flip->flip.errors.channel(0);
      data.add(free_name(layer.name == "RGB" ? "HDRFLIP.E" : layer.name + ".HDRFLIP.E"),
               {hdr.begin(), hdr.end()});
    }
  }
};

}  // namespace

Result<DifferencePicture> difference_picture(const Comparison& comparison) {
  if (comparison.parts.empty()) {
    return Error{ErrorCode::usage,
                 "there is no difference picture, for nothing in A and B could be compared"};
  }
  DifferencePicture result;
  const render::ExrPart& first = *comparison.parts.front().parts.a;
  Parts parts;
  for (const PartComparison& part : comparison.parts) {
    if (part.parts.a->data_window == first.data_window) {
      parts.add(part);
    } else {
      result.left_out.push_back(fmt::format(
          "part `{}` is not in the difference picture: it has another data window than the first",
          part.parts.a->name));
    }
  }
  render::ExrFile& file = result.file;
  file.display_window = first.display_window;
  file.data_window = first.data_window;
  file.beauty_type = render::SampleType::float32;
  // A file needs a first part; without colours the data are it.
  if (parts.beauty.empty()) std::swap(parts.beauty, parts.data);
  file.beauty = parts.beauty.buffer(file.data_window);
  file.data = parts.data.buffer(file.data_window);
  file.metadata.chromaticities = chromaticities_of(first);
  return result;
}

}  // namespace alhazen

#include "app/cli/provenance.h"

#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/cli/render_values.h"
#include "app/cli/version.h"
#include "core/base/hash.h"
#include "render/image/exr_read.h"

namespace alhazen {
namespace {

std::string hexadecimal(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

nlohmann::ordered_json options(const RenderRequest& request,
                               const std::vector<parser::Define>& defines,
                               const RenderSettings& settings) {
  nlohmann::ordered_json json = {
      {"size", {settings.width, settings.height}},
      {"samples", settings.samples},
      {"max_depth", settings.max_depth},
      {"cutoff", settings.cutoff},
      {"filter", {{"kind", name(settings.filter.kind)}, {"radius", settings.filter.radius}}},
      {"transparent_background", settings.transparent_background},
      {"seed", settings.seed},
      {"aov", aov_names(request.aovs)},
      {"channels", request.beauty == SamplePrecision::half ? "half" : "float"},
  };
  if (settings.adaptive) {
    json["adaptive"] = {{"threshold", settings.adaptive->threshold},
                        {"min_samples", settings.adaptive->min_samples}};
  }
  if (request.crop) {
    json["crop"] = {request.crop->x, request.crop->y, request.crop->width, request.crop->height};
  }
  for (const parser::Define& define : defines)
    json["define"][define.name] = define.text;
  return json;
}

// How the preview shows the picture; the meaning of the default is the colour configuration's.
nlohmann::ordered_json preview_options(const RenderRequest& request) {
  return {{"display", request.display}, {"view", request.view}};
}

}  // namespace

Provenance provenance(const RenderRequest& request, const std::vector<parser::Define>& defines,
                      const Scene& scene, std::uint64_t images_hash,
                      const render::ColorConfig& colors) {
  Provenance made_by = {{"version", program_version()},
                        {"sceneHash", hexadecimal(scene.hash)},
                        {"imagesHash", hexadecimal(images_hash)},
                        {"colorHash", hexadecimal(fnv1a_64(colors.serialize()))},
                        {"precision", std::string(name(request.precision))},
                        {"options", options(request, defines, scene.settings).dump()}};
  if (!request.preview.empty()) made_by.emplace_back("preview", preview_options(request).dump());
  return made_by;
}

bool is_made_by(const std::string& path, const Provenance& provenance) {
  // A file of ours may be of any size that was rendered.
  render::ImageLimits limits;
  limits.max_pixels = limits.max_samples = limits.max_file_bytes =
      std::numeric_limits<std::uint64_t>::max();
  const auto parts = render::read_exr(path, limits);
  if (!parts || parts.value().empty()) return false;
  const auto& attributes = parts.value().front().attributes;
  for (const auto& [key, value] : provenance) {
    const auto found = attributes.find(render::kAttributePrefix + key);
    if (found == attributes.end() || found->second != value) return false;
  }
  return true;
}

}  // namespace alhazen

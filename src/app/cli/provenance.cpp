#include "app/cli/provenance.h"

#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/cli/accuracy_text.h"
#include "app/cli/render_values.h"
#include "app/cli/version.h"
#include "core/base/hash.h"
#include "render/image/exr_read.h"

namespace alhazen {
namespace {

constexpr const char *kTargetKey = "target", *kTargetReached = "reached";

std::string hexadecimal(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

nlohmann::ordered_json options(const RenderRequest& request,
                               const std::vector<parser::Define>& defines,
                               const RenderSettings& settings) {
  nlohmann::ordered_json json = {{"size", {settings.width, settings.height}}};
  if (settings.max_error) {
    json["max_error"] = error_target_text(*settings.max_error);
  } else {
    json["samples"] = settings.samples;
    json["max_depth"] = settings.max_depth;
    json["cutoff"] = settings.cutoff;
  }
  json["filter"] = {{"kind", name(settings.filter.kind)}, {"radius", settings.filter.radius}};
  json["transparent_background"] = settings.transparent_background;
  json["seed"] = settings.seed;
  json["aov"] = aov_names(request.aovs);
  json["channels"] = request.beauty == SamplePrecision::half ? "half" : "float";
  if (settings.adaptive && !settings.max_error) {
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
  // A picture that fell short is to be made again.
  if (scene.settings.max_error) made_by.emplace_back(kTargetKey, kTargetReached);
  if (!request.preview.empty()) made_by.emplace_back("preview", preview_options(request).dump());
  return made_by;
}

void tell_accuracy(const render::AccuracyReport& report, Provenance& provenance) {
  const nlohmann::ordered_json json = accuracy_json(report);
  for (auto& [key, value] : provenance) {
    if (key == kTargetKey) value = json["end"];
  }
  provenance.emplace_back("accuracy", json.dump());
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

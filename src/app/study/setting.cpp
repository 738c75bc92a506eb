#include "app/study/setting.h"

#include <cmath>
#include <fmt/format.h>

namespace alhazen {
namespace {

bool is_same(const std::optional<AdaptiveSampling>& a, const std::optional<AdaptiveSampling>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->threshold == b->threshold && a->min_samples == b->min_samples;
}

bool is_same(const std::optional<ErrorTarget>& a, const std::optional<ErrorTarget>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->error == b->error && a->share == b->share;
}

bool is_same(const RenderSettings& a, const RenderSettings& b) {
  return a.width == b.width && a.height == b.height && a.samples == b.samples &&
         is_same(a.adaptive, b.adaptive) && is_same(a.max_error, b.max_error) &&
         a.max_depth == b.max_depth && a.cutoff == b.cutoff && a.filter.kind == b.filter.kind &&
         a.filter.radius == b.filter.radius && a.seed == b.seed;
}

}  // namespace

bool is_same(const StudySetting& a, const StudySetting& b) {
  return is_same(a.settings, b.settings) && a.light_samples == b.light_samples &&
         a.precision == b.precision;
}

Scene scene_with(const Scene& scene, const StudySetting& setting) {
  Scene changed = scene;
  changed.settings = setting.settings;
  if (!setting.light_samples) return changed;
  for (Light& light : changed.lights) {
    if (auto* sphere = std::get_if<SphereLight>(&light.source)) {
      sphere->samples = *setting.light_samples;
    }
    if (auto* rectangle = std::get_if<RectangleLight>(&light.source)) {
      rectangle->samples = *setting.light_samples;
    }
  }
  return changed;
}

std::string_view setting_name(render::Precision precision) {
  switch (precision) {
    case render::Precision::float32:
      return "float";
    case render::Precision::float64:
      return "double";
    case render::Precision::quad:
      break;
  }
  return "quad";
}

std::string_view setting_name(FilterKind kind) {
  switch (kind) {
    case FilterKind::box:
      return "box";
    case FilterKind::tent:
      return "tent";
    case FilterKind::gaussian:
      return "gaussian";
    case FilterKind::mitchell:
      break;
  }
  return "mitchell";
}

std::string cutoff_text(double cutoff) {
  const double inverse = cutoff > 0 ? std::round(1 / cutoff) : 0;
  if (inverse > 1 && inverse < 1e6 && 1 / inverse == cutoff) return fmt::format("1/{}", inverse);
  return fmt::format("{:.3g}", cutoff);
}

namespace {

std::string target_text(const ErrorTarget& target) {
  const std::string text = "max-error " + cutoff_text(target.error);
  return target.share > 0 ? fmt::format("{} in {:.4g} % of the pixels", text, 100 * target.share)
                          : text;
}

std::string samples_text(const RenderSettings& s) {
  if (s.max_error) return target_text(*s.max_error);
  if (!s.adaptive) return fmt::format("{} sample{}", s.samples, s.samples == 1 ? "" : "s");
  return fmt::format("adaptive {:.3g}, {} to {} samples", s.adaptive->threshold,
                     s.adaptive->min_samples, s.samples);
}

std::string text_of(const StudySetting& setting, const StudySetting* own) {
  const RenderSettings& s = setting.settings;
  std::string text = samples_text(s);
  if (setting.light_samples) {
    text += fmt::format(", {} light sample{}", *setting.light_samples,
                        *setting.light_samples == 1 ? "" : "s");
  }
  const bool is_chosen = s.max_error.has_value();
  if (!is_chosen && (own == nullptr || s.max_depth != own->settings.max_depth)) {
    text += fmt::format(", depth {}", s.max_depth);
  }
  if (!is_chosen && (own == nullptr || s.cutoff != own->settings.cutoff)) {
    text += fmt::format(", cutoff {}", cutoff_text(s.cutoff));
  }
  if (own == nullptr || s.filter.kind != own->settings.filter.kind) {
    text += fmt::format(", {}", setting_name(s.filter.kind));
  }
  if (setting.precision != render::Precision::float64) {
    text += fmt::format(", {}", setting_name(setting.precision));
  }
  return text;
}

}  // namespace

std::string describe(const StudySetting& setting) {
  return text_of(setting, nullptr);
}

std::string describe_beside(const StudySetting& setting, const StudySetting& own) {
  return text_of(setting, &own);
}

}  // namespace alhazen

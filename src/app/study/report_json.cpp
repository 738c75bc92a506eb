// app/study: everything but the pictures.
#include <nlohmann/json.hpp>

#include "app/study/conclusions.h"
#include "app/study/report_data.h"
#include "app/study/study_charts.h"

namespace alhazen {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json optional(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json spread_json(const Spread& spread) {
  return {{"median", spread.median}, {"low", spread.low}, {"high", spread.high}};
}

Json errors_json(const PictureErrors& e) {
  return {{"rmse", e.rmse},
          {"relative_mse", e.relative_mse},
          {"largest", e.largest},
          {"pixels_over", e.pixels_over},
          {"pixels", e.pixels},
          {"flip", e.flip},
          {"not_finite", e.not_finite}};
}

Json point_json(const SceneStudy& study, const StudyPoint& p) {
  Json json = {{"curve", info(p.setting.knob).name},
               {"settings", setting_text(study, p)},
               {"scene", p.setting.is_scene},
               {"shown", p.is_shown()},
               {"runs", p.runs},
               {"cpu_seconds", spread_json(p.cpu)},
               {"wall_seconds", spread_json(p.wall)},
               {"errors", errors_json(p.errors)},
               {"floor", p.floor},
               {"truncation_rmse", optional(p.truncation_rmse)}};
  if (p.is_povray()) return json;
  const RenderSettings& s = p.setting.settings;
  json["samples"] = s.samples;
  json["adaptive_threshold"] = s.adaptive ? Json(s.adaptive->threshold) : Json(nullptr);
  json["max_error"] = s.max_error ? Json(s.max_error->error) : Json(nullptr);
  json["depth"] = s.max_depth;
  json["cutoff"] = s.cutoff;
  json["filter"] = setting_name(s.filter.kind);
  json["light_samples"] = optional(p.setting.light_samples);
  json["precision"] = setting_name(p.setting.precision);
  json["samples_a_pixel"] = p.samples_a_pixel;
  json["rays"] = {{"camera", p.statistics.camera_rays},
                  {"reflection", p.statistics.reflection_rays},
                  {"refraction", p.statistics.refraction_rays},
                  {"shadow", p.statistics.shadow_rays}};
  return json;
}

Json time_json(const std::optional<TimeAtError>& time) {
  if (!time) return nullptr;
  return {{"cpu_seconds", time->seconds}, {"at_most", time->at_most}};
}

Json povray_json(const SceneStudy& study) {
  const PovrayStudy& povray = *study.povray;
  Json equal = Json::array();
  for (const EqualError& row : equal_errors(study)) {
    equal.push_back({{"rmse", row.rmse},
                     {"ours", time_json(row.ours)},
                     {"povray", time_json(row.povray)},
                     {"ratio", optional(row.ratio())}});
  }
  return {{"failure", povray.failure},     {"deviations", povray.deviations},
          {"reference", povray.reference}, {"floor", povray.floor},
          {"from_ours", povray.from_ours}, {"equal_error", std::move(equal)}};
}

Json rounding_json(const RoundingStudy& rounding) {
  Json types = Json::array();
  for (const RoundingPoint& p : rounding.points) {
    types.push_back({{"precision", setting_name(p.precision)},
                     {"cpu_seconds", spread_json(p.cpu)},
                     {"errors", errors_json(p.errors)}});
  }
  return {{"samples", rounding.samples}, {"gain", optional(rounding.gain())}, {"types", types}};
}

}  // namespace

Json study_json(const SceneStudy& study) {
  Json points = Json::array(), left_out = Json::array(), filters = Json::array();
  for (const StudyPoint& point : study.points)
    points.push_back(point_json(study, point));
  for (const LeftOut& left : study.left_out)
    left_out.push_back({{"what", left.what}, {"why", left.why}});
  for (const FilterReference& filter : study.filter_references) {
    filters.push_back({{"filter", setting_name(filter.filter)},
                       {"samples", filter.samples},
                       {"own_error", filter.own_error}});
  }
  Json json = {{"scene", study.name},
               {"size", {study.width, study.height}},
               {"own_size", {study.own_width, study.own_height}},
               {"threads", study.threads},
               {"isa", render::info(study.isa).name},
               {"seconds", study.seconds},
               {"conclusions", conclusions(study)},
               {"reference",
                {{"samples", study.reference.samples},
                 {"depth", study.reference.max_depth},
                 {"cutoff", study.reference.cutoff},
                 {"filter", setting_name(study.reference.filter.kind)},
                 {"sampling_error", study.sampling_error},
                 {"truncation_error", study.truncation_error},
                 {"floor", study.floor()}}},
               {"filter_references", std::move(filters)},
               {"points", std::move(points)},
               {"front", front_of(study, false)},
               {"left_out", std::move(left_out)}};
  if (study.rounding) json["rounding"] = rounding_json(*study.rounding);
  if (study.povray) json["povray"] = povray_json(study);
  return json;
}

}  // namespace alhazen

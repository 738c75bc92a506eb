// app/study: one line a point.
#include <fmt/format.h>

#include "app/study/conclusions.h"
#include "app/study/report_data.h"

namespace alhazen {
namespace {

// RFC 4180: a field with commas or quotes stands in quotes, and quotes in it are doubled.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) {
    out += c;
    if (c == '"') out += c;
  }
  return out + '"';
}

}  // namespace

std::string study_csv(const SceneStudy& study) {
  std::string text =
      "scene,curve,settings,is_scene,shown,runs,cpu_seconds,cpu_low,cpu_high,wall_seconds,wall_low,"
      "wall_high,rmse,floor,truncation_rmse,relative_mse,largest,pixels_over,pixels,flip,not_"
      "finite,"
      "samples_a_pixel,camera_rays,reflection_rays,refraction_rays,shadow_rays\n";
  for (const StudyPoint& p : study.points) {
    const render::RenderStatistics& s = p.statistics;
    text += fmt::format(
        "{},{},{},{:d},{:d},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
        quoted(study.name), info(p.setting.knob).name, quoted(setting_text(study, p)),
        p.setting.is_scene, p.is_shown(), p.runs, p.cpu.median, p.cpu.low, p.cpu.high,
        p.wall.median, p.wall.low, p.wall.high, p.errors.rmse, p.floor,
        p.truncation_rmse ? fmt::format("{}", *p.truncation_rmse) : "", p.errors.relative_mse,
        p.errors.largest, p.errors.pixels_over, p.errors.pixels, p.errors.flip, p.errors.not_finite,
        p.samples_a_pixel, s.camera_rays, s.reflection_rays, s.refraction_rays, s.shadow_rays);
  }
  return text;
}

}  // namespace alhazen

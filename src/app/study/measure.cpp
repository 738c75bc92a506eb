#include "app/study/measure.h"

#include <algorithm>

namespace alhazen {

std::vector<Measured> different_settings(std::span<const StudySetting> settings) {
  std::vector<Measured> out;
  for (const StudySetting& setting : settings) {
    const auto same = [&](const Measured& m) { return is_same(m.setting, setting); };
    if (std::ranges::none_of(out, same)) out.push_back({setting, {}, {}, {}});
  }
  return out;
}

std::vector<StudyPoint> points_of(std::span<const StudySetting> settings,
                                  std::span<const Measured> measured) {
  std::vector<StudyPoint> points;
  for (const StudySetting& setting : settings) {
    const auto same = [&](const Measured& m) { return is_same(m.setting, setting); };
    const auto found = std::ranges::find_if(measured, same);
    StudyPoint point = found->point;
    point.setting = setting;
    point.runs = static_cast<int>(found->cpu.size());
    point.cpu = spread_of(found->cpu);
    point.wall = spread_of(found->wall);
    const bool truncates = setting.knob == Knob::depth || setting.knob == Knob::cutoff;
    if (!truncates) point.truncation_rmse.reset();
    points.push_back(std::move(point));
  }
  return points;
}

Status Measuring::run(Measured& measured) const {
  const auto made = timed_render(run_, measured.setting);
  if (!made) return made.error();
  const TimedRender& render = made.value();
  measured.cpu.push_back(render.cpu_seconds);
  measured.wall.push_back(render.wall_seconds);
  if (measured.cpu.size() > 1) return Unit{};
  StudyPoint& point = measured.point;
  const Reference& reference = references.at(measured.setting.settings.filter.kind);
  point.statistics = render.statistics;
  point.samples_a_pixel = static_cast<double>(render.statistics.samples) /
                          static_cast<double>(render.picture.pixel_count());
  point.errors = errors_of(render.picture, reference.picture, look);
  point.floor = reference.floor();
  if (untruncated) point.truncation_rmse = rmse_of(render.picture, *untruncated);
  point.pictures = study_pictures(render.picture, reference.picture, window, view);
  return Unit{};
}

Result<RoundingStudy> measure_rounding(const RenderRun& run, const StudySetting& setting, int runs,
                                       const DisplayLook& look) {
  const auto exact = timed_render(run, setting);
  if (!exact) return exact.error();
  RoundingStudy study{setting.settings.samples, {}};
  for (const auto precision : {render::Precision::float32, render::Precision::float64}) {
    StudySetting other = setting;
    other.precision = precision;
    std::vector<double> cpu;
    RoundingPoint point{precision, {}, {}};
    for (int k = 0; k < runs; ++k) {
      const auto made = timed_render(run, other);
      if (!made) return made.error();
      cpu.push_back(made.value().cpu_seconds);
      if (k == 0) point.errors = errors_of(made.value().picture, exact.value().picture, look);
    }
    point.cpu = spread_of(std::move(cpu));
    study.points.push_back(std::move(point));
  }
  study.points.push_back({render::Precision::quad, spread_of({exact.value().cpu_seconds}), {}});
  return study;
}

int most_light_samples(const Scene& scene) {
  int most = 1;
  for (const Light& light : scene.lights) {
    if (!light.casts_shadows) continue;
    if (const auto* sphere = std::get_if<SphereLight>(&light.source)) {
      most = std::max(most, sphere->samples);
    }
    if (const auto* rectangle = std::get_if<RectangleLight>(&light.source)) {
      most = std::max(most, rectangle->samples);
    }
  }
  return most;
}

}  // namespace alhazen

#include "app/cli/statistics.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "app/cli/accuracy_text.h"
#include "app/cli/quantity_text.h"
#include "app/cli/render_values.h"
#include "app/cli/stage_costs.h"

namespace alhazen {
namespace {

std::string ray_lines(const render::RenderStatistics& s) {
  std::string text = fmt::format("  {:<22}{:>10}\n", "rays", count_text(double(s.rays())));
  const std::pair<const char*, std::uint64_t> kinds[] = {{"camera", s.camera_rays},
                                                         {"reflected", s.reflection_rays},
                                                         {"refracted", s.refraction_rays},
                                                         {"shadow", s.shadow_rays}};
  for (const auto& [kind, count] : kinds) {
    if (count > 0) text += fmt::format("    {:<20}{:>10}\n", kind, count_text(double(count)));
  }
  if (s.cut_by_depth > 0) {
    text += fmt::format("  {} rays ended at --max-depth\n", count_text(double(s.cut_by_depth)));
  }
  if (s.cut_by_weight > 0) {
    text += fmt::format("  {} rays were below --cutoff\n", count_text(double(s.cut_by_weight)));
  }
  return text;
}

std::string stage_lines(const render::RenderStatistics& s) {
  const StageCosts costs{s.stages, s.cpu_seconds};
  std::string text = fmt::format("  {:<22}{}\n", "stages", stage_cost_heading());
  for (const render::StageCost& stage : s.stages) {
    text += fmt::format("    {:<20}{}\n", render::info(stage.stage).name,
                        stage_cost_row(stage, s.cpu_seconds));
  }
  return text + fmt::format("    {:<20}{}\n", "everything else", other_cost_row(costs));
}

nlohmann::ordered_json to_json(const PictureReport& report) {
  const render::RenderStatistics& s = report.rendering;
  nlohmann::ordered_json stages = nlohmann::ordered_json::array();
  for (const render::StageCost& stage : s.stages) {
    stages.push_back({{"name", render::info(stage.stage).name},
                      {"rays", stage.rays},
                      {"cpu_seconds", stage.cpu_seconds}});
  }
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const WrittenFile& file : report.files) {
    files.push_back({{"path", file.path}, {"bytes", file.bytes}});
  }
  nlohmann::ordered_json json = {
      {"scene", report.scene},
      {"size", {report.width, report.height}},
      {"window", {report.window.x, report.window.y, report.window.width, report.window.height}},
      {"precision", name(report.precision)},
      {"threads", s.threads},
      {"isa", render::info(s.isa).name},
      {"samples", s.samples},
      {"rays",
       {{"camera", s.camera_rays},
        {"reflection", s.reflection_rays},
        {"refraction", s.refraction_rays},
        {"shadow", s.shadow_rays},
        {"total", s.rays()},
        {"cut_by_depth", s.cut_by_depth},
        {"cut_by_weight", s.cut_by_weight}}},
      {"dropped_weight_max", s.dropped_weight_max},
      {"stages", stages},
      {"seconds",
       {{"load", report.load_seconds},
        {"render", s.wall_seconds},
        {"render_cpu", s.cpu_seconds},
        {"write", report.write_seconds}}},
      {"peak_memory_bytes", report.peak_memory_bytes},
      {"non_finite_samples", report.samples.non_finite},
      {"clamped_samples", report.samples.clamped},
      {"files", files}};
  if (report.accuracy) json["accuracy"] = accuracy_json(*report.accuracy);
  if (!report.label.empty()) json["label"] = report.label;
  return json;
}

}  // namespace

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  if (::getrusage(RUSAGE_SELF, &usage) != 0) return 0;
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

std::string statistics_text(const PictureReport& report) {
  const render::RenderStatistics& s = report.rendering;
  std::string text = report.scene;
  if (!report.label.empty()) text += ", " + report.label;
  text += fmt::format(": {}x{} pixels", report.window.width, report.window.height);
  if (report.window.width != report.width || report.window.height != report.height) {
    text += fmt::format(" of {}x{}", report.width, report.height);
  }
  const double pixels = double(report.window.width) * double(report.window.height);
  text += fmt::format(", {:.3g} samples a pixel\n", double(s.samples) / pixels);
  if (report.accuracy) text += accuracy_text(*report.accuracy);
  text += ray_lines(s) + stage_lines(s);
  text += fmt::format("  {:<22}{:>10}  ({} CPU on {} threads with {}, {} rays/s)\n", "rendered in",
                      seconds_text(s.wall_seconds), seconds_text(s.cpu_seconds), s.threads,
                      render::info(s.isa).name,
                      count_text(double(s.rays()) / std::max(s.wall_seconds, 1e-9)));
  text += fmt::format("  {:<22}{:>10}\n", "loaded, written in",
                      seconds_text(report.load_seconds + report.write_seconds));
  text += fmt::format("  {:<22}{:>10}\n", "peak memory", bytes_text(report.peak_memory_bytes));
  if (report.samples.non_finite > 0) {
    text += fmt::format("  warning: {} samples were not finite and were written as 0\n",
                        report.samples.non_finite);
  }
  if (report.samples.clamped > 0) {
    text += fmt::format("  note: {} samples were too bright for 16 bits; --float keeps them\n",
                        report.samples.clamped);
  }
  for (const WrittenFile& file : report.files) {
    text += fmt::format("  {} ({})\n", file.path == "-" ? "standard output" : file.path,
                        bytes_text(file.bytes));
  }
  return text;
}

std::string statistics_json(const PictureReport& report) {
  return to_json(report).dump(2) + "\n";
}

std::string statistics_json(const std::vector<PictureReport>& reports) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const PictureReport& report : reports)
    list.push_back(to_json(report));
  return list.dump(2) + "\n";
}

}  // namespace alhazen

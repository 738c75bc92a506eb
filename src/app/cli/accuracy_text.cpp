#include "app/cli/accuracy_text.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/render_values.h"

namespace alhazen {
namespace {

using render::AccuracyEnd;
using render::AccuracyReport;

std::string_view name(AccuracyEnd end) {
  switch (end) {
    case AccuracyEnd::reached:
      return "reached";
    case AccuracyEnd::out_of_time:
      return "out of time";
    case AccuracyEnd::out_of_samples:
      return "out of samples";
    case AccuracyEnd::out_of_depth:
      break;
  }
  return "out of depth";
}

// What depth and cutoff leave out.
std::string beyond_text(const AccuracyReport& report) {
  return std::isfinite(report.truncation) ? fmt::format("RMS {:.2g}", report.truncation)
                                          : "more than there is so far";
}

// "RMSE 0.0038", "1.2% of the pixels off by more than 1/255".
std::string error_text(const AccuracyReport& report, double error) {
  if (report.target.share == 0) return fmt::format("RMSE {:.3g}", error);
  return fmt::format("{:.3g}% of the pixels off by more than {}", 100 * error,
                     error_target_text({report.target.error, 0}));
}

}  // namespace

std::string accuracy_text(const AccuracyReport& report) {
  std::string text;
  if (std::isfinite(report.bound)) {
    const bool counts = report.target.share > 0;
    text =
        fmt::format("  {:<22}{}, at most {:.3g}{} with {:.0f}% confidence\n", "estimated error",
                    error_text(report, report.estimate), counts ? 100 * report.bound : report.bound,
                    counts ? "%" : "", 100 * report.confidence);
  } else {
    text = fmt::format("  {:<22}has no bound\n", "estimated error");
  }
  return text + fmt::format("  {:<22}{} passes, depth {}, cutoff {:.2g}; light beyond: {}\n", "",
                            report.passes, report.max_depth, report.cutoff, beyond_text(report));
}

std::string shortfall_text(const AccuracyReport& report) {
  const std::string target = error_target_text(report.target);
  const std::string got = error_text(report, report.bound);
  switch (report.end) {
    case AccuracyEnd::reached:
      break;
    case AccuracyEnd::out_of_time:
      return fmt::format(
          "--max-error {} was not reached: the time limit came first; the picture is "
          "complete, with at most {}",
          target, got);
    case AccuracyEnd::out_of_samples:
      return fmt::format(
          "--max-error {} was not reached: pixels have {} samples, which is the most "
          "there is; the picture has at most {}",
          target, kMaxSamples, got);
    case AccuracyEnd::out_of_depth:
      return fmt::format(
          "--max-error {} was not reached: light still comes from beyond {} reflections: {}",
          target, report.max_depth, beyond_text(report));
  }
  return {};
}

nlohmann::ordered_json accuracy_json(const AccuracyReport& report) {
  nlohmann::ordered_json json = {{"target", error_target_text(report.target)},
                                 {"measure", report.target.share > 0 ? "share over" : "rmse"},
                                 {"end", name(report.end)},
                                 {"estimate", report.estimate},
                                 {"bound", report.bound},
                                 {"confidence", report.confidence},
                                 {"truncation", report.truncation},
                                 {"max_depth", report.max_depth},
                                 {"cutoff", report.cutoff},
                                 {"passes", report.passes}};
  return json;
}

ExitCode exit_code(const AccuracyReport& report) {
  switch (report.end) {
    case AccuracyEnd::reached:
      return ExitCode::done;
    case AccuracyEnd::out_of_time:
      return ExitCode::stopped;
    case AccuracyEnd::out_of_samples:
    case AccuracyEnd::out_of_depth:
      break;
  }
  return ExitCode::limit;
}

}  // namespace alhazen

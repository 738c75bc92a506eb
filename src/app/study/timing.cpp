#include "app/study/timing.h"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace alhazen {

double process_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Spread spread_of(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  const double median =
      values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
  return {median, values.front(), values.back()};
}

Result<TimedRender> timed_render(const RenderRun& run, const StudySetting& setting) {
  const Scene scene = scene_with(run.scene, setting);
  render::RenderOptions options;
  options.precision = setting.precision;
  options.threads = run.threads;
  options.isa = run.isa;
  options.cancel = run.cancel;
  const auto start = std::chrono::steady_clock::now();
  const double cpu_before = process_cpu_seconds();
  Result<render::RenderOutput> output = render::render(scene, run.images, options);
  const double cpu = process_cpu_seconds() - cpu_before;
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  if (!output) return output.error();
  return TimedRender{rgb_of(output.value().picture), std::move(output.value().statistics), cpu,
                     wall.count()};
}

}  // namespace alhazen

// app/study: times of runs, and rendering with a clock beside it.
#pragma once

#include <atomic>
#include <optional>
#include <span>
#include <vector>

#include "app/study/picture_errors.h"
#include "app/study/setting.h"
#include "core/base/result.h"
#include "render/wave/render.h"

namespace alhazen {

// Median and extremes of several measurements.
struct Spread {
  double median = 0, low = 0, high = 0;
};

// The middle value, or the mean of the middle two. Precondition: there is one.
Spread spread_of(std::vector<double> values);

// Of this process so far, all threads together.
double process_cpu_seconds();

// What renderings have in common.
struct RenderRun {
  const Scene& scene;
  const std::vector<render::ImagePixels>& images;
  int threads = 1;
  std::optional<render::Isa> isa;
  const std::atomic<bool>* cancel = nullptr;
};

struct TimedRender {
  RgbPicture picture;
  render::RenderStatistics statistics;
  double cpu_seconds = 0;  // of the whole process, with building the tree
  double wall_seconds = 0;
};

// Renders in this process. Fails as render::render does.
Result<TimedRender> timed_render(const RenderRun& run, const StudySetting& setting);

}  // namespace alhazen

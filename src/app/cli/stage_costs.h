// app/cli: what each stage of a render cost: a table for people, and the same read back from the
// file that `alhazen render --stats` has written.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "render/wave/render.h"

namespace alhazen {

struct StageCosts {
  std::vector<render::StageCost> stages;  // in the order in which they run
  double cpu_seconds = 0;                 // of the whole render

  const render::StageCost* of(render::StageId stage) const;
};

// What `alhazen render --stats` wrote; the figures of several frames are added up. `name` is the
// file's, for messages. Errors: io, for what is not such a file.
Result<StageCosts> read_stage_costs(const std::string& name, const std::string& json);

// Four columns: rays or other items, CPU time, its share of the whole, nanoseconds an item. Heading
// and rows are equally long, without the end of the line.
std::string stage_cost_heading();
std::string stage_cost_row(const render::StageCost& cost, double cpu_seconds);
// Time that no stage accounts for: making tiles, sums of samples, pixels.
std::string other_cost_row(const StageCosts& costs);

}  // namespace alhazen

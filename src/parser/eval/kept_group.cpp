#include "parser/eval/kept_group.h"

#include <utility>

#include "parser/eval/group_survey.h"

namespace alhazen::parser {

void KeptGroup::add(Shape shape) {
  const bool has_bounds = !std::holds_alternative<Plane>(shape.geometry);
  const Run* last = parts_.empty() ? nullptr : std::get_if<Run>(&parts_.back());
  if (last == nullptr || last->has_bounds != has_bounds) parts_.emplace_back(Run());
  Run& run = std::get<Run>(parts_.back());
  run.has_bounds = has_bounds;
  const ShapeId number = ++run.counts[shape.geometry.index()];
  if (shape.number != 0) shape.number = number;
  run.asks_for_material = run.asks_for_material || shape.material == kNoId;
  run.shapes.push_back(shape);
  ++run.size;
}

void KeptGroup::keep_long_runs(SceneShapes& scene, UsedRecords& used) {
  for (Part& part : parts_) {
    auto* run = std::get_if<Run>(&part);
    if (run == nullptr || !run->has_bounds || run->size < kLeastShared) continue;
    ShapeList kept;
    for (Shape shape : std::exchange(run->shapes, {})) {
      if (shape.material != kNoId) shape.material = used.material(shape.material);
      kept.push_back(shape);
    }
    run->prototype = scene.add_prototype(std::move(kept));
  }
}

}  // namespace alhazen::parser

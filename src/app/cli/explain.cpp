// app/cli: alhazen explain: which effects a scene calls for, and which stages they start.
#include "app/cli/explain_plan.h"
#include "app/cli/scene_options.h"
#include "app/cli/streams.h"
#include "core/base/file.h"

namespace alhazen {
namespace {

constexpr std::uint64_t kMaxStatisticsBytes = std::uint64_t{256} << 20;

Result<StageCosts> load_costs(const std::string& path, const render::StagePlan& plan) {
  const Result<std::string> text = read_file(path, kMaxStatisticsBytes);
  if (!text) return text.error();
  Result<StageCosts> costs = read_stage_costs(path, text.value());
  if (!costs) return costs;
  const Status fits = check_costs(plan, costs.value(), path);
  if (!fits) return fits.error();
  return costs;
}

}  // namespace

ExitCode run_explain(const Arguments& arguments) {
  CommandLine line("explain",
                   "Says which effects a scene calls for, which stages of the renderer they\n"
                   "start, and which lines of the scene call for them. What is not called for\n"
                   "does not run. After a render it also says what each stage has cost.",
                   "  alhazen explain scene.scn\n"
                   "  alhazen render scene.scn --stats cost.json\n"
                   "  alhazen explain scene.scn --stats cost.json\n"
                   "  alhazen explain scene.scn --json | jq '.stages[].name'\n");
  SceneOptions options;
  bool json = false;
  add_scene_options(line, options);
  add_format_options(line, "stdout", json);
  std::string statistics;
  line.text_option("--stats", "FILE", statistics,
                   "what `alhazen render --stats FILE` has written for this scene");
  if (const auto code = line.read(arguments)) return *code;

  LoadedScene loaded;
  if (const auto code = load_scene(options, loaded)) return *code;
  const Scene& scene = *loaded.evaluation.scene;
  const EffectSet effects = render::effects_of(scene);
  const render::StagePlan plan = render::make_plan(scene, effects);
  ExplainedPlan explained{effects, plan, loaded.sources};
  StageCosts costs;
  if (!statistics.empty()) {
    Result<StageCosts> read = load_costs(statistics, plan);
    if (!read) return report(read.error());
    costs = std::move(read).value();
    explained.costs = &costs;
  }
  return print(json ? explain_json(explained) : explain_text(explained));
}

}  // namespace alhazen

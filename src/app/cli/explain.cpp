// app/cli: alhazen explain: which effects a scene calls for, and which stages they start.
#include "app/cli/scene_options.h"
#include "app/cli/streams.h"
#include "render/wave/plan.h"

namespace alhazen {

ExitCode run_explain(const Arguments& arguments) {
  CommandLine line("explain",
                   "Says which effects a scene calls for, which stages of the renderer they\n"
                   "start, and which lines of the scene call for them. What is not called for\n"
                   "does not run.",
                   "  alhazen explain scene.scn\n"
                   "  alhazen explain scene.scn --json | jq '.stages[].name'\n");
  SceneOptions options;
  bool json = false;
  add_scene_options(line, options);
  add_format_options(line, "stdout", json);
  if (const auto code = line.read(arguments)) return *code;

  LoadedScene loaded;
  if (const auto code = load_scene(options, loaded)) return *code;
  const Scene& scene = *loaded.evaluation.scene;
  const EffectSet effects = render::effects_of(scene);
  const render::StagePlan plan = render::make_plan(scene, effects);
  return print(json ? render::explain_json(plan, effects, loaded.sources)
                    : render::explain_text(plan, effects, loaded.sources));
}

}  // namespace alhazen

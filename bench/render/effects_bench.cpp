// Renders one scene in double on one thread, for bench/effects to count instructions of: all that
// happens from a scene to its pixels, and nothing else, happens inside of measured_render().
//   bench_effects SCENE.scn WIDTH HEIGHT
// Prints "not in this build" if the scene calls for an effect that was left out.
#include <cstdio>
#include <cstdlib>

#include "parser/eval/evaluate.h"
#include "render/wave/render_scene.h"

using namespace alhazen;

// The name by which callgrind knows when to count.
extern "C" [[gnu::noinline]] double measured_render(const Scene& scene) {
  const std::vector<render::ImagePixels> images(scene.images.size(), {1, 1, {0.25F, 0.5F, 0.75F}});
  render::RenderOptions options;
  options.threads = 1;
  const render::StagePlan plan = render::make_plan(scene, render::effects_of(scene));
  const render::PixelRect window{0, 0, scene.settings.width, scene.settings.height};
  const auto output = render::render_scene<double>(
      {scene, images, options, plan, window, render::ProgressListener()});
  double sum = 0;
  if (output) {
    for (const double value : output.value().picture.rgb)
      sum += value;
  }
  return sum;
}

int main(int count, char** words) {
  if (count != 4) {
    std::fputs("usage: bench_effects SCENE.scn WIDTH HEIGHT\n", stderr);
    return 2;
  }
  SourceManager sources;
  DiagnosticSink sink;
  parser::Evaluation read = parser::evaluate_file(words[1], sources, sink);
  if (!read.scene) {
    std::fputs("bench_effects: the scene is wrong\n", stderr);
    return 1;
  }
  read.scene->settings.width = std::atoi(words[2]);
  read.scene->settings.height = std::atoi(words[3]);
  if (!render::check_built_in(render::effects_of(*read.scene))) {
    std::puts("not in this build");
    return 0;
  }
  std::printf("%.17g\n", measured_render(*read.scene));
  return 0;
}

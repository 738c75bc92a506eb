#include "render/wave/render.h"

#include <exception>
#include <fmt/format.h>
#include <new>

#include "render/wave/render_precision.h"
#include "render/wave/render_scene.h"

namespace alhazen::render {
namespace {

Result<PixelRect> window_of(const RenderSettings& settings, PixelRect crop) {
  if (crop.width == 0 && crop.height == 0) return PixelRect{0, 0, settings.width, settings.height};
  const bool inside = crop.x >= 0 && crop.y >= 0 && crop.width > 0 && crop.height > 0 &&
                      crop.width <= settings.width - crop.x &&
                      crop.height <= settings.height - crop.y;
  if (inside) return crop;
  return Error{ErrorCode::usage,
               fmt::format("the crop {},{},{},{} does not lie in the frame of {}x{}", crop.x,
                           crop.y, crop.width, crop.height, settings.width, settings.height)};
}

Result<RenderOutput> render_in(Precision precision, Isa isa, const RenderJob& job) {
  if (precision == Precision::float32) return render_functions(isa).in_float(job);
  if (precision == Precision::float64) return render_functions(isa).in_double(job);
#if ALHAZEN_HAS_QUAD
  return render_in_quad(job);
#else
  return Error{ErrorCode::unsupported, "this build has no quad precision: it needs g++"};
#endif
}

}  // namespace

Result<RenderOutput> render(const Scene& scene, const std::vector<ImagePixels>& images,
                            const RenderOptions& options, const ProgressListener& progress) {
  const Result<PixelRect> window = window_of(scene.settings, options.crop);
  if (!window) return window.error();
  const Isa isa = options.isa.value_or(usable_isas().back());
  if (!is_compiled(isa) || !runs_here(isa)) {
    return Error{
        ErrorCode::unsupported,
        fmt::format("the instruction set {} is not {}: it needs {}", info(isa).name,
                    is_compiled(isa) ? "that of this processor" : "in this build", info(isa).text)};
  }
  const AovRequest& aovs = options.aovs;
  const PlanWants wants{aovs.albedo, aovs.signature, aovs.margin};
  const EffectSet effects = effects_of(scene, wants);
  const Status has_all = check_built_in(effects);
  if (!has_all) return has_all.error();
  const StagePlan plan = make_plan(scene, effects, wants);
  try {
    auto output =
        render_in(options.precision, isa, {scene, images, options, plan, window.value(), progress});
    if (output) output.value().statistics.isa = isa;
    return output;
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit, "out of memory"};
  }
}

}  // namespace alhazen::render

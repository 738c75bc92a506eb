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

Result<RenderOutput> render_in(Precision precision, const RenderJob& job) {
  switch (precision) {
    case Precision::float32:
      return render_in_float(job);
    case Precision::float64:
      return render_in_double(job);
    case Precision::quad:
      break;
  }
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
  const AovRequest& aovs = options.aovs;
  const StagePlan plan =
      make_plan(scene, effects_of(scene), {aovs.albedo, aovs.signature, aovs.margin});
  try {
    return render_in(options.precision, {scene, images, options, plan, window.value(), progress});
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit, "out of memory"};
  }
}

}  // namespace alhazen::render

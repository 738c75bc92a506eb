#include "render/wave/render_precision.h"
#include "render/wave/render_scene.h"

namespace alhazen::render::ALHAZEN_ISA_NAME {

Result<RenderOutput> render_in_double(const RenderJob& job) {
  return render_scene<double>(job);
}

}  // namespace alhazen::render::ALHAZEN_ISA_NAME

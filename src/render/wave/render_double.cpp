#include "render/wave/render_precision.h"
#include "render/wave/render_target.h"

namespace alhazen::render::ALHAZEN_ISA_NAME {

Result<RenderOutput> render_in_double(const RenderJob& job) {
  return render_in_one_type<double>(job);
}

}  // namespace alhazen::render::ALHAZEN_ISA_NAME

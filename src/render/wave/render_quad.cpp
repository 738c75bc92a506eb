#include "render/wave/render_precision.h"
#include "render/wave/render_target.h"

namespace alhazen::render {

Result<RenderOutput> render_in_quad(const RenderJob& job) {
  return render_in_one_type<Quad>(job);
}

}  // namespace alhazen::render

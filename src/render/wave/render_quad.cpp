#include "render/wave/render_precision.h"
#include "render/wave/render_scene.h"

namespace alhazen::render {

Result<RenderOutput> render_in_quad(const RenderJob& job) {
  return render_scene<Quad>(job);
}

}  // namespace alhazen::render

// render/wave: the renderer in each scalar type, each compiled in a file of its own.
#pragma once

#include "core/base/result.h"
#include "render/wave/render.h"

namespace alhazen::render {

struct RenderJob;

Result<RenderOutput> render_in_float(const RenderJob& job);
Result<RenderOutput> render_in_double(const RenderJob& job);
#if ALHAZEN_HAS_QUAD
Result<RenderOutput> render_in_quad(const RenderJob& job);
#endif

}  // namespace alhazen::render

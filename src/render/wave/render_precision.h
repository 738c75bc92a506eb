// render/wave: the renderer in each scalar type, each compiled in a file of its own, and those
// files once for each instruction set: ALHAZEN_ISA_NAME is set by cmake/Isa.cmake and names the
// namespace, the only thing by which the linker can tell them apart.
#pragma once

#include "core/base/result.h"
#include "render/wave/render.h"

#ifndef ALHAZEN_ISA_NAME
#define ALHAZEN_ISA_NAME baseline
#endif

namespace alhazen::render {

struct RenderJob;

struct RenderFunctions {
  using Function = Result<RenderOutput> (*)(const RenderJob&);
  Function in_float, in_double;
};

// Precondition: is_compiled(isa).
RenderFunctions render_functions(Isa isa);

namespace ALHAZEN_ISA_NAME {
Result<RenderOutput> render_in_float(const RenderJob& job);
Result<RenderOutput> render_in_double(const RenderJob& job);
}  // namespace ALHAZEN_ISA_NAME

#if ALHAZEN_HAS_QUAD
Result<RenderOutput> render_in_quad(const RenderJob& job);
#endif

}  // namespace alhazen::render

// render/color: the one way to OpenColorIO: silent, and with exceptions turned into errors.
#pragma once

#include <OpenColorIO/OpenColorIO.h>
#include <fmt/format.h>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "render/color/color_transform.h"

namespace alhazen::render {

namespace ocio = OCIO_NAMESPACE;

struct ColorTransform::Processor {
  ocio::ConstCPUProcessorRcPtr cpu;
};

// OpenColorIO logs to stderr by itself; the library never prints. Errors reach us as exceptions.
void silence_ocio();

// Lossless: only exact simplifications, no baked tables and no fast logarithms and powers, whose
// results differ between processors with and without SSE. What is left to the machine is powf of
// its C library. The environment variable OCIO_OPTIMIZATION_FLAGS overrides this, as users of
// OpenColorIO expect.
constexpr ocio::OptimizationFlags kOptimization = ocio::OPTIMIZATION_LOSSLESS;

ColorTransform make_transform(const ocio::ConstProcessorRcPtr& processor);

// The value of `attempt`; when OpenColorIO throws, an error that begins with `what`.
template <class Attempt>
auto guarded(const std::string& what, Attempt attempt) -> Result<decltype(attempt())> {
  silence_ocio();
  try {
    return attempt();
  } catch (const std::exception& error) {
    return Error{ErrorCode::io, what + ": " + error.what()};
  }
}

}  // namespace alhazen::render

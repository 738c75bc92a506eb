#include "render/color/ocio.h"

#include <mutex>

namespace alhazen::render {

void silence_ocio() {
  // Setting the level would not do: the environment variable OCIO_LOGGING_LEVEL wins over it.
  static std::once_flag once;
  std::call_once(once, [] { ocio::SetLoggingFunction([](const char*) {}); });
}

ColorTransform make_transform(const ocio::ConstProcessorRcPtr& processor) {
  return ColorTransform(std::make_shared<ColorTransform::Processor>(
      ColorTransform::Processor{processor->getOptimizedCPUProcessor(kOptimization)}));
}

}  // namespace alhazen::render

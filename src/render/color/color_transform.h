// render/color: one conversion of colours, ready to be applied to pictures.
#pragma once

#include <memory>
#include <span>

namespace alhazen::render {

// Three planes of the same number of samples.
struct RgbPlanes {
  std::span<float> red, green, blue;
};

// Immutable and cheap to copy; apply() may be called from several threads at once.
class ColorTransform {
 public:
  // Only render/color makes one.
  struct Processor;
  explicit ColorTransform(std::shared_ptr<const Processor> processor);

  // Converts in place. Each pixel is converted by itself: the result does not depend on how a
  // picture is cut into calls. Precondition: the planes have the same size.
  void apply(const RgbPlanes& pixels) const;

 private:
  std::shared_ptr<const Processor> processor_;
};

}  // namespace alhazen::render

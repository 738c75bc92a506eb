#include "render/image/exr_stream.h"

#include <OpenEXR/Iex.h>
#include <algorithm>

namespace alhazen::render {

bool MemoryInput::read(char bytes[], int count) {
  const std::uint64_t size = bytes_.size();
  if (count < 0 || position_ > size || static_cast<std::uint64_t>(count) > size - position_) {
    throw Iex::InputExc("unexpected end of file");
  }
  std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(position_), count, bytes);
  position_ += static_cast<std::uint64_t>(count);
  return position_ < size;
}

}  // namespace alhazen::render

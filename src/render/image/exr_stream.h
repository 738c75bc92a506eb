// render/image: an OpenEXR stream over memory, since files are read by core/base.
#pragma once

#include <OpenEXR/ImfIO.h>
#include <cstdint>
#include <string_view>

namespace alhazen::render {

// Precondition: the bytes outlive the stream.
class MemoryInput : public Imf::IStream {
 public:
  explicit MemoryInput(std::string_view bytes) : Imf::IStream("memory"), bytes_(bytes) {}
  bool read(char bytes[], int count) override;
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::string_view bytes_;
  std::uint64_t position_ = 0;
};

}  // namespace alhazen::render

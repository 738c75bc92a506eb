// render/image: OpenEXR streams over memory. Files go through core/base, which writes them whole
// or not at all; OpenEXR's own file streams drop errors in their destructors.
#pragma once

#include <OpenEXR/ImfIO.h>
#include <cstdint>
#include <string>
#include <string_view>

namespace alhazen::render {

class MemoryOutput : public Imf::OStream {
 public:
  MemoryOutput() : Imf::OStream("memory") {}
  void write(const char bytes[], int count) override;
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
  std::uint64_t position_ = 0;
};

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

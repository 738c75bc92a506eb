// render/image: an EXR file that OpenEXR's C library writes to memory. Unlike the C++ library it
// takes chunks that are compressed already, and does not insist on zlib.
#pragma once

#include <OpenEXR/openexr.h>
#include <string>
#include <string_view>

#include "core/math/chromaticities.h"
#include "render/image/exr_file.h"

namespace alhazen::render {

struct ExrChannel {
  std::string name;
  SampleType type;
};

// First the parts with their channels and attributes, then end_header, then the chunks of each part
// from above, part after part. Everything but the destructor throws std::runtime_error when OpenEXR
// refuses; names of channels and attributes have at most 255 bytes.
class ExrOutput {
 public:
  ExrOutput();
  ExrOutput(const ExrOutput&) = delete;
  ExrOutput& operator=(const ExrOutput&) = delete;
  ~ExrOutput();

  void add_part(const std::string& name, const PixelWindow& display_window,
                const PixelWindow& data_window, exr_compression_t compression);
  // These belong to the part added last.
  void add_channel(const ExrChannel& channel);
  void add(const std::string& name, const std::string& value);
  void add(const std::string& name, int value);
  void add(const std::string& name, float value);
  void add(const std::string& name, Xy value);
  void add(const std::string& name, const PixelWindow& value);
  void add(const std::string& name, const Chromaticities& value);
  // A matrix for row vectors, row by row.
  void add(const std::string& name, const exr_attr_m44f_t& value);
  void end_header();

  // How many rows each chunk of a part has; its last may have less.
  int chunk_rows(int part) const;
  // `row` is the chunk's first, in the coordinates of the data window.
  void write_chunk(int part, int row, std::string_view bytes);

  // The whole file; after it nothing more can be done.
  std::string finish();

 private:
  // The name of an attribute or channel; one beyond 31 bytes has to be announced in the file.
  const char* announced(const std::string& name);

  exr_context_t context_ = nullptr;
  int part_ = -1;
  std::string bytes_;
};

}  // namespace alhazen::render

// render/image: the compression of EXR's ZIP and ZIPS. libdeflate makes streams of zlib's format in
// half the time.
#pragma once

#include <cstdint>
#include <libdeflate.h>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace alhazen::render {

// Not for two threads at once. What it makes does not depend on what it made before.
class ZipCompressor {
 public:
  ZipCompressor();

  // The bytes that stand in the file for a chunk of samples: a zlib stream, or the samples
  // themselves where that is not shorter, as readers expect. The size of `samples` is even and
  // above 0.
  std::string compress(std::string_view samples);

 private:
  struct Free {
    void operator()(libdeflate_compressor* compressor) const;
  };

  std::unique_ptr<libdeflate_compressor, Free> compressor_;
  std::vector<std::uint8_t> filtered_, compressed_;
};

}  // namespace alhazen::render

#include "render/image/exr_write.h"

#include <Imath/half.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfThreading.h>
#include <algorithm>
#include <exception>
#include <fmt/format.h>
#include <set>

#include "core/base/file.h"
#include "render/image/exr_header.h"
#include "render/image/exr_samples.h"
#include "render/image/exr_stream.h"

namespace alhazen::render {
namespace {

// Rows that are converted and handed over at a time; a multiple of the 16 rows of a ZIP chunk.
constexpr int kBandHeight = 128;

struct PlaneToWrite {
  ExrChannel channel;
  std::span<const float> samples;
};
using PartToWrite = std::vector<PlaneToWrite>;

void append(PartToWrite& part, const FloatBuffer& buffer, SampleType type) {
  for (std::size_t i = 0; i < buffer.channel_count(); ++i) {
    part.push_back({{buffer.names()[i], type}, buffer.channel(i)});
  }
}

std::vector<ExrChannel> channels_of(const PartToWrite& part) {
  std::vector<ExrChannel> channels;
  for (const PlaneToWrite& plane : part)
    channels.push_back(plane.channel);
  return channels;
}

std::optional<Error> contradiction(const ExrFile& file, const PartToWrite& part) {
  const PixelWindow& window = file.data_window;
  std::set<std::string> names;
  for (const PlaneToWrite& plane : part) {
    if (plane.channel.name.empty() || !names.insert(plane.channel.name).second) {
      return Error{ErrorCode::usage,
                   fmt::format("EXR channel name `{}` is empty or used twice", plane.channel.name)};
    }
    if (plane.samples.size() !=
        static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height)) {
      return Error{ErrorCode::usage,
                   fmt::format("EXR channel `{}` does not fill the data window of {} x {} pixels",
                               plane.channel.name, window.width, window.height)};
    }
  }
  return std::nullopt;
}

std::optional<Error> contradiction(const ExrFile& file) {
  for (const PixelWindow& window : {file.display_window, file.data_window}) {
    if (window.width <= 0 || window.height <= 0) {
      return Error{ErrorCode::usage, "an EXR picture needs at least one pixel"};
    }
  }
  if (file.beauty.channel_count() == 0) {
    return Error{ErrorCode::usage, "an EXR picture needs a beauty channel"};
  }
  return std::nullopt;
}

// One band of one plane in the type of the file.
class BandPlane {
 public:
  BandPlane(const PlaneToWrite& plane, int width) : plane_(plane), width_(width) {
    const std::size_t count = static_cast<std::size_t>(width) * kBandHeight;
    if (is_half()) {
      halves_.resize(count);
    } else {
      floats_.resize(count);
    }
  }

  // Converts rows first_row .. first_row+rows-1 of the buffer.
  void fill(int first_row, int rows) {
    const std::size_t stride = static_cast<std::size_t>(width_);
    const std::span<const float> samples = plane_.samples.subspan(
        static_cast<std::size_t>(first_row) * stride, static_cast<std::size_t>(rows) * stride);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const float sample = writable_sample(samples[i], plane_.channel.type);
      if (is_half()) {
        halves_[i] = Imath::half(sample);  // to nearest, ties to even
      } else {
        floats_[i] = sample;
      }
    }
  }

  // `origin` is the pixel of the data window that the band begins with.
  Imf::Slice slice(Imath::V2i origin) {
    if (is_half()) {
      return Imf::Slice::Make(Imf::HALF, halves_.data(), origin, width_, kBandHeight);
    }
    return Imf::Slice::Make(Imf::FLOAT, floats_.data(), origin, width_, kBandHeight);
  }
  const std::string& name() const { return plane_.channel.name; }

 private:
  bool is_half() const { return plane_.channel.type == SampleType::half; }

  const PlaneToWrite& plane_;
  int width_;
  std::vector<Imath::half> halves_;
  std::vector<float> floats_;
};

void write_part(Imf::MultiPartOutputFile& out, int index, const PartToWrite& part,
                const PixelWindow& window) {
  std::vector<BandPlane> bands;
  for (const PlaneToWrite& plane : part)
    bands.emplace_back(plane, window.width);
  Imf::OutputPart output(out, index);
  for (int row = 0; row < window.height; row += kBandHeight) {
    const int rows = std::min(kBandHeight, window.height - row);
    Imf::FrameBuffer frame;
    for (BandPlane& band : bands) {
      band.fill(row, rows);
      frame.insert(band.name(), band.slice(Imath::V2i(window.x, window.y + row)));
    }
    output.setFrameBuffer(frame);
    output.writePixels(rows);
  }
}

}  // namespace

Result<EncodedExr> encode_exr(const ExrFile& file, int threads) {
  if (const auto error = contradiction(file)) return *error;
  std::vector<PartToWrite> parts(1);
  append(parts[0], file.beauty, file.beauty_type);
  if (file.data.channel_count() > 0 || !file.cryptomattes.empty()) {
    parts.emplace_back();
    append(parts[1], file.data, SampleType::float32);
    for (const CryptomatteLayer& layer : file.cryptomattes) {
      append(parts[1], layer.channels(), SampleType::float32);
    }
  }

  EncodedExr encoded;
  for (const PartToWrite& part : parts) {
    if (const auto error = contradiction(file, part)) return *error;
    for (const PlaneToWrite& plane : part) {
      count_unwritable(plane.samples, plane.channel.type, encoded.report);
    }
  }

  try {
    std::vector<Imf::Header> headers{beauty_header(file, channels_of(parts[0]), encoded.report)};
    if (parts.size() > 1) headers.push_back(data_header(file, channels_of(parts[1])));
    MemoryOutput stream;
    {
      // OpenEXR compresses chunks side by side and writes them in the order of the rows.
      const int helpers = threads > 1 ? threads : 0;
      if (Imf::globalThreadCount() < helpers) Imf::setGlobalThreadCount(helpers);
      Imf::MultiPartOutputFile out(stream, headers.data(), static_cast<int>(headers.size()), false,
                                   helpers);
      for (std::size_t i = 0; i < parts.size(); ++i) {
        write_part(out, static_cast<int>(i), parts[i], file.data_window);
      }
    }  // its destructor writes the table of chunks
    encoded.bytes = stream.take();
  } catch (const std::exception& error) {
    return Error{ErrorCode::io, fmt::format("cannot make the EXR file: {}", error.what())};
  }
  return encoded;
}

Result<ExrReport> write_exr(const std::filesystem::path& path, const ExrFile& file) {
  Result<EncodedExr> encoded = encode_exr(file);
  if (!encoded) return encoded.error();
  if (const Status written = write_file_atomic(path, encoded.value().bytes); !written) {
    return written.error();
  }
  return encoded.value().report;
}

}  // namespace alhazen::render

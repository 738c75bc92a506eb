#include "render/image/exr_write.h"

#include <exception>
#include <fmt/format.h>
#include <set>

#include "core/base/file.h"
#include "render/image/exr_chunks.h"
#include "render/image/exr_header.h"
#include "render/image/exr_samples.h"

namespace alhazen::render {
namespace {

using PartToWrite = std::vector<ExrPlane>;

void append(PartToWrite& part, const FloatBuffer& buffer, SampleType type) {
  for (std::size_t i = 0; i < buffer.channel_count(); ++i) {
    part.push_back({{buffer.names()[i], type}, buffer.channel(i)});
  }
}

std::vector<ExrChannel> channels_of(const PartToWrite& part) {
  std::vector<ExrChannel> channels;
  for (const ExrPlane& plane : part)
    channels.push_back(plane.channel);
  return channels;
}

std::optional<Error> contradiction(const ExrFile& file, const PartToWrite& part) {
  const PixelWindow& window = file.data_window;
  std::set<std::string> names;
  for (const ExrPlane& plane : part) {
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

void write_pixels(ExrOutput& out, int index, const PartToWrite& part, const PixelWindow& window,
                  int threads) {
  const int chunk_rows = out.chunk_rows(index);
  int row = window.y;
  for (const std::string& chunk : compressed_chunks(part, window.width, chunk_rows, threads)) {
    out.write_chunk(index, row, chunk);
    row += chunk_rows;
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
    for (const ExrPlane& plane : part) {
      count_unwritable(plane.samples, plane.channel.type, encoded.report);
    }
  }

  try {
    ExrOutput out;
    add_beauty_part(out, file, channels_of(parts[0]), encoded.report);
    if (parts.size() > 1) add_data_part(out, file, channels_of(parts[1]));
    out.end_header();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      write_pixels(out, static_cast<int>(i), parts[i], file.data_window, threads);
    }
    encoded.bytes = out.finish();
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

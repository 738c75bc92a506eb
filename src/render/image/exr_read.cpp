#include "render/image/exr_read.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <exception>
#include <fmt/format.h>
#include <mutex>
#include <optional>

#include "core/base/file.h"
#include "render/image/exr_attributes.h"
#include "render/image/exr_scan.h"
#include "render/image/exr_stream.h"

namespace alhazen::render {
namespace {

// OpenEXR sizes tables by the height and width in the header before we see it, and buffers by the
// size of a tile. These bound them; no side of a real picture or tile comes near.
constexpr int kLongestSide = 1 << 17;
constexpr int kLongestTileSide = 1 << 12;

void bound_headers() {
  static std::once_flag once;
  std::call_once(once, [] {
    Imf::Header::setMaxImageSize(kLongestSide, kLongestSide);
    Imf::Header::setMaxTileSize(kLongestTileSide, kLongestTileSide);
  });
}

PixelWindow window(const Imath::Box2i& box) {
  return {box.min.x, box.min.y, box.max.x - box.min.x + 1, box.max.y - box.min.y + 1};
}

SampleType sample_type(Imf::PixelType type) {
  if (type == Imf::HALF) return SampleType::half;
  return type == Imf::UINT ? SampleType::uint32 : SampleType::float32;
}

std::optional<Error> unreadable(const Imf::Header& header) {
  if (header.hasType() && Imf::isDeepData(header.type())) {
    return Error{ErrorCode::unsupported, "deep EXR data is not supported"};
  }
  const Imf::ChannelList& channels = header.channels();
  if (channels.begin() == channels.end()) return Error{ErrorCode::io, "EXR part has no channels"};
  for (auto it = channels.begin(); it != channels.end(); ++it) {
    if (it.channel().xSampling != 1 || it.channel().ySampling != 1) {
      return Error{ErrorCode::unsupported,
                   fmt::format("subsampled EXR channel `{}` is not supported", it.name())};
    }
  }
  return std::nullopt;
}

ExrPart described_part(const Imf::Header& header) {
  ExrPart part;
  if (header.hasName()) part.name = header.name();
  part.display_window = window(header.displayWindow());
  part.data_window = window(header.dataWindow());
  part.attributes = attribute_texts(header);
  return part;
}

void read_pixels(Imf::MultiPartInputFile& file, int index, ExrPart& part) {
  const Imf::Header& header = file.header(index);
  std::vector<std::string> names;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
    names.emplace_back(it.name());
    part.types.push_back(sample_type(it.channel().type));
  }
  part.pixels = FloatBuffer(part.data_window.width, part.data_window.height, std::move(names));
  Imf::FrameBuffer frame;
  for (std::size_t i = 0; i < part.pixels.channel_count(); ++i) {
    frame.insert(part.pixels.names()[i],
                 Imf::Slice::Make(Imf::FLOAT, part.pixels.channel(i).data(), header.dataWindow()));
  }
  Imf::InputPart input(file, index);
  input.setFrameBuffer(frame);
  input.readPixels(header.dataWindow().min.y, header.dataWindow().max.y);
}

std::size_t channel_count(const Imf::Header& header) {
  std::size_t count = 0;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
    ++count;
  return count;
}

Result<std::vector<ExrPart>> decode(std::string_view bytes, const ImageLimits& limits) {
  MemoryInput stream(bytes);
  // No threads, and no guessing of a table of chunks that an interrupted writer left unwritten.
  Imf::MultiPartInputFile file(stream, 0, false);
  std::vector<ExrPart> parts;
  ImageLimits left = limits;
  for (int i = 0; i < file.parts(); ++i) {
    const Imf::Header& header = file.header(i);
    if (const auto error = unreadable(header)) return *error;
    ExrPart part = described_part(header);
    const auto width = static_cast<std::uint64_t>(part.data_window.width);
    const auto height = static_cast<std::uint64_t>(part.data_window.height);
    const std::uint64_t channels = channel_count(header);
    if (const Status kept = within_limits(width, height, channels, left); !kept) {
      return kept.error();
    }
    left.max_samples -= width * height * channels;
    if (!file.partComplete(i)) return Error{ErrorCode::io, "EXR file is incomplete"};
    read_pixels(file, i, part);
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace

bool is_exr(std::string_view bytes) {
  return bytes.substr(0, 4) == "\x76\x2f\x31\x01";
}

Result<std::vector<ExrPart>> decode_exr(std::string_view bytes, const ImageLimits& limits) {
  if (!is_exr(bytes)) return Error{ErrorCode::io, "not an EXR file"};
  if (!attributes_fit(bytes)) return Error{ErrorCode::io, "damaged EXR file: header is cut short"};
  bound_headers();
  try {
    return decode(bytes, limits);
  } catch (const std::exception& error) {
    return Error{ErrorCode::io, fmt::format("damaged EXR file: {}", error.what())};
  }
}

Result<std::vector<ExrPart>> read_exr(const std::filesystem::path& path,
                                      const ImageLimits& limits) {
  const Result<std::string> bytes = read_file(path, limits.max_file_bytes);
  if (!bytes) return bytes.error();
  Result<std::vector<ExrPart>> parts = decode_exr(bytes.value(), limits);
  if (!parts) {
    return Error{parts.error().code,
                 fmt::format("cannot read `{}`: {}", path.string(), parts.error().message)};
  }
  return parts;
}

}  // namespace alhazen::render

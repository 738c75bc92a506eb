#include "render/image/exr_header.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <algorithm>
#include <limits>

namespace alhazen::render {
namespace {

Imath::Box2i box(const PixelWindow& window) {
  return {Imath::V2i(window.x, window.y),
          Imath::V2i(window.x + window.width - 1, window.y + window.height - 1)};
}

Imath::V2f vector(Xy xy) {
  return {static_cast<float>(xy.x), static_cast<float>(xy.y)};
}

// EXR multiplies row vectors from the left: its matrices are the transposes of ours.
Imath::M44f row_vector_matrix(const std::array<std::array<double, 4>, 4>& column_vector_matrix) {
  Imath::M44f matrix;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      matrix[static_cast<int>(j)][static_cast<int>(i)] =
          static_cast<float>(column_vector_matrix[i][j]);
    }
  }
  return matrix;
}

void add_string(Imf::Header& header, const std::string& name, const std::string& value) {
  header.insert(name, Imf::StringAttribute(value));
}

void add_count(Imf::Header& header, const std::string& name, std::uint64_t count) {
  constexpr std::uint64_t kMost = std::numeric_limits<int>::max();
  header.insert(kAttributePrefix + name,
                Imf::IntAttribute(static_cast<int>(std::min(count, kMost))));
}

Imf::Header part_header(const ExrFile& file, const std::string& name, Imf::Compression compression,
                        const std::vector<ExrChannel>& channels) {
  Imf::Header header(box(file.display_window), box(file.data_window));
  header.setName(name);
  header.setType(Imf::SCANLINEIMAGE);
  header.compression() = compression;
  for (const ExrChannel& channel : channels) {
    header.channels().insert(
        channel.name, Imf::Channel(channel.type == SampleType::half ? Imf::HALF : Imf::FLOAT));
  }
  if (file.data_window != file.display_window) {
    Imf::addOriginalDataWindow(header, box(file.display_window));
  }
  return header;
}

void add_cameras(Imf::Header& header, const ExrMetadata& metadata) {
  if (metadata.camera_from_world) {
    const auto& rows = metadata.camera_from_world->rows;
    Imf::addWorldToCamera(header,
                          row_vector_matrix({rows[0], rows[1], rows[2], {0.0, 0.0, 0.0, 1.0}}));
  }
  if (metadata.ndc_from_world) {
    Imf::addWorldToNDC(header, row_vector_matrix(*metadata.ndc_from_world));
  }
}

void add_colors(Imf::Header& header, const ExrMetadata& metadata) {
  if (!metadata.chromaticities) return;
  const Chromaticities& c = *metadata.chromaticities;
  Imf::addChromaticities(
      header, Imf::Chromaticities(vector(c.red), vector(c.green), vector(c.blue), vector(c.white)));
  Imf::addAdoptedNeutral(header, vector(c.white));
}

void add_texts(Imf::Header& header, const ExrMetadata& metadata) {
  if (!metadata.software.empty()) add_string(header, "software", metadata.software);
  if (!metadata.owner.empty()) Imf::addOwner(header, metadata.owner);
  if (!metadata.comments.empty()) Imf::addComments(header, metadata.comments);
  if (!metadata.cap_date.empty()) Imf::addCapDate(header, metadata.cap_date);
  if (metadata.utc_offset_seconds) Imf::addUtcOffset(header, *metadata.utc_offset_seconds);
  for (const auto& [name, value] : metadata.provenance) {
    add_string(header, kAttributePrefix + name, value);
  }
}

void add_cryptomatte(Imf::Header& header, const CryptomatteLayer& layer) {
  const std::string prefix = "cryptomatte/" + cryptomatte_key(layer.name()) + "/";
  add_string(header, prefix + "name", layer.name());
  add_string(header, prefix + "hash", "MurmurHash3_32");
  add_string(header, prefix + "conversion", "uint32_to_float32");
  add_string(header, prefix + "manifest", layer.manifest());
}

}  // namespace

Imf::Header beauty_header(const ExrFile& file, const std::vector<ExrChannel>& channels,
                          const ExrReport& report) {
  Imf::Header header = part_header(file, "rgba", Imf::ZIP_COMPRESSION, channels);
  add_colors(header, file.metadata);
  add_cameras(header, file.metadata);
  add_texts(header, file.metadata);
  add_count(header, "nanCount", report.non_finite);
  add_count(header, "clampedCount", report.clamped);
  return header;
}

Imf::Header data_header(const ExrFile& file, const std::vector<ExrChannel>& channels) {
  // Never DWA here: it takes every channel whose name ends in R, G, B or Y for a colour and stores
  // it lossily, N.Y and P.Y included, even where its type is float.
  Imf::Header header = part_header(file, "data", Imf::ZIPS_COMPRESSION, channels);
  add_colors(header, file.metadata);  // EXR demands that all parts agree on chromaticities
  add_cameras(header, file.metadata);
  for (const CryptomatteLayer& layer : file.cryptomattes)
    add_cryptomatte(header, layer);
  if (file.data.find("Z")) {
    header.insert(std::string(kAttributePrefix) + "backgroundDepth",
                  Imf::FloatAttribute(kBackgroundDepth));
  }
  return header;
}

}  // namespace alhazen::render

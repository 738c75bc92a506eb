#include "render/image/exr_header.h"

#include <algorithm>
#include <limits>

namespace alhazen::render {
namespace {

// EXR multiplies row vectors from the left: its matrices are the transposes of ours.
exr_attr_m44f_t row_vector_matrix(
    const std::array<std::array<double, 4>, 4>& column_vector_matrix) {
  exr_attr_m44f_t matrix{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j)
      matrix.m[4 * j + i] = static_cast<float>(column_vector_matrix[i][j]);
  }
  return matrix;
}

void add_count(ExrOutput& out, const std::string& name, std::uint64_t count) {
  constexpr std::uint64_t kMost = std::numeric_limits<int>::max();
  out.add(kAttributePrefix + name, static_cast<int>(std::min(count, kMost)));
}

void add_part(ExrOutput& out, const ExrFile& file, const std::string& name,
              exr_compression_t compression, const std::vector<ExrChannel>& channels) {
  out.add_part(name, file.display_window, file.data_window, compression);
  for (const ExrChannel& channel : channels)
    out.add_channel(channel);
  if (file.data_window != file.display_window) out.add("originalDataWindow", file.display_window);
}

void add_cameras(ExrOutput& out, const ExrMetadata& metadata) {
  if (metadata.camera_from_world) {
    const auto& rows = metadata.camera_from_world->rows;
    out.add("worldToCamera", row_vector_matrix({rows[0], rows[1], rows[2], {0.0, 0.0, 0.0, 1.0}}));
  }
  if (metadata.ndc_from_world) out.add("worldToNDC", row_vector_matrix(*metadata.ndc_from_world));
}

void add_colors(ExrOutput& out, const ExrMetadata& metadata) {
  if (!metadata.chromaticities) return;
  out.add("chromaticities", *metadata.chromaticities);
  out.add("adoptedNeutral", metadata.chromaticities->white);
}

void add_texts(ExrOutput& out, const ExrMetadata& metadata) {
  if (!metadata.software.empty()) out.add("software", metadata.software);
  if (!metadata.owner.empty()) out.add("owner", metadata.owner);
  if (!metadata.comments.empty()) out.add("comments", metadata.comments);
  if (!metadata.cap_date.empty()) out.add("capDate", metadata.cap_date);
  if (metadata.utc_offset_seconds) out.add("utcOffset", *metadata.utc_offset_seconds);
  for (const auto& [name, value] : metadata.provenance)
    out.add(kAttributePrefix + name, value);
}

void add_cryptomatte(ExrOutput& out, const CryptomatteLayer& layer) {
  const std::string prefix = "cryptomatte/" + cryptomatte_key(layer.name()) + "/";
  out.add(prefix + "name", layer.name());
  out.add(prefix + "hash", "MurmurHash3_32");
  out.add(prefix + "conversion", "uint32_to_float32");
  out.add(prefix + "manifest", layer.manifest());
}

}  // namespace

void add_beauty_part(ExrOutput& out, const ExrFile& file, const std::vector<ExrChannel>& channels,
                     const ExrReport& report) {
  add_part(out, file, "rgba", EXR_COMPRESSION_ZIP, channels);
  add_colors(out, file.metadata);
  add_cameras(out, file.metadata);
  add_texts(out, file.metadata);
  add_count(out, "nanCount", report.non_finite);
  add_count(out, "clampedCount", report.clamped);
}

void add_data_part(ExrOutput& out, const ExrFile& file, const std::vector<ExrChannel>& channels) {
  // Never DWA here: it takes every channel whose name ends in R, G, B or Y for a colour and stores
  // it lossily, N.Y and P.Y included, even where its type is float.
  add_part(out, file, "data", EXR_COMPRESSION_ZIPS, channels);
  add_colors(out, file.metadata);  // EXR demands that all parts agree on chromaticities
  add_cameras(out, file.metadata);
  for (const CryptomatteLayer& layer : file.cryptomattes)
    add_cryptomatte(out, layer);
  if (file.data.find("Z")) {
    out.add(std::string(kAttributePrefix) + "backgroundDepth", kBackgroundDepth);
  }
}

}  // namespace alhazen::render

// app/cli: what a picture took, as text for people and as JSON for programs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/render_request.h"
#include "render/image/exr_write.h"

namespace alhazen {

struct WrittenFile {
  std::string path;  // "-": stdout
  std::uint64_t bytes = 0;
};

// Everything there is to say about one picture.
struct PictureReport {
  std::string scene, label;  // label: "frame 7", or ""
  int width = 0, height = 0;
  render::PixelRect window;
  render::Precision precision = render::Precision::float64;
  render::RenderStatistics rendering;
  std::optional<render::AccuracyReport> accuracy;
  render::ExrReport samples;  // that could not be written as they were
  double load_seconds = 0, write_seconds = 0;
  std::vector<WrittenFile> files;
  std::uint64_t peak_memory_bytes = 0;
};

// Of this process so far.
std::uint64_t peak_memory_bytes();

std::string statistics_text(const PictureReport& report);

std::string statistics_json(const PictureReport& report);
// A list of the same objects.
std::string statistics_json(const std::vector<PictureReport>& reports);

}  // namespace alhazen

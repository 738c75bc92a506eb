// render/image: EXR files as other programs write them, made here with OpenEXR itself.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "core/base/file.h"
#include "render/image/exr_read.h"
#include "render/image/image_read.h"
#include "unit/render/image/damage.h"
#include "unit/render/temporary_folder.h"

namespace alhazen::render {
namespace {

constexpr int kWidth = 37, kHeight = 29;

// Mipmapped tiles of 16 x 16, PIZ, data window away from the origin, a 32-bit integer channel.
void write_tiled(const std::string& path) {
  Imf::Header header(Imath::Box2i({0, 0}, {99, 99}),
                     Imath::Box2i({-5, 7}, {-5 + kWidth - 1, 7 + kHeight - 1}));
  header.compression() = Imf::PIZ_COMPRESSION;
  header.channels().insert("R", Imf::Channel(Imf::FLOAT));
  header.channels().insert("id", Imf::Channel(Imf::UINT));
  header.setTileDescription(Imf::TileDescription(16, 16, Imf::MIPMAP_LEVELS));
  std::vector<float> red;
  std::vector<std::uint32_t> id;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    red.push_back(static_cast<float>(i) / 7.0F);
    id.push_back(static_cast<std::uint32_t>(i));
  }
  Imf::FrameBuffer frame;
  frame.insert("R", Imf::Slice::Make(Imf::FLOAT, red.data(), header.dataWindow()));
  frame.insert("id", Imf::Slice::Make(Imf::UINT, id.data(), header.dataWindow()));
  Imf::TiledOutputFile out(path.c_str(), header);
  out.setFrameBuffer(frame);
  for (int level = 0; level < out.numLevels(); ++level) {
    out.writeTiles(0, out.numXTiles(level) - 1, 0, out.numYTiles(level) - 1, level);
  }
}

// Luminance with chroma at half the resolution, as cameras and compositing programs write it.
void write_subsampled(const std::string& path) {
  Imf::Header header(4, 4);
  header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
  header.channels().insert("RY", Imf::Channel(Imf::FLOAT, 2, 2));
  const std::vector<float> samples(16, 0.5F);
  Imf::FrameBuffer frame;
  frame.insert("Y", Imf::Slice::Make(Imf::FLOAT, samples.data(), header.dataWindow()));
  frame.insert("RY", Imf::Slice::Make(Imf::FLOAT, samples.data(), header.dataWindow(), 0, 0, 2, 2));
  Imf::OutputFile out(path.c_str(), header);
  out.setFrameBuffer(frame);
  out.writePixels(4);
}

void write_deep(const std::string& path) {
  Imf::Header header(1, 1);
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::ZIPS_COMPRESSION;
  header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
  unsigned int count = 1;
  float depth = 2;
  float* samples = &depth;
  Imf::DeepFrameBuffer frame;
  frame.insertSampleCountSlice(
      Imf::Slice(Imf::UINT, reinterpret_cast<char*>(&count), sizeof count, sizeof count));
  frame.insert("Z", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(&samples), sizeof samples,
                                   sizeof samples, sizeof depth));
  Imf::DeepScanLineOutputFile out(path.c_str(), header);
  out.setFrameBuffer(frame);
  out.writePixels(1);
}

TEST(ExrForeign, TilesAndIntegersAreRead) {
  const TemporaryFolder folder;
  write_tiled((folder.path() / "tiled.exr").string());
  const auto parts = read_exr(folder.path() / "tiled.exr");
  ASSERT_TRUE(parts) << parts.error().message;
  const ExrPart& part = parts.value().at(0);
  EXPECT_EQ(part.data_window, (PixelWindow{-5, 7, kWidth, kHeight}));
  EXPECT_EQ(part.types, (std::vector{SampleType::float32, SampleType::uint32}));
  EXPECT_EQ(part.attributes.at("compression"), "piz");
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const auto at = static_cast<std::size_t>(i);
    ASSERT_EQ(part.pixels.channel(0)[at], static_cast<float>(i) / 7.0F);
    ASSERT_EQ(part.pixels.channel(1)[at], static_cast<float>(i));
  }
}

TEST(ExrForeign, DamagedTilesAreSurvived) {
  const TemporaryFolder folder;
  write_tiled((folder.path() / "tiled.exr").string());
  const std::string bytes = read_file(folder.path() / "tiled.exr", 1 << 20).value();
  const ImageLimits limits{.max_pixels = 1 << 12, .max_samples = 1 << 16};
  const auto decode = [&](std::string_view damaged) { return decode_exr(damaged, limits); };
  // The file ends with the smaller levels, which are not read: cuts there do no harm.
  EXPECT_GE(refused_truncations(bytes, decode), 8);
  EXPECT_GT(refused_flips(bytes, 7, decode), 0);
}

TEST(ExrForeign, WhatIsNotSupportedSaysSo) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "x.exr";
  for (const auto& [write, word] :
       {std::pair{&write_subsampled, "subsampled"}, std::pair{&write_deep, "deep"}}) {
    write(path.string());
    const auto image = read_image(path);
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().code, ErrorCode::unsupported);
    EXPECT_NE(image.error().message.find(word), std::string::npos) << image.error().message;
  }
}

}  // namespace
}  // namespace alhazen::render

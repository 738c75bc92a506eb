#include <bit>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "render/image/exr_read.h"
#include "render/image/exr_write.h"
#include "unit/render/image/damage.h"
#include "unit/render/temporary_folder.h"

namespace alhazen::render {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Every bit pattern class a float can have, without repeating: a Weyl sequence over the words.
float noise(std::uint32_t i) {
  const float value = std::bit_cast<float>(0x9e3779b9U * (i + 1));
  return std::isfinite(value) ? value : 1.0F;
}

FloatBuffer noise_buffer(int width, int height, std::vector<std::string> names) {
  FloatBuffer buffer(width, height, std::move(names));
  std::uint32_t i = 0;
  for (std::size_t c = 0; c < buffer.channel_count(); ++c) {
    for (float& sample : buffer.channel(c))
      sample = noise(i++);
  }
  return buffer;
}

// 37 x 70: neither a multiple of a ZIP chunk (16 rows) nor of the writer's band (64 rows).
ExrFile beauty_file(SampleType type) {
  ExrFile file;
  file.display_window = file.data_window = {0, 0, 37, 70};
  file.beauty = noise_buffer(37, 70, {"R", "G", "B", "A"});
  file.beauty_type = type;
  return file;
}

ExrFile full_file() {
  ExrFile file;
  file.display_window = {0, 0, 64, 48};
  file.data_window = {16, 10, 20, 33};
  file.beauty = FloatBuffer(20, 33, {"R", "G", "B", "A"});
  file.data = noise_buffer(20, 33,
                           {"Z", "N.X", "N.Y", "N.Z", "P.X", "P.Y", "P.Z", "albedo.R", "albedo.G",
                            "albedo.B", "uv.U", "uv.V", "samples.V", "cost.V"});
  for (const char* name : {"CryptoObject", "CryptoMaterial"}) {
    CryptomatteLayer layer(name, 20, 33, 6, {"bunny", "default"});
    layer.set_pixel(3, 4,
                    {{cryptomatte_hash("bunny"), 0.75F}, {cryptomatte_hash("default"), 0.25F}});
    file.cryptomattes.push_back(std::move(layer));
  }
  file.metadata.chromaticities = kAcesAp1;
  file.metadata.software = "Alhazen test";
  file.metadata.provenance = {{"sceneHash", "0123"}, {"options", R"({"samples":4})"}};
  return file;
}

std::string encoded(const ExrFile& file) {
  Result<EncodedExr> result = encode_exr(file);
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  return result ? result.value().bytes : "";
}

std::vector<ExrPart> decoded(const std::string& bytes) {
  Result<std::vector<ExrPart>> parts = decode_exr(bytes);
  EXPECT_TRUE(parts) << (parts ? "" : parts.error().message);
  return parts ? std::move(parts).value() : std::vector<ExrPart>{};
}

// The channels of `read` that have names of `written` hold the same bits.
void expect_same_bits(const FloatBuffer& written, const FloatBuffer& read) {
  for (std::size_t c = 0; c < written.channel_count(); ++c) {
    const auto found = read.find(written.names()[c]);
    ASSERT_TRUE(found) << written.names()[c];
    for (std::size_t i = 0; i < written.pixel_count(); ++i) {
      ASSERT_EQ(std::bit_cast<std::uint32_t>(read.channel(*found)[i]),
                std::bit_cast<std::uint32_t>(written.channel(c)[i]))
          << written.names()[c] << " sample " << i;
    }
  }
}

TEST(Exr, FloatBeautyComesBackToTheBit) {
  const ExrFile file = beauty_file(SampleType::float32);
  const auto parts = decoded(encoded(file));
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].types, std::vector(4, SampleType::float32));
  expect_same_bits(file.beauty, parts[0].pixels);
}

TEST(Exr, HalfBeautyIsTheNearestHalfTiesToEven) {
  // In 1 .. 2 halves are 2^-10 apart; below 2^-14 they are 2^-24 apart.
  const std::vector<std::pair<float, float>> cases{
      {0.18F, 0.1800537109375F},                      // 1475 * 2^-13, from 0.18 * 2^13 = 1474.56
      {1.0F + 0x1p-11F, 1.0F},                        // the middle: to even 1
      {1.0F + 0x3p-11F, 1.0F + 0x2p-10F},             // the middle: to even
      {1.0F + 0x1p-11F + 0x1p-23F, 1.0F + 0x1p-10F},  // one float above the middle
      {0x1p-24F, 0x1p-24F},                           // the smallest half
      {0x1p-25F, 0.0F},                               // half of it: to even
      {-0x1.8p-24F, -0x1p-23F},                       // the middle: to even
      {65504.0F, 65504.0F},
  };
  ExrFile file = beauty_file(SampleType::half);
  file.beauty = FloatBuffer(37, 70, {"R"});
  for (std::size_t i = 0; i < cases.size(); ++i)
    file.beauty.channel(0)[i] = cases[i].first;
  const auto parts = decoded(encoded(file));
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].types, std::vector(1, SampleType::half));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    EXPECT_EQ(parts[0].pixels.channel(0)[i], cases[i].second) << cases[i].first;
  }
}

TEST(Exr, DataPartIsLosslessWhateverTheChannelsAreCalled) {
  const ExrFile file = full_file();
  const auto parts = decoded(encoded(file));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].name, "rgba");
  EXPECT_EQ(parts[1].name, "data");
  EXPECT_EQ(parts[0].attributes.at("compression"), "zip");
  EXPECT_EQ(parts[1].attributes.at("compression"), "zips");
  EXPECT_EQ(parts[1].types, std::vector(14 + 2 * 12, SampleType::float32));
  expect_same_bits(file.data, parts[1].pixels);
  for (const CryptomatteLayer& layer : file.cryptomattes) {
    expect_same_bits(layer.channels(), parts[1].pixels);
  }
}

TEST(Exr, CropIsADataWindowInTheWholeFrame) {
  const ExrFile file = full_file();
  for (const ExrPart& part : decoded(encoded(file))) {
    EXPECT_EQ(part.display_window, file.display_window);
    EXPECT_EQ(part.data_window, file.data_window);
    EXPECT_EQ(part.attributes.at("originalDataWindow"), "0 0 63 47");
  }
  EXPECT_FALSE(
      decoded(encoded(beauty_file(SampleType::half)))[0].attributes.contains("originalDataWindow"));
}

TEST(Exr, CryptomatteAttributesFollowTheSpecification) {
  const auto parts = decoded(encoded(full_file()));
  ASSERT_EQ(parts.size(), 2u);
  const auto& attributes = parts[1].attributes;
  EXPECT_EQ(attributes.at("cryptomatte/3ae39a5/name"), "CryptoObject");
  EXPECT_EQ(attributes.at("cryptomatte/be359d6/name"), "CryptoMaterial");
  EXPECT_EQ(attributes.at("cryptomatte/be359d6/hash"), "MurmurHash3_32");
  EXPECT_EQ(attributes.at("cryptomatte/be359d6/conversion"), "uint32_to_float32");
  EXPECT_EQ(nlohmann::json::parse(attributes.at("cryptomatte/3ae39a5/manifest")),
            (nlohmann::json{{"bunny", "13851a76"}, {"default", "42c9679f"}}));
}

TEST(Exr, StandardAttributesAndProvenance) {
  ExrFile file = full_file();
  // Camera at (1, 2, 3) looking along +x with y up: right is -z.
  file.metadata.camera_from_world = Affined({{{0, 0, -1, 3}, {0, 1, 0, -2}, {1, 0, 0, -1}}});
  file.metadata.ndc_from_world = {{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16}}};
  file.metadata.cap_date = "2026:01:02 03:04:05";
  file.metadata.utc_offset_seconds = -3600.0F;
  const auto parts = decoded(encoded(file));
  ASSERT_EQ(parts.size(), 2u);
  const auto& attributes = parts[0].attributes;
  EXPECT_EQ(attributes.at("chromaticities"), "0.713 0.293 0.165 0.83 0.128 0.044 0.32168 0.33767");
  EXPECT_EQ(attributes.at("adoptedNeutral"), "0.32168 0.33767");
  // Row vectors: the translation stands in the last row.
  EXPECT_EQ(attributes.at("worldToCamera"), "0 0 1 0 0 1 0 0 -1 0 0 0 3 -2 -1 1");
  EXPECT_EQ(attributes.at("worldToNDC"), "1 5 9 13 2 6 10 14 3 7 11 15 4 8 12 16");
  EXPECT_EQ(attributes.at("software"), "Alhazen test");
  EXPECT_EQ(attributes.at("capDate"), "2026:01:02 03:04:05");
  EXPECT_EQ(attributes.at("utcOffset"), "-3600");
  EXPECT_EQ(attributes.at("alhazen/sceneHash"), "0123");
  EXPECT_EQ(nlohmann::json::parse(attributes.at("alhazen/options")).at("samples"), 4);
  EXPECT_EQ(attributes.at("alhazen/nanCount"), "0");
  EXPECT_EQ(parts[1].attributes.at("alhazen/backgroundDepth"), "1e+30");
  EXPECT_FALSE(attributes.contains("owner"));
  EXPECT_FALSE(attributes.contains("comments"));
}

TEST(Exr, WhatAChannelCannotHoldIsCountedAndReplaced) {
  ExrFile file = full_file();
  file.beauty.channel(0)[0] = std::numeric_limits<float>::quiet_NaN();
  file.beauty.channel(1)[0] = -kInfinity;
  file.beauty.channel(2)[0] = 65505.0F;
  file.beauty.channel(2)[1] = -1e20F;
  file.data.channel(0)[0] = kInfinity;
  file.data.channel(0)[1] = 1e20F;  // a float channel holds it
  const Result<EncodedExr> result = encode_exr(file);
  ASSERT_TRUE(result);
  EXPECT_EQ(result.value().report.non_finite, 3u);
  EXPECT_EQ(result.value().report.clamped, 2u);
  const auto parts = decoded(result.value().bytes);
  ASSERT_EQ(parts.size(), 2u);
  const auto read = [](const ExrPart& part, const char* name, std::size_t i) {
    return part.pixels.channel(*part.pixels.find(name))[i];
  };
  EXPECT_EQ(read(parts[0], "R", 0), 0.0F);
  EXPECT_EQ(read(parts[0], "G", 0), 0.0F);
  EXPECT_EQ(read(parts[0], "B", 0), 65504.0F);
  EXPECT_EQ(read(parts[0], "B", 1), -65504.0F);
  EXPECT_EQ(read(parts[1], "Z", 0), 0.0F);
  EXPECT_EQ(read(parts[1], "Z", 1), 1e20F);
  EXPECT_EQ(parts[0].attributes.at("alhazen/nanCount"), "3");
  EXPECT_EQ(parts[0].attributes.at("alhazen/clampedCount"), "2");
}

TEST(Exr, SameDescriptionGivesTheSameBytes) {
  EXPECT_EQ(encoded(full_file()), encoded(full_file()));
}

TEST(Exr, AnyNumberOfThreadsGivesTheSameBytes) {
  ExrFile file;
  file.display_window = file.data_window = {0, 0, 70, 700};  // 44 chunks of rows, in several bands
  file.beauty = FloatBuffer(70, 700, {"R", "G", "B", "A"});
  for (std::size_t c = 0; c < 4; ++c) {
    const auto samples = file.beauty.channel(c);
    for (std::size_t i = 0; i < samples.size(); ++i)
      samples[i] = static_cast<float>((i * i + c) % 977);
  }
  const std::string alone = encode_exr(file, 1).value().bytes;
  for (const int threads : {2, 3, 8})
    EXPECT_TRUE(encode_exr(file, threads).value().bytes == alone) << threads << " threads";
}

TEST(Exr, PicturesAreCompressed) {
  ExrFile file;
  file.display_window = file.data_window = {0, 0, 70, 700};
  file.beauty = FloatBuffer(70, 700, {"R", "G", "B", "A"});  // black: deflate can reach 1032 to 1
  EXPECT_LT(encoded(file).size(), 70u * 700 * 4 * 2 / 100);
}

TEST(Exr, ForeignNamesOfAnyLengthThatEXRKnowsComeBack) {
  ExrFile file = beauty_file(SampleType::half);
  for (const std::size_t length : {31u, 32u, 255u}) {
    const std::string name(length, 'n');
    file.data = noise_buffer(37, 70, {name});
    const auto parts = decoded(encoded(file));
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[1].pixels.names(), std::vector{name});
    expect_same_bits(file.data, parts[1].pixels);
  }
  const ExpectSilence silence;
  file.data = noise_buffer(37, 70, {std::string(256, 'n')});
  const Result<EncodedExr> refused = encode_exr(file);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::io);
  EXPECT_NE(refused.error().message.find("the channel `nnn"), std::string::npos);
}

TEST(Exr, ContradictionsAreUsageErrors) {
  ExrFile wrong_size = full_file();
  wrong_size.data = FloatBuffer(19, 33, {"Z"});
  ExrFile twice = full_file();
  twice.data = FloatBuffer(20, 33, {"CryptoObject00.r"});
  ExrFile nothing = full_file();
  nothing.beauty = {};
  ExrFile no_pixels = full_file();
  no_pixels.display_window = {};
  for (const ExrFile& file : {wrong_size, twice, nothing, no_pixels}) {
    const Result<EncodedExr> result = encode_exr(file);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::usage);
  }
}

TEST(Exr, FileAppearsWholeOrNotAtAll) {
  const TemporaryFolder folder;
  const ExrFile file = full_file();
  ASSERT_TRUE(write_exr(folder.path() / "a.exr", file));
  EXPECT_EQ(folder.entries(), 1);
  EXPECT_EQ(read_file(folder.path() / "a.exr", 1 << 20).value(), encoded(file));

  ExrFile bad = file;
  bad.beauty = {};
  EXPECT_FALSE(write_exr(folder.path() / "b.exr", bad));
  EXPECT_FALSE(write_exr(folder.path() / "a.exr", bad));
  EXPECT_FALSE(write_exr(folder.path() / "missing" / "c.exr", file));
  EXPECT_EQ(folder.entries(), 1);
  EXPECT_EQ(read_file(folder.path() / "a.exr", 1 << 20).value(), encoded(file));
}

TEST(Exr, ReadErrorsSayWhatIsWrong) {
  const TemporaryFolder folder;
  const auto message = [&](std::string_view bytes) {
    EXPECT_TRUE(write_file_atomic(folder.path() / "x.exr", bytes));
    const auto result = read_exr(folder.path() / "x.exr");
    return result ? "success" : result.error().message;
  };
  EXPECT_NE(message("").find("x.exr`: not an EXR file"), std::string::npos);
  EXPECT_NE(message("\x89PNG").find("not an EXR file"), std::string::npos);
  const std::string good = encoded(beauty_file(SampleType::half));
  EXPECT_NE(message(good.substr(0, 100)).find("damaged EXR file"), std::string::npos);
  EXPECT_EQ(read_exr(folder.path() / "missing.exr").error().code, ErrorCode::io);
}

TEST(Exr, PictureOverTheLimitIsALimitError) {
  const std::string bytes = encoded(beauty_file(SampleType::half));  // 37 * 70 = 2590 pixels
  EXPECT_TRUE(decode_exr(bytes, {.max_pixels = 2590, .max_samples = 4 * 2590}));
  for (const ImageLimits& limits :
       {ImageLimits{.max_pixels = 2589}, ImageLimits{.max_samples = 4 * 2590 - 1}}) {
    const auto result = decode_exr(bytes, limits);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::limit);
  }
}

TEST(Exr, DamageIsSurvived) {
  const ImageLimits limits{.max_pixels = 1 << 12, .max_samples = 1 << 16};
  const auto decode = [&](std::string_view bytes) { return decode_exr(bytes, limits); };
  ExrFile single;
  single.display_window = single.data_window = {0, 0, 9, 40};
  single.beauty = noise_buffer(9, 40, {"R", "G", "B"});
  expect_damage_is_survived(encoded(single), 1, decode);
  expect_damage_is_survived(encoded(full_file()), 331, decode);
}

}  // namespace
}  // namespace alhazen::render

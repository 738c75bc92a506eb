#include <gtest/gtest.h>
#include <vector>

#include "core/base/file.h"
#include "render/image/image_read.h"
#include "render/image/png_write.h"
#include "unit/render/image/damage.h"
#include "unit/render/image/png_file.h"
#include "unit/render/temporary_folder.h"

namespace alhazen::render {
namespace {

using namespace std::string_literals;

FloatBuffer decoded(const std::string& bytes) {
  Result<ReadImage> image = decode_image(bytes);
  EXPECT_TRUE(image) << (image ? "" : image.error().message);
  if (!image) return FloatBuffer(1, 1, {"R", "G", "B", "A"});
  EXPECT_EQ(image.value().format, ImageFormat::png);
  return std::move(image).value().pixels;
}

// All channels of the pixel.
std::vector<float> pixel(const FloatBuffer& buffer, int x, int y) {
  std::vector<float> values;
  for (std::size_t c = 0; c < buffer.channel_count(); ++c)
    values.push_back(buffer.at(c, x, y));
  return values;
}
using V = std::vector<float>;

TEST(Png, GrayOfOneBitIsBlackAndWhite) {
  const FloatBuffer image = decoded(PngFile{.width = 3,
                                            .height = 1,
                                            .bit_depth = 1,
                                            .color_type = 0,
                                            .chunks = "",
                                            .scanlines = "\0\xa0"s}
                                        .bytes());
  EXPECT_EQ(image.names(), (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_EQ(pixel(image, 0, 0), (V{1, 1, 1}));
  EXPECT_EQ(pixel(image, 1, 0), (V{0, 0, 0}));
  EXPECT_EQ(pixel(image, 2, 0), (V{1, 1, 1}));
}

TEST(Png, SixteenBitsAreKept) {
  const FloatBuffer image = decoded(PngFile{.width = 1,
                                            .height = 2,
                                            .bit_depth = 16,
                                            .chunks = "",
                                            .scanlines = "\0\x00\x01\x12\x34\xff\xff"s
                                                         "\0\x80\x00\x00\x00\xff\xfe"s}
                                        .bytes());
  EXPECT_EQ(pixel(image, 0, 0), (V{1.0F / 65535, 4660.0F / 65535, 1}));
  EXPECT_EQ(pixel(image, 0, 1), (V{32768.0F / 65535, 0, 65534.0F / 65535}));
}

TEST(Png, PaletteWithTransparency) {
  const FloatBuffer image = decoded(
      PngFile{.width = 2,
              .height = 1,
              .bit_depth = 4,
              .color_type = 3,
              .chunks = png_chunk("PLTE", "\x10\x20\x30\xff\x00\x33"s) + png_chunk("tRNS", "\x80"s),
              .scanlines = "\0\x10"s}
          .bytes());
  EXPECT_EQ(image.names(), (std::vector<std::string>{"R", "G", "B", "A"}));
  EXPECT_EQ(pixel(image, 0, 0), (V{1, 0, 51.0F / 255, 1}));
  EXPECT_EQ(pixel(image, 1, 0), (V{16.0F / 255, 32.0F / 255, 48.0F / 255, 128.0F / 255}));
}

TEST(Png, GammaChunkChangesNothing) {
  PngFile file{.width = 1, .height = 1, .chunks = "", .scanlines = "\0\x10\x80\xf0"s};
  const FloatBuffer plain = decoded(file.bytes());
  file.chunks = png_chunk("gAMA", big_endian_32(100000));
  EXPECT_EQ(decoded(file.bytes()), plain);
}

TEST(Png, InterlacedIsTheSamePicture) {
  // 8 x 8 gray, pixel (x, y) = 16 y + x. Adam7: start and step of x and y in each pass.
  const int passes[7][4] = {{0, 8, 0, 8}, {4, 8, 0, 8}, {0, 4, 4, 8}, {2, 4, 0, 4},
                            {0, 2, 2, 4}, {1, 2, 0, 2}, {0, 1, 1, 2}};
  PngFile file{
      .width = 8, .height = 8, .color_type = 0, .interlaced = 1, .chunks = "", .scanlines = ""};
  for (const auto& [x_first, x_step, y_first, y_step] : passes) {
    for (int y = y_first; y < 8; y += y_step) {
      file.scanlines += '\0';
      for (int x = x_first; x < 8; x += x_step)
        file.scanlines += static_cast<char>(16 * y + x);
    }
  }
  const FloatBuffer image = decoded(file.bytes());
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      EXPECT_EQ(image.at(1, x, y), static_cast<float>(16 * y + x) / 255.0F);
    }
  }
}

std::vector<std::uint8_t> all_bytes(std::size_t count) {
  std::vector<std::uint8_t> samples(count);
  for (std::size_t i = 0; i < count; ++i)
    samples[i] = static_cast<std::uint8_t>(i * 37);
  return samples;
}

TEST(Png, WrittenSamplesComeBack) {
  for (const int components : {3, 4}) {
    const auto samples = all_bytes(static_cast<std::size_t>(17 * 31 * components));
    const auto bytes = encode_png(samples, 17, 31, components);
    ASSERT_TRUE(bytes);
    EXPECT_EQ(encode_png(samples, 17, 31, components).value(), bytes.value()) << "deterministic";
    const FloatBuffer image = decoded(bytes.value());
    ASSERT_EQ(image.channel_count(), static_cast<std::size_t>(components));
    for (std::size_t i = 0; i < samples.size(); ++i) {
      ASSERT_EQ(image.channel(i % image.channel_count())[i / image.channel_count()],
                static_cast<float>(samples[i]) / 255.0F);
    }
  }
}

TEST(Png, FileAppearsWholeOrNotAtAll) {
  const TemporaryFolder folder;
  EXPECT_TRUE(write_png(folder.path() / "a.png", all_bytes(12), 2, 2, 3));
  EXPECT_TRUE(read_image(folder.path() / "a.png"));
  for (const auto& [width, height, components] : {std::tuple{3, 2, 3}, {0, 0, 3}, {2, 3, 2}}) {
    const Status status =
        write_png(folder.path() / "b.png", all_bytes(12), width, height, components);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::usage);
  }
  EXPECT_FALSE(write_png(folder.path() / "missing" / "c.png", all_bytes(12), 2, 2, 3));
  EXPECT_EQ(folder.entries(), 1);
}

TEST(Png, HugeSizeIsALimitErrorBeforeMemoryIsTaken) {
  const auto image = decode_image(
      PngFile{.width = 2147483647, .height = 2147483647, .chunks = "", .scanlines = "\0"s}.bytes());
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, ErrorCode::limit);
}

TEST(Png, DamageIsSurvived) {
  const ImageLimits limits{.max_pixels = 1 << 12, .max_samples = 1 << 16};
  const auto decode = [&](std::string_view bytes) { return decode_image(bytes, limits); };
  expect_damage_is_survived(encode_png(all_bytes(9 * 11 * 4), 9, 11, 4).value(), 1, decode);
  const PngFile palette{
      .width = 2,
      .height = 2,
      .bit_depth = 4,
      .color_type = 3,
      .interlaced = 1,
      .chunks = png_chunk("PLTE", "\x10\x20\x30\xff\x00\x33"s) + png_chunk("tRNS", "\x80"s),
      .scanlines = "\0\x10\0\x10\0\x10"s};
  expect_damage_is_survived(palette.bytes(), 1, decode);
}

}  // namespace
}  // namespace alhazen::render

#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <vector>

// After <cstdio>, which jpeglib.h needs.
#include <jpeglib.h>

#include "render/image/image_read.h"
#include "unit/render/image/damage.h"

namespace alhazen::render {
namespace {

enum class Scans { sequential, progressive, by_spectrum };

// Quality 100, no subsampling: the tables are all ones.
std::string jpeg_file(int width, int height, J_COLOR_SPACE space, Scans scans,
                      const std::vector<JSAMPLE>& samples) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = static_cast<JDIMENSION>(width);
  jpeg.image_height = static_cast<JDIMENSION>(height);
  jpeg.input_components = space == JCS_GRAYSCALE ? 1 : space == JCS_CMYK ? 4 : 3;
  jpeg.in_color_space = space;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 100, TRUE);
  jpeg.comp_info[0].h_samp_factor = jpeg.comp_info[0].v_samp_factor = 1;
  // One scan for the means of the blocks of the one component, one for the other coefficients.
  const jpeg_scan_info by_spectrum[2] = {{1, {0}, 0, 0, 0, 0}, {1, {0}, 1, 63, 0, 0}};
  if (scans == Scans::progressive) jpeg_simple_progression(&jpeg);
  if (scans == Scans::by_spectrum) {
    jpeg.scan_info = by_spectrum;
    jpeg.num_scans = 2;
  }
  jpeg_start_compress(&jpeg, TRUE);
  std::vector<JSAMPLE> rows = samples;
  const std::size_t stride =
      static_cast<std::size_t>(width) * static_cast<std::size_t>(jpeg.input_components);
  while (jpeg.next_scanline < jpeg.image_height) {
    JSAMPROW row = rows.data() + stride * jpeg.next_scanline;
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  std::string result(reinterpret_cast<const char*>(bytes), size);
  jpeg_destroy_compress(&jpeg);
  std::free(bytes);
  return result;
}

std::vector<JSAMPLE> ramp(std::size_t count) {
  std::vector<JSAMPLE> samples(count);
  for (std::size_t i = 0; i < count; ++i)
    samples[i] = static_cast<JSAMPLE>(i % 251);
  return samples;
}

FloatBuffer decoded(const std::string& bytes) {
  Result<ReadImage> image = decode_image(bytes);
  EXPECT_TRUE(image) << (image ? "" : image.error().message);
  if (!image) return FloatBuffer(1, 1, {"R", "G", "B"});
  EXPECT_EQ(image.value().format, ImageFormat::jpeg);
  return std::move(image).value().pixels;
}

TEST(Jpeg, GrayIsRepeatedAndWithinOneStep) {
  for (const Scans scans : {Scans::sequential, Scans::progressive, Scans::by_spectrum}) {
    const auto samples = ramp(19 * 13);
    const FloatBuffer image = decoded(jpeg_file(19, 13, JCS_GRAYSCALE, scans, samples));
    ASSERT_EQ(image.width(), 19);
    ASSERT_EQ(image.height(), 13);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      // With all quantisers 1 each coefficient is off by at most half; a sample by about one step
      // (the transform is orthogonal, so 0.29 root mean square).
      EXPECT_NEAR(image.channel(0)[i] * 255.0F, samples[i], 1.5F);
      EXPECT_EQ(image.channel(0)[i], image.channel(1)[i]);
      EXPECT_EQ(image.channel(0)[i], image.channel(2)[i]);
    }
  }
}

TEST(Jpeg, ConstantColorComesBack) {
  std::vector<JSAMPLE> samples;
  for (int i = 0; i < 16 * 16; ++i)
    samples.insert(samples.end(), {200, 100, 50});
  const FloatBuffer image = decoded(jpeg_file(16, 16, JCS_RGB, Scans::sequential, samples));
  // Y, Cb and Cr are rounded to integers: half a step of Cb is 0.89 of blue, half of Y 0.5.
  EXPECT_NEAR(image.at(0, 7, 7) * 255.0F, 200.0F, 2.0F);
  EXPECT_NEAR(image.at(1, 7, 7) * 255.0F, 100.0F, 2.0F);
  EXPECT_NEAR(image.at(2, 7, 7) * 255.0F, 50.0F, 2.0F);
}

TEST(Jpeg, CmykIsUnsupportedAndSizesAreLimited) {
  const auto cmyk = decode_image(jpeg_file(8, 8, JCS_CMYK, Scans::sequential, ramp(256)));
  ASSERT_FALSE(cmyk);
  EXPECT_EQ(cmyk.error().code, ErrorCode::unsupported);
  const auto large =
      decode_image(jpeg_file(8, 8, JCS_GRAYSCALE, Scans::sequential, ramp(64)), {.max_pixels = 63});
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().code, ErrorCode::limit);
}

TEST(Jpeg, ScansBeyondAllReasonAreAnError) {
  // The last scan again and again: each is valid and says the same, and costs a whole picture.
  const std::string file = jpeg_file(8, 8, JCS_GRAYSCALE, Scans::by_spectrum, ramp(64));
  const std::size_t last_scan = file.rfind("\xff\xda");
  const std::string scan = file.substr(last_scan, file.size() - 2 - last_scan);
  const auto repeated = [&](int times) {
    std::string bytes = file.substr(0, last_scan);
    for (int i = 0; i < times; ++i)
      bytes += scan;
    return decode_image(bytes + "\xff\xd9");
  };
  EXPECT_TRUE(repeated(100));
  const auto bomb = repeated(1000);
  ASSERT_FALSE(bomb);
  EXPECT_NE(bomb.error().message.find("more than 200 scans"), std::string::npos);
}

TEST(Jpeg, DamageIsSurvived) {
  const ImageLimits limits{.max_pixels = 1 << 12, .max_samples = 1 << 16};
  const auto decode = [&](std::string_view bytes) { return decode_image(bytes, limits); };
  expect_damage_is_survived(jpeg_file(19, 13, JCS_RGB, Scans::sequential, ramp(3 * 19 * 13)), 1,
                            decode);
  expect_damage_is_survived(jpeg_file(19, 13, JCS_RGB, Scans::progressive, ramp(3 * 19 * 13)), 1,
                            decode);
}

}  // namespace
}  // namespace alhazen::render

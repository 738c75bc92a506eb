#include "render/image/image_read.h"

#include <gtest/gtest.h>

#include "core/base/file.h"
#include "render/image/exr_write.h"
#include "render/image/png_write.h"
#include "unit/render/temporary_folder.h"

namespace alhazen::render {
namespace {

std::string exr_with(std::vector<std::string> names) {
  ExrFile file;
  file.display_window = {0, 0, 4, 4};
  file.data_window = {1, 1, 2, 2};
  file.beauty = FloatBuffer(2, 2, std::move(names));
  for (std::size_t c = 0; c < file.beauty.channel_count(); ++c) {
    file.beauty.at(c, 1, 0) = static_cast<float>(c + 1);
  }
  return encode_exr(file).value().bytes;
}

TEST(ImageRead, FormatIsToldByTheBytesNotTheName) {
  const TemporaryFolder folder;
  const std::vector<std::uint8_t> white(3, 255);
  ASSERT_TRUE(write_png(folder.path() / "really_png.exr", white, 1, 1, 3));
  ASSERT_TRUE(write_file_atomic(folder.path() / "really_exr.png", exr_with({"R", "G", "B"})));
  EXPECT_EQ(read_image(folder.path() / "really_png.exr").value().format, ImageFormat::png);
  EXPECT_EQ(read_image(folder.path() / "really_exr.png").value().format, ImageFormat::exr);
}

TEST(ImageRead, ExrGivesItsColorsOfTheDataWindow) {
  const auto image = decode_image(exr_with({"B", "A", "G", "R", "extra"}));
  ASSERT_TRUE(image);
  const FloatBuffer& pixels = image.value().pixels;
  EXPECT_EQ(pixels.names(), (std::vector<std::string>{"R", "G", "B", "A"}));
  EXPECT_EQ(pixels.width(), 2);
  EXPECT_EQ(pixels.at(0, 1, 0), 4.0F);
  EXPECT_EQ(pixels.at(1, 1, 0), 3.0F);
  EXPECT_EQ(pixels.at(2, 1, 0), 1.0F);
  EXPECT_EQ(pixels.at(3, 1, 0), 2.0F);
}

TEST(ImageRead, GrayExrIsRepeated) {
  const auto image = decode_image(exr_with({"Y"}));
  ASSERT_TRUE(image);
  EXPECT_EQ(image.value().pixels.names(), (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_EQ(image.value().pixels.at(2, 1, 0), 1.0F);
}

TEST(ImageRead, ErrorsNameTheFileAndWhatItHas) {
  const TemporaryFolder folder;
  const auto message = [&](std::string_view bytes) {
    EXPECT_TRUE(write_file_atomic(folder.path() / "x", bytes));
    const auto image = read_image(folder.path() / "x");
    EXPECT_FALSE(image);
    return image ? "" : image.error().message;
  };
  EXPECT_NE(message("").find("x`: not a PNG, JPEG or EXR file"), std::string::npos);
  EXPECT_NE(message("GIF89a").find("not a PNG, JPEG or EXR file"), std::string::npos);
  EXPECT_NE(message(exr_with({"Z", "N.X"})).find("it has: `N.X`, `Z`"), std::string::npos);
  EXPECT_EQ(read_image(folder.path() / "missing").error().code, ErrorCode::io);
  EXPECT_EQ(read_image(folder.path() / "x", {.max_file_bytes = 10}).error().code, ErrorCode::limit);
}

}  // namespace
}  // namespace alhazen::render

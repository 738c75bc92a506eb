#include "render/image/jpeg_read.h"

#include <csetjmp>
#include <cstdio>
#include <fmt/format.h>
#include <vector>

// After <cstdio>: jpeglib.h uses FILE and size_t without including what declares them.
#include <jerror.h>
#include <jpeglib.h>

#include "render/image/unpack.h"

namespace alhazen::render {
namespace {

// libjpeg reports an error by calling us, and we must not return: a long jump, which runs no
// destructor. As in png_read.cpp the functions that are left that way hold only plain values.
class JpegReader {
 public:
  explicit JpegReader(std::string_view bytes) : bytes_(bytes) {
    jpeg_.err = jpeg_std_error(&errors_);
    errors_.error_exit = on_error;
    errors_.emit_message = on_message;
    errors_.output_message = [](j_common_ptr) {};
    progress_.progress_monitor = on_progress;
    jpeg_.client_data = this;
  }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;
  ~JpegReader() { jpeg_destroy_decompress(&jpeg_); }

  bool read_header() {
    if (setjmp(escape_) != 0) return false;
    jpeg_create_decompress(&jpeg_);
    jpeg_.progress = &progress_;
    jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(bytes_.data()),
                 static_cast<unsigned long>(bytes_.size()));
    jpeg_read_header(&jpeg_, TRUE);
    // What inks look like is a colour decision that no library default should take.
    is_cmyk_ = jpeg_.num_components == 4;
    if (!is_cmyk_) jpeg_.out_color_space = JCS_RGB;
    jpeg_.dct_method = JDCT_ISLOW;  // the accurate one; the same bits with and without SIMD
    return true;
  }

  // Precondition: room for height() rows of 3 * width() samples.
  bool read_pixels(JSAMPLE* samples) {
    if (setjmp(escape_) != 0) return false;
    jpeg_start_decompress(&jpeg_);
    while (jpeg_.output_scanline < jpeg_.output_height) {
      JSAMPROW row = samples + std::size_t{3} * jpeg_.output_width * jpeg_.output_scanline;
      jpeg_read_scanlines(&jpeg_, &row, 1);
    }
    jpeg_finish_decompress(&jpeg_);
    return true;
  }

  std::size_t width() const { return jpeg_.image_width; }
  std::size_t height() const { return jpeg_.image_height; }
  bool is_cmyk() const { return is_cmyk_; }
  const char* message() const { return message_; }

 private:
  // A progressive file of a few bytes can ask for the whole picture to be gone through any number
  // of times. Encoders write about ten scans.
  static constexpr int kMostScans = 200;

  static JpegReader& reader(j_common_ptr jpeg) {
    return *static_cast<JpegReader*>(jpeg->client_data);
  }
  [[noreturn]] static void on_error(j_common_ptr jpeg) {
    jpeg->err->format_message(jpeg, reader(jpeg).message_);
    std::longjmp(reader(jpeg).escape_, 1);
  }
  // Level -1 is damage that libjpeg would patch over with gray; the others are chatter. Stray bytes
  // between segments harm nobody and are common in pictures of cameras.
  static void on_message(j_common_ptr jpeg, int level) {
    if (level == -1 && jpeg->err->msg_code != JWRN_EXTRANEOUS_DATA) on_error(jpeg);
  }
  static void on_progress(j_common_ptr jpeg) {
    if (reader(jpeg).jpeg_.input_scan_number > kMostScans) {
      std::snprintf(reader(jpeg).message_, sizeof message_, "more than %d scans", kMostScans);
      std::longjmp(reader(jpeg).escape_, 1);
    }
  }

  std::string_view bytes_;
  jpeg_decompress_struct jpeg_{};
  jpeg_error_mgr errors_{};
  jpeg_progress_mgr progress_{};
  std::jmp_buf escape_{};
  char message_[JMSG_LENGTH_MAX] = "";
  bool is_cmyk_ = false;
};

Error damaged(const JpegReader& reader) {
  return {ErrorCode::io, fmt::format("damaged JPEG file: {}", reader.message())};
}

}  // namespace

bool is_jpeg(std::string_view bytes) {
  return bytes.substr(0, 3) == "\xff\xd8\xff";
}

Result<FloatBuffer> decode_jpeg(std::string_view bytes, const ImageLimits& limits) {
  JpegReader reader(bytes);
  if (!reader.read_header()) return damaged(reader);
  if (reader.is_cmyk()) {
    return Error{ErrorCode::unsupported, "CMYK JPEG is not supported; convert it to RGB"};
  }
  if (const Status kept = within_limits(reader.width(), reader.height(), 3, limits); !kept) {
    return kept.error();
  }
  std::vector<JSAMPLE> samples(3 * reader.width() * reader.height());
  if (!reader.read_pixels(samples.data())) return damaged(reader);
  return unpack<JSAMPLE>(samples, static_cast<int>(reader.width()),
                         static_cast<int>(reader.height()), 3);
}

}  // namespace alhazen::render

#include "render/image/png_read.h"

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <fmt/format.h>
#include <png.h>
#include <string>
#include <vector>

#include "render/image/unpack.h"

namespace alhazen::render {
namespace {

// libpng reports an error by a long jump, which runs no destructor. So every object with one lives
// here, in the frame of the caller; the functions that libpng may leave hold only plain values.
class PngReader {
 public:
  explicit PngReader(std::string_view bytes)
      : left_(bytes),
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning)),
        info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {}
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

  bool ready() const { return info_ != nullptr; }

  // Everything before the pixels; sets width() and height().
  bool read_header() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_read_fn(png_, this, on_read);
    // Our own limit is on the number of pixels and is checked by the caller.
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_chunk_malloc_max(png_, kLargestChunk);
    png_read_info(png_, info_);
    return true;
  }

  // Asks for 8 or 16 bits and three or four components. This allocates rows, so the width must have
  // been found harmless.
  bool prepare_pixels() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_expand(png_);  // palette to colour, 1, 2 and 4 bits to 8, transparent colour to alpha
    png_set_gray_to_rgb(png_);
    if constexpr (std::endian::native == std::endian::little) png_set_swap(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }

  // Precondition: `rows` has height() rows of row_bytes() bytes.
  bool read_pixels(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

  std::size_t width() const { return png_get_image_width(png_, info_); }
  std::size_t height() const { return png_get_image_height(png_, info_); }
  std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }
  int components() const { return png_get_channels(png_, info_); }
  bool is_16_bit() const { return png_get_bit_depth(png_, info_) == 16; }
  const char* message() const { return message_; }

 private:
  // Text and colour profiles are not even looked at; nothing else needs a large chunk in memory.
  static constexpr png_alloc_size_t kLargestChunk = 1 << 23;

  static void on_error(png_structp png, png_const_charp message) {
    auto* reader = static_cast<PngReader*>(png_get_error_ptr(png));
    // libpng's messages are shorter than this; a longer one is cut.
    std::size_t i = 0;
    for (; message[i] != '\0' && i + 1 < sizeof reader->message_; ++i) {
      reader->message_[i] = message[i];
    }
    reader->message_[i] = '\0';
    png_longjmp(png, 1);
  }
  static void on_warning(png_structp, png_const_charp) {}
  static void on_read(png_structp png, png_bytep bytes, std::size_t count) {
    auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
    if (count > reader->left_.size()) png_error(png, "unexpected end of file");
    std::copy_n(reader->left_.begin(), count, bytes);
    reader->left_.remove_prefix(count);
  }

  std::string_view left_;
  char message_[128] = "";
  png_structp png_;
  png_infop info_;
};

Error damaged(const PngReader& reader) {
  return {ErrorCode::io, fmt::format("damaged PNG file: {}", reader.message())};
}

template <class Sample>
Result<FloatBuffer> read_pixels(PngReader& reader) {
  const std::size_t stride = reader.row_bytes() / sizeof(Sample);
  std::vector<Sample> samples(stride * reader.height());
  std::vector<png_bytep> rows;
  for (std::size_t row = 0; row < reader.height(); ++row) {
    rows.push_back(reinterpret_cast<png_bytep>(samples.data() + row * stride));
  }
  if (!reader.read_pixels(rows.data())) return damaged(reader);
  return unpack<Sample>(samples, static_cast<int>(reader.width()),
                        static_cast<int>(reader.height()), reader.components());
}

}  // namespace

bool is_png(std::string_view bytes) {
  return bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n";
}

Result<FloatBuffer> decode_png(std::string_view bytes, const ImageLimits& limits) {
  PngReader reader(bytes);
  if (!reader.ready()) return Error{ErrorCode::limit, "out of memory"};
  if (!reader.read_header()) return damaged(reader);
  if (const Status kept = within_limits(reader.width(), reader.height(), 4, limits); !kept) {
    return kept.error();
  }
  if (!reader.prepare_pixels()) return damaged(reader);
  return reader.is_16_bit() ? read_pixels<std::uint16_t>(reader)
                            : read_pixels<std::uint8_t>(reader);
}

}  // namespace alhazen::render

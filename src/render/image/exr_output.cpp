#include "render/image/exr_output.h"

#include <algorithm>
#include <exception>
#include <fmt/format.h>
#include <stdexcept>

namespace alhazen::render {
namespace {

void check(exr_result_t code, std::string_view what) {
  if (code == EXR_ERR_SUCCESS) return;
  throw std::runtime_error(
      fmt::format("OpenEXR refuses {}: {}", what, ::exr_get_default_error_message(code)));
}

void check_attribute(exr_result_t code, const std::string& name) {
  check(code, fmt::format("the attribute `{}`", name));
}

// Without a handler OpenEXR prints. In this one nothing can be asked of the context, not even its
// user data: release 3.1 calls it while it holds the context's lock.
void ignore_message(exr_const_context_t, exr_result_t, const char*) {}

// No exception may pass through OpenEXR; it reports the -1 as an error of writing.
std::int64_t write_to_string(exr_const_context_t, void* string, const void* data,
                             std::uint64_t size, std::uint64_t offset,
                             exr_stream_error_func_ptr_t) noexcept {
  auto& bytes = *static_cast<std::string*>(string);
  try {
    if (bytes.size() < offset + size) bytes.resize(offset + size);
  } catch (const std::exception&) {
    return -1;
  }
  std::copy_n(static_cast<const char*>(data), size,
              bytes.begin() + static_cast<std::ptrdiff_t>(offset));
  return static_cast<std::int64_t>(size);
}

exr_attr_v2f_t vector(Xy xy) {
  exr_attr_v2f_t vector{};
  vector.x = static_cast<float>(xy.x);
  vector.y = static_cast<float>(xy.y);
  return vector;
}

exr_attr_box2i_t box(const PixelWindow& window) {
  exr_attr_box2i_t box{};
  box.min.x = window.x;
  box.min.y = window.y;
  box.max.x = window.x + window.width - 1;
  box.max.y = window.y + window.height - 1;
  return box;
}

}  // namespace

ExrOutput::ExrOutput() {
  exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
  start.error_handler_fn = ignore_message;
  start.user_data = &bytes_;
  start.write_fn = write_to_string;
  check(::exr_start_write(&context_, "memory", EXR_WRITE_FILE_DIRECTLY, &start), "to begin");
}

ExrOutput::~ExrOutput() {
  ::exr_finish(&context_);
}

void ExrOutput::add_part(const std::string& name, const PixelWindow& display_window,
                         const PixelWindow& data_window, exr_compression_t compression) {
  const exr_attr_box2i_t display = box(display_window), data = box(data_window);
  const exr_attr_v2f_t center = vector({0, 0});
  check(::exr_add_part(context_, name.c_str(), EXR_STORAGE_SCANLINE, &part_), "a part");
  check(::exr_initialize_required_attr(context_, part_, &display, &data, 1, &center, 1,
                                       EXR_LINEORDER_INCREASING_Y, compression),
        "the windows of the picture");
}

void ExrOutput::add_channel(const ExrChannel& channel) {
  const exr_pixel_type_t type = channel.type == SampleType::half ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT;
  check(::exr_add_channel(context_, part_, announced(channel.name), type,
                          EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1),
        fmt::format("the channel `{}`", channel.name));
}

void ExrOutput::add(const std::string& name, const std::string& value) {
  check_attribute(::exr_attr_set_string(context_, part_, announced(name), value.c_str()), name);
}

void ExrOutput::add(const std::string& name, int value) {
  check_attribute(::exr_attr_set_int(context_, part_, announced(name), value), name);
}

void ExrOutput::add(const std::string& name, float value) {
  check_attribute(::exr_attr_set_float(context_, part_, announced(name), value), name);
}

void ExrOutput::add(const std::string& name, Xy value) {
  const exr_attr_v2f_t stored = vector(value);
  check_attribute(::exr_attr_set_v2f(context_, part_, announced(name), &stored), name);
}

void ExrOutput::add(const std::string& name, const PixelWindow& value) {
  const exr_attr_box2i_t stored = box(value);
  check_attribute(::exr_attr_set_box2i(context_, part_, announced(name), &stored), name);
}

void ExrOutput::add(const std::string& name, const Chromaticities& value) {
  const exr_attr_v2f_t red = vector(value.red), green = vector(value.green),
                       blue = vector(value.blue), white = vector(value.white);
  const exr_attr_chromaticities_t stored{red.x,  red.y,  green.x, green.y,
                                         blue.x, blue.y, white.x, white.y};
  check_attribute(::exr_attr_set_chromaticities(context_, part_, announced(name), &stored), name);
}

void ExrOutput::add(const std::string& name, const exr_attr_m44f_t& value) {
  check_attribute(::exr_attr_set_m44f(context_, part_, announced(name), &value), name);
}

const char* ExrOutput::announced(const std::string& name) {
  constexpr std::size_t kShort = 31;
  if (name.size() > kShort) check(::exr_set_longname_support(context_, 1), "long names");
  return name.c_str();
}

void ExrOutput::end_header() {
  check(::exr_write_header(context_), "the header");
}

int ExrOutput::chunk_rows(int part) const {
  std::int32_t rows = 0;
  check(::exr_get_scanlines_per_chunk(context_, part, &rows), "a part");
  return rows;
}

void ExrOutput::write_chunk(int part, int row, std::string_view bytes) {
  check(::exr_write_scanline_chunk(context_, part, row, bytes.data(), bytes.size()), "a chunk");
}

std::string ExrOutput::finish() {
  check(::exr_finish(&context_), "to end");
  return std::move(bytes_);
}

}  // namespace alhazen::render

#include "render/image/exr_scan.h"

#include <cstdint>
#include <optional>

namespace alhazen::render {
namespace {

// Reads the layout of an EXR header: attributes as name \0 type \0 size data, a part ends with an
// empty name, and so do the parts of a file of several.
class HeaderScan {
 public:
  explicit HeaderScan(std::string_view bytes) : left_(bytes) {}

  // Little-endian.
  std::optional<std::uint32_t> word() {
    if (left_.size() < 4) return std::nullopt;
    std::uint32_t value = 0;
    for (std::size_t i = 4; i > 0; --i) {
      value = value << 8 | static_cast<unsigned char>(left_[i - 1]);
    }
    left_.remove_prefix(4);
    return value;
  }

  std::optional<std::string_view> text() {
    const std::size_t end = left_.find('\0');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view result = left_.substr(0, end);
    left_.remove_prefix(end + 1);
    return result;
  }

  bool skip(std::uint32_t count) {
    if (count > left_.size()) return false;
    left_.remove_prefix(count);
    return true;
  }

 private:
  std::string_view left_;
};

}  // namespace

bool attributes_fit(std::string_view bytes) {
  HeaderScan scan(bytes);
  scan.word();  // the magic number
  const auto version = scan.word();
  if (!version) return false;
  constexpr std::uint32_t kMultiPart = 1U << 12;
  const bool several_parts = (*version & kMultiPart) != 0;
  for (bool at_start = true;;) {
    const auto name = scan.text();
    if (!name) return false;
    if (name->empty()) {
      if (!several_parts || at_start) return true;
      at_start = true;
      continue;
    }
    at_start = false;
    if (!scan.text()) return false;  // its type
    const auto size = scan.word();
    if (!size || !scan.skip(*size)) return false;
  }
}

}  // namespace alhazen::render

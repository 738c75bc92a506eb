#include "app/nff/token.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <system_error>

namespace alhazen {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";
constexpr double kLargest = 1e100;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Past the digits at the beginning of `text`; whether there were any.
bool skip_digits(std::string_view& text) {
  const auto end = std::ranges::find_if_not(text, is_digit);
  const bool any = end != text.begin();
  text.remove_prefix(static_cast<std::size_t>(end - text.begin()));
  return any;
}

// std::from_chars takes more than NFF: inf, nan(...). `unsigned_text` is without its sign.
bool is_decimal(std::string_view unsigned_text) {
  std::string_view rest = unsigned_text;
  bool digits = skip_digits(rest);
  if (rest.starts_with('.')) {
    rest.remove_prefix(1);
    digits = skip_digits(rest) || digits;
  }
  if (!digits) return false;
  if (rest.starts_with('e') || rest.starts_with('E')) {
    rest.remove_prefix(1);
    if (rest.starts_with('+') || rest.starts_with('-')) rest.remove_prefix(1);
    if (!skip_digits(rest)) return false;
  }
  return rest.empty();
}

}  // namespace

NffTokens::NffTokens(FileId file, const SourceManager& sources)
    : file_(file), text_(sources.text(file)), next_(scan()) {}

NffToken NffTokens::take() {
  const NffToken taken = next_;
  next_ = scan();
  return taken;
}

NffToken NffTokens::scan() {
  while (at_ < text_.size()) {
    at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size());
    if (at_ == text_.size() || text_[at_] != '#') break;
    at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
  }
  const std::size_t begin = at_;
  // A comment may touch the word before it.
  while (at_ < text_.size() && text_[at_] != '#' && kBlanks.find(text_[at_]) == kBlanks.npos)
    ++at_;
  return {text_.substr(begin, at_ - begin),
          {file_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)}};
}

NffNumber read_nff_number(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (!is_decimal(text)) return {};
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  // Out of range is too small or too large; the library does not say which and leaves `value` as
  // it was. strtod does, at its leisure.
  if (read.ec == std::errc::result_out_of_range)
    value = std::strtod(std::string(text).c_str(), nullptr);
  if (value < std::numeric_limits<double>::min()) return {0, NffNumberState::good};
  if (value > kLargest) return {0, NffNumberState::too_large};
  return {negative ? -value : value, NffNumberState::good};
}

std::string describe(const NffToken& token) {
  if (token.is_end()) return "the end of the file";
  std::string text(token.text);
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '\x7f'; }, '?');
  return '`' + text + '`';
}

}  // namespace alhazen

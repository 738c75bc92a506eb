#include "core/diag/diagnostic.h"

#include <algorithm>

namespace alhazen {

namespace {

constexpr std::size_t kLongestQuote = 80, kKeptOfQuote = 36;  // at each end

bool continues_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

void append_shortened(std::string& out, std::string_view quoted) {
  std::size_t head = kKeptOfQuote, tail = quoted.size() - kKeptOfQuote;
  while (head > 0 && continues_character(quoted[head]))
    --head;
  while (tail < quoted.size() && continues_character(quoted[tail]))
    ++tail;
  out.append(quoted.substr(0, head)).append("\u2026").append(quoted.substr(tail));
}

}  // namespace

std::string shorten_quotes(std::string message) {
  if (message.size() <= kLongestQuote) return message;
  std::string out;
  bool is_quoted = false;
  for (std::size_t begin = 0; begin <= message.size(); is_quoted = !is_quoted) {
    const std::size_t end = std::min(message.find('`', begin), message.size());
    const std::string_view part = std::string_view(message).substr(begin, end - begin);
    if (is_quoted && part.size() > kLongestQuote && end < message.size()) {
      append_shortened(out, part);
    } else {
      out.append(part);
    }
    if (end < message.size()) out += '`';
    begin = end + 1;
  }
  return out;
}

Diagnostic& DiagnosticSink::add(Diagnostic diagnostic) {
  const bool is_error = diagnostic.severity == Severity::error;
  const bool repeated =
      diagnostic.span.known() &&
      std::any_of(diagnostics_.begin(), diagnostics_.end(), [&](const Diagnostic& earlier) {
        return earlier.severity == diagnostic.severity &&
               earlier.span.file == diagnostic.span.file &&
               earlier.span.begin == diagnostic.span.begin;
      });
  if (repeated || (is_error && full())) {
    truncated_ = truncated_ || !repeated;
    dropped_ = std::move(diagnostic);
    return dropped_;
  }
  if (is_error) ++error_count_;
  diagnostics_.push_back(std::move(diagnostic));
  return diagnostics_.back();
}

ErrorCode DiagnosticSink::code() const {
  return std::find_if(diagnostics_.begin(), diagnostics_.end(),
                      [](const Diagnostic& d) { return d.severity == Severity::error; })
      ->code;
}

}  // namespace alhazen

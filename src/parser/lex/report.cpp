#include "parser/lex/report.h"

#include <fmt/format.h>
#include <string>

#include "parser/lex/characters.h"
#include "parser/lex/foreign.h"
#include "parser/lex/utf8.h"

namespace alhazen::parser {
namespace {

using Kind = DiagnosticKind;

class FlawReporter {
 public:
  FlawReporter(const Token& token, FileId file, std::string_view text, DiagnosticSink& sink)
      : token_(token),
        span_{file, token.begin, token.end},
        word_(text.substr(token.begin, token.end - token.begin)),
        sink_(sink) {}

  void report();

 private:
  void report_unexpected();
  void report_name();
  void report_look_alike();
  void report_foreign();
  void report_unit();
  void report_unterminated_string();
  void report_inside_string();

  const Token& token_;
  SourceSpan span_;
  std::string_view word_;
  DiagnosticSink& sink_;
};

void FlawReporter::report() {
  switch (token_.flaw) {
    case Flaw::none:
      break;
    case Flaw::unexpected_character:
      report_unexpected();
      break;
    case Flaw::look_alike:
      report_look_alike();
      break;
    case Flaw::foreign_spelling:
      report_foreign();
      break;
    case Flaw::non_ascii_name:
      report_name();
      break;
    case Flaw::number_too_large:
      sink_.report<Kind::number_too_large>(span_, word_)
          .hint("the largest number is about 1.8e308");
      break;
    case Flaw::number_too_small:
      sink_.report<Kind::number_too_small>(span_, word_)
          .hint("it would be read as 0; write `0` if that is meant");
      break;
    case Flaw::malformed_number:
      sink_.report<Kind::malformed_number>(span_, word_)
          .hint("a number is written like `2`, `0.5`, `.5` or `1.5e-3`");
      break;
    case Flaw::unknown_unit:
      report_unit();
      break;
    case Flaw::malformed_color:
      sink_.report<Kind::malformed_color>(span_, word_)
          .hint("a colour is `#` and three or six hexadecimal digits, like `#fa0` or `#ffaa00`");
      break;
    case Flaw::unterminated_string:
      report_unterminated_string();
      break;
    case Flaw::unknown_escape:
    case Flaw::control_character:
    case Flaw::invalid_utf8:
      report_inside_string();
      break;
    case Flaw::wrong_quotes:
      sink_.report<Kind::wrong_quotes>(span_).hint("put the text between `\"` and `\"`");
      break;
    case Flaw::unterminated_comment:
      sink_.report<Kind::unterminated_comment>({span_.file, span_.begin, span_.begin + 2})
          .hint("comments nest: each `/*` needs a `*/` of its own");
      break;
    case Flaw::misplaced_header:
      sink_.report<Kind::misplaced_header>(span_).hint(
          "the header stands once, on the first line of the file");
      break;
  }
}

void FlawReporter::report_unexpected() {
  const CodePoint code = decode_utf8(word_);
  const bool control = code.value < 0x20 || code.value == 0x7F;
  sink_.report<Kind::unexpected_character>(
      span_, control ? fmt::format("\\x{:02x}", word_[0]) : std::string(word_));
}

void FlawReporter::report_name() {
  for (std::uint32_t i = 0; i < word_.size();) {
    const CodePoint code = decode_utf8(word_.substr(i));
    if (!code.valid) {
      sink_
          .report<Kind::invalid_encoding>({span_.file, span_.begin + i, span_.begin + i + 1},
                                          static_cast<unsigned char>(word_[i]))
          .hint("save the file as UTF-8");
      return;
    }
    i += code.length;
  }
  sink_.report<Kind::non_ascii_name>(span_, word_)
      .hint("names are made of the letters a to z and A to Z, digits and `_`");
}

void FlawReporter::report_look_alike() {
  const CodePoint code = decode_utf8(word_);
  const auto look_alike = match_look_alike(code.value);
  sink_.report<Kind::look_alike>(span_, static_cast<std::uint32_t>(code.value))
      .hint("replace it by " + look_alike->write);
}

void FlawReporter::report_foreign() {
  if (token_.kind == TokenKind::comment) {
    sink_.report<Kind::foreign_spelling>({span_.file, span_.begin, span_.begin + 1}, "#")
        .hint("a comment begins with `//`");
    return;
  }
  // The token may go on with what belongs to the foreign construct.
  std::size_t length = 1;
  while (length < word_.size() && continues_name(word_[length]))
    ++length;
  const Foreign* foreign = match_directive(word_.substr(0, length));
  if (foreign == nullptr) foreign = match_foreign_operator(word_);
  const auto end = span_.begin + static_cast<std::uint32_t>(foreign->spelling.size());
  sink_.report<Kind::foreign_spelling>({span_.file, span_.begin, end}, foreign->spelling)
      .hint(std::string(foreign->hint));
}

void FlawReporter::report_unit() {
  std::size_t number_end = 0;
  while (number_end < word_.size() && (is_digit(word_[number_end]) || word_[number_end] == '.')) {
    ++number_end;
  }
  const std::string_view number = word_.substr(0, number_end);
  const std::string_view unit = word_.substr(number_end);
  const SourceSpan unit_span{span_.file, span_.begin + static_cast<std::uint32_t>(number_end),
                             span_.end};
  Diagnostic& report = sink_.report<Kind::unknown_unit>(unit_span, unit);
  if (number == "0" && (unit.starts_with('x') || unit.starts_with('b'))) {
    report.hint("numbers are decimal");
  } else if (unit.starts_with('_')) {
    report.hint("the digits of a number are not grouped");
  } else if (unit == "f" || unit == "F") {
    report.hint("numbers carry no suffix");
  } else if (unit.starts_with("d") || unit.starts_with("D")) {
    report.hint(fmt::format("write `{}deg`", number));
  } else if (unit.starts_with("r") || unit.starts_with("R")) {
    report.hint(fmt::format("write `{}rad`", number));
  } else {
    report.hint("lengths have no unit, angles have `deg` or `rad`");
  }
}

void FlawReporter::report_unterminated_string() {
  Diagnostic& report = sink_.report<Kind::unterminated_string>(span_);
  if (word_.ends_with("\\\"")) {
    report.hint("`\\\"` is a quotation mark inside of the string; a backslash is written `\\\\`");
  } else {
    report.hint("a string ends with `\"` on the line it begins on; `\\n` is a line break in it");
  }
}

// The token is the whole string; what is wrong is one place in it, found again here.
void FlawReporter::report_inside_string() {
  for (std::uint32_t i = 1; i + 1 < word_.size();) {
    const CodePoint code = decode_utf8(word_.substr(i));
    const SourceSpan place{span_.file, span_.begin + i, span_.begin + i + code.length};
    const bool control = code.valid && (code.value < 0x20 || code.value == 0x7F);
    if (token_.flaw == Flaw::invalid_utf8 && !code.valid) {
      sink_.report<Kind::invalid_encoding>(place, static_cast<unsigned char>(word_[i]))
          .hint("save the file as UTF-8");
      return;
    }
    if (token_.flaw == Flaw::control_character && control && code.value != '\t') {
      sink_.report<Kind::unexpected_character>(place, fmt::format("\\x{:02x}", word_[i]))
          .hint("control characters other than a tab cannot stand in a string");
      return;
    }
    if (code.value == '\\') {
      const CodePoint escaped = decode_utf8(word_.substr(i + 1));
      const std::string_view escape = word_.substr(i, 1 + escaped.length);
      if (token_.flaw == Flaw::unknown_escape &&
          std::string_view("\"\\nt").find(escape[1]) == std::string_view::npos) {
        const SourceSpan both{place.file, place.begin, place.end + escaped.length};
        const bool shown = escaped.valid && escaped.value >= 0x20 && escaped.value != 0x7F;
        sink_.report<Kind::unknown_escape>(both, shown ? escape : escape.substr(0, 1))
            .hint("the escapes are `\\\"`, `\\\\`, `\\n` and `\\t`; paths are written with `/`");
        return;
      }
      i += escaped.length;
    }
    i += code.length;
  }
}

}  // namespace

void report_flaw(const Token& token, FileId file, std::string_view text, DiagnosticSink& sink) {
  FlawReporter(token, file, text, sink).report();
}

}  // namespace alhazen::parser

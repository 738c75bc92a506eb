#include "parser/lex/header.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>
#include <string>

namespace alhazen::parser {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kMagic = "#scn";
constexpr int kVersion = 1;

struct Format {
  std::string_view beginning, name;
};

constexpr Format kFormats[] = {
    {"RSRC", "a binary scene of Godot"},    {"RSCC", "a compressed scene of Godot"},
    {"[gd_scene", "a text scene of Godot"}, {"scene.", "a scene of LuxCoreRender"},
    {"film.", "a scene of LuxCoreRender"},  {"\xFF\xFE", "text in UTF-16"},
    {"\xFE\xFF", "text in UTF-16"},         {"\x89PNG", "a PNG picture"},
    {"\xFF\xD8\xFF", "a JPEG picture"},     {"\x76\x2F\x31\x01", "an OpenEXR picture"},
    {"glTF", "a binary glTF scene"},        {"PK\x03\x04", "a zip archive"},
    {"\x1F\x8B", "a gzip archive"},         {"<?xml", "an XML document"},
    {"<scene", "an XML document"},          {"{", "a JSON document"},
};

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// `#SCN 1`, `# scn 1`, `  #scn`: a header was meant.
bool resembles_header(std::string_view line) {
  std::string letters;
  for (const char c : line) {
    if (!is_blank(c)) letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return letters.starts_with(kMagic);
}

// Whether `#scn` begins a later line.
std::size_t find_misplaced(std::string_view text) {
  for (std::size_t at = text.find(kMagic); at != std::string_view::npos;
       at = text.find(kMagic, at + 1)) {
    std::size_t line_begin = at;
    while (line_begin > 0 && is_blank(text[line_begin - 1]))
      --line_begin;
    if (line_begin == 0 || text[line_begin - 1] == '\n') return at;
  }
  return std::string_view::npos;
}

// The end of `#scn`, blanks, digits at the beginning of `line`, or 0 if it is not that, or not
// followed by the end of the line or a comment.
std::size_t match_header(std::string_view line) {
  if (!line.starts_with(kMagic)) return 0;
  std::size_t at = kMagic.size();
  while (at < line.size() && is_blank(line[at]))
    ++at;
  if (at == kMagic.size()) return 0;
  const std::size_t digits = at;
  while (at < line.size() && is_digit(line[at]))
    ++at;
  if (at == digits) return 0;
  const std::size_t end = at;
  while (at < line.size() && is_blank(line[at]))
    ++at;
  const std::string_view rest = line.substr(at);
  return rest.empty() || rest.starts_with("//") || rest.starts_with("/*") ? end : 0;
}

}  // namespace

Header read_header(FileId file, std::string_view text) {
  const auto span = [&](std::size_t begin, std::size_t end) {
    return SourceSpan{file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  };
  const std::size_t begin = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  const std::string_view body = text.substr(begin);
  if (std::all_of(body.begin(), body.end(), [](char c) { return is_blank(c) || c == '\n'; })) {
    return {HeaderState::empty, span(0, 0), "", kVersion};
  }
  for (const Format& format : kFormats) {
    if (body.starts_with(format.beginning)) {
      return {HeaderState::foreign, span(begin, begin + format.beginning.size()), format.name,
              kVersion};
    }
  }
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
    return {HeaderState::binary, span(nul, nul + 1), "", kVersion};
  }

  const std::string_view line = body.substr(0, body.find('\n'));
  const std::size_t line_end = begin + line.find_last_not_of(" \t\r") + 1;
  if (const std::size_t end = match_header(line); end > 0) {
    int version = 0;
    const char* const digits = line.data() + line.find_first_of("0123456789");
    std::from_chars(digits, line.data() + end, version);  // a version that overflows stays 0
    const bool ours = version == kVersion;
    return {ours ? HeaderState::good : HeaderState::unsupported, span(begin, begin + end), "",
            version};
  }
  if (resembles_header(line)) {
    const std::size_t first = begin + line.find_first_not_of(" \t\r");
    return {HeaderState::malformed, span(first, line_end), "", kVersion};
  }
  if (const std::size_t at = find_misplaced(text); at != std::string_view::npos) {
    return {HeaderState::misplaced, span(at, at + kMagic.size()), "", kVersion};
  }
  return {HeaderState::missing, span(begin, begin), "", kVersion};
}

void report(const Header& header, std::string_view text, DiagnosticSink& sink) {
  using Kind = DiagnosticKind;
  switch (header.state) {
    case HeaderState::good:
      break;
    case HeaderState::empty:
      sink.report<Kind::empty_file>(header.span).hint("a scene begins with the line `#scn 1`");
      break;
    case HeaderState::binary:
      sink.report<Kind::binary_file>(header.span).hint("a scene is a text in UTF-8");
      break;
    case HeaderState::foreign:
      sink.report<Kind::foreign_file>(header.span, header.format)
          .hint("a scene of Alhazen is a text in UTF-8 and begins with the line `#scn 1`");
      break;
    case HeaderState::missing:
      sink.report<Kind::missing_header>(header.span)
          .hint(
              "put `#scn 1` on a line of its own at the top: it names the language and its "
              "version");
      break;
    case HeaderState::misplaced:
      sink.report<Kind::misplaced_header>(header.span)
          .hint("move it to the top: nothing stands before it, not even a comment");
      break;
    case HeaderState::malformed:
      sink.report<Kind::malformed_header>(header.span)
          .hint("write `#scn 1` from the first column, with nothing but a comment after it");
      break;
    case HeaderState::unsupported:
      sink.report<Kind::unsupported_version>(
              header.span, text.substr(header.span.begin, header.span.end - header.span.begin))
          .hint("this build reads version 1 only");
      break;
  }
}

}  // namespace alhazen::parser

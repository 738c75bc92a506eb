#include "parser/lex/dump.h"

#include <fmt/format.h>

#include "parser/lex/header.h"
#include "parser/lex/lexer.h"

namespace alhazen::parser {

std::string dump_tokens(FileId file, const SourceManager& sources) {
  const std::string_view text = sources.text(file);
  const Header header = read_header(file, text);
  std::string out;
  std::uint32_t begin = 0;
  if (header.state == HeaderState::good) {
    begin = header.span.end;
    out += fmt::format("{:>4}:{:<3} {:<16} {}\n", 1, 1, "header", sources.text(header.span));
  }
  Lexer lexer(text, begin);
  std::uint32_t line = 1;
  std::uint32_t line_begin = 0;
  std::uint32_t scanned = 0;
  for (;;) {
    const Token token = lexer.next();
    for (; scanned < token.begin; ++scanned) {
      if (text[scanned] == '\n') ++line, line_begin = scanned + 1;
    }
    const std::string_view word = text.substr(token.begin, token.end - token.begin);
    out += fmt::format("{:>4}:{:<3} {:<16} {}", line, token.begin - line_begin + 1,
                       name_of(token.kind), word);
    if (token.flaw != Flaw::none) out += fmt::format("  [{}]", name_of(token.flaw));
    out += '\n';
    if (token.kind == TokenKind::end) return out;
  }
}

}  // namespace alhazen::parser

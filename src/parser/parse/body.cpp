// parser/parse: bodies, and what their indentation tells about a missing brace.
#include "parser/parse/parser.h"

namespace alhazen::parser {

// body        = "{" { item } "}" ;
ast::Body Parser::parse_body() {
  ast::Body body;
  Nesting nesting(*this);
  if (at(TokenKind::left_brace) && !nesting.allowed()) return body;
  const Token opener = peek();
  if (!expect(TokenKind::left_brace)) return body;
  const std::uint32_t indentation = tokens_.indentation(opener);
  const auto interior_outside = std::exchange(interior_, {});

  std::vector<ast::ItemPtr> items;
  for (;;) {
    watch_indentation(span(opener), indentation);
    if (at(TokenKind::right_brace) || at(TokenKind::end)) break;
    items.push_back(parse_item());
  }
  body.items = list(items);
  body.dangling = list(tokens_.take_comments());
  interior_ = interior_outside;
  if (!take(TokenKind::right_brace)) fail_unclosed_body(span(opener));
  body.span = span_from(opener.begin);
  return body;
}

// An item no further to the right than the line that opened its body, or a closing brace to the
// left of that line: the brace that should have closed the body is probably missing.
void Parser::watch_indentation(SourceSpan opener, std::uint32_t opener_indentation) {
  const Token& token = peek();
  if (suspect_ || !token.newline_before || token.kind == TokenKind::end) return;
  const std::uint32_t indentation = tokens_.indentation(token);
  const bool outdented = token.kind == TokenKind::right_brace ? indentation < opener_indentation
                                                              : indentation <= opener_indentation;
  if (outdented) suspect_ = Suspect{opener, span(token)};
}

}  // namespace alhazen::parser

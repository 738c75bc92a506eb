// parser/parse: loops and conditions.
#include "parser/parse/parser.h"

namespace alhazen::parser {

// for         = "for" NAME "in" header_expression body ;
ast::For Parser::parse_for() {
  next();
  ast::For loop;
  if (at(TokenKind::left_paren)) {
    fail_expected("the name of the variable").hint("a loop is written `for i in 0 .. 10 { ... }`");
  }
  if (const auto name = expect_name("the name of the variable")) loop.variable = *name;
  if (!at(TokenKind::kw_in)) {
    fail_expected("`in`").hint("a loop is written `for i in 0 .. 10 { ... }`");
  }
  take(TokenKind::kw_in);
  loop.sequence = parse_header_expression();
  loop.body = parse_body();
  return loop;
}

// if          = "if" header_expression body [ "else" ( if | body ) ] ;
ast::If Parser::parse_if() {
  next();
  ast::If branch;
  branch.condition = parse_header_expression();
  if (at(TokenKind::kw_then)) {
    fail_expected("`{`").hint(
        "`if c then a else b` is a value; items are chosen by `if c { ... } else { ... }`");
  }
  branch.then_body = parse_body();
  if (panic_) return branch;

  if (at(TokenKind::name) &&
      (text(peek()) == "elif" || text(peek()) == "elsif" || text(peek()) == "elseif")) {
    report<DiagnosticKind::foreign_word>(span(peek()), text(peek())).hint("write `else if`");
  } else if (!take(TokenKind::kw_else)) {
    return branch;
  } else if (!at(TokenKind::kw_if)) {
    branch.else_branch = parse_body();
    return branch;
  }
  Nesting nesting(*this);
  if (!nesting.allowed()) return branch;
  ast::Item item;
  const std::uint32_t begin = peek().begin;
  item.node = parse_if();
  item.span = span_from(begin);
  branch.else_branch = arena_.add(item);
  return branch;
}

}  // namespace alhazen::parser

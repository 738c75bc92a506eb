// parser/parse: whole expressions.
#include <algorithm>

#include "parser/parse/parser.h"

namespace alhazen::parser {

ast::ExprPtr Parser::make(std::uint32_t begin, const Node& node, int below) {
  const auto* made = arena_.add(ast::Expr{span_from(begin), node, below + 1});
  tallest_ = std::max(tallest_, made->height);
  if (made->height <= limits_.max_height) return made;
  fail<DiagnosticKind::expression_too_long>(made->span, limits_.max_height)
      .hint("name parts of it with `let`, or add up in a loop");
  return error_expression();
}

ast::ExprPtr Parser::error_expression(const Token& before) {
  return arena_.add(ast::Expr{{file_, before.begin, before.begin}, ast::ErrorExpr{}, 1});
}

bool Parser::at_item_keyword() {
  switch (peek().kind) {
    case TokenKind::kw_let:
    case TokenKind::kw_param:
    case TokenKind::kw_fn:
    case TokenKind::kw_for:
    case TokenKind::kw_if:
    case TokenKind::kw_include:
    case TokenKind::kw_assert:
    case TokenKind::kw_print:
    case TokenKind::kw_return:
      return true;
    default:
      return false;
  }
}

bool Parser::at_expression() {
  switch (peek().kind) {
    case TokenKind::number:
    case TokenKind::angle:
    case TokenKind::string:
    case TokenKind::hex_color:
    case TokenKind::name:
    case TokenKind::kw_true:
    case TokenKind::kw_false:
    case TokenKind::kw_not:
    case TokenKind::kw_if:
    case TokenKind::minus:
    case TokenKind::less:
    case TokenKind::left_bracket:
    case TokenKind::left_paren:
      return true;
    default:
      return false;
  }
}

// header_expression = expression ;
ast::ExprPtr Parser::parse_header_expression() {
  const Scoped objects(objects_allowed_, false);
  return parse_expression();
}

// expression  = conditional | range ;
ast::ExprPtr Parser::parse_expression() {
  Nesting nesting(*this);
  if (!nesting.allowed()) return error_expression();
  return at(TokenKind::kw_if) ? parse_conditional() : parse_range();
}

// conditional = "if" header_expression "then" expression "else" expression ;
ast::ExprPtr Parser::parse_conditional() {
  const Token begin = next();
  ast::Conditional conditional;
  conditional.condition = parse_header_expression();
  if (!take(TokenKind::kw_then)) {
    fail_expected("`then`").hint("a choice between two values is written `if c then a else b`");
  }
  conditional.then_value = parse_expression();
  if (!take(TokenKind::kw_else)) {
    fail_expected("`else`").hint("a choice between two values is written `if c then a else b`");
  }
  conditional.else_value = parse_expression();
  const int below = std::max({conditional.condition->height, conditional.then_value->height,
                              conditional.else_value->height});
  return make(begin.begin, conditional, below);
}

// range       = or [ ( ".." | "..=" ) or [ "by" or ] ] ;
ast::ExprPtr Parser::parse_range() {
  const std::uint32_t begin = peek().begin;
  ast::ExprPtr first = parse_or();
  if (!at(TokenKind::range) && !at(TokenKind::range_inclusive)) return first;
  const bool inclusive = next().kind == TokenKind::range_inclusive;
  ast::Range range{first, parse_or(), inclusive, nullptr};
  int below = std::max(range.first->height, range.last->height);
  if (take(TokenKind::kw_by)) {
    range.step = parse_or();
    below = std::max(below, range.step->height);
  }
  return make(begin, range, below);
}

}  // namespace alhazen::parser

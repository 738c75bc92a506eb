// parser/parse: operators, from the loosest to the tightest.
#include <algorithm>

#include "parser/parse/parser.h"

namespace alhazen::parser {

using ast::BinaryOperator;
using ast::UnaryOperator;

ast::ExprPtr Parser::binary(BinaryOperator op, const Token& token, ast::ExprPtr left,
                            ast::ExprPtr right) {
  const std::uint32_t begin = left->span.begin;
  const int below = std::max(left->height, right->height);
  return make(begin, ast::Binary{op, span(token), left, right}, below);
}

ast::ExprPtr Parser::parse_chain(ast::ExprPtr (Parser::*operand)(),
                                 std::initializer_list<Operator> ops) {
  ast::ExprPtr left = (this->*operand)();
  for (;;) {
    const auto* found =
        std::find_if(ops.begin(), ops.end(), [&](const Operator& o) { return at(o.token); });
    if (found == ops.end()) return left;
    const Token token = next();
    left = binary(found->op, token, left, (this->*operand)());
  }
}

// or          = and { "or" and } ;
ast::ExprPtr Parser::parse_or() {
  return parse_chain(&Parser::parse_and, {{TokenKind::kw_or, BinaryOperator::logical_or}});
}

// and         = not { "and" not } ;
ast::ExprPtr Parser::parse_and() {
  return parse_chain(&Parser::parse_not, {{TokenKind::kw_and, BinaryOperator::logical_and}});
}

// not         = "not" not | comparison ;
ast::ExprPtr Parser::parse_not() {
  if (!at(TokenKind::kw_not)) return parse_comparison();
  const Token token = next();
  Nesting nesting(*this);
  if (!nesting.allowed()) return error_expression();
  ast::ExprPtr operand = parse_not();
  const int below = operand->height;
  return make(token.begin, ast::Unary{UnaryOperator::logical_not, span(token), operand}, below);
}

// comparison  = sum [ ( "<" | "<=" | ">" | ">=" | "==" | "!=" ) sum ] ;
ast::ExprPtr Parser::parse_comparison() {
  static constexpr Operator kComparisons[] = {
      {TokenKind::less, BinaryOperator::less},
      {TokenKind::less_equal, BinaryOperator::less_equal},
      {TokenKind::greater, BinaryOperator::greater},
      {TokenKind::greater_equal, BinaryOperator::greater_equal},
      {TokenKind::equal_equal, BinaryOperator::equal},
      {TokenKind::not_equal, BinaryOperator::not_equal},
  };
  const auto comparison = [&] {
    return std::find_if(std::begin(kComparisons), std::end(kComparisons),
                        [&](const Operator& o) { return at(o.token); });
  };
  ast::ExprPtr left = parse_sum();
  const auto* found = comparison();
  if (found == std::end(kComparisons)) return left;
  const Token token = next();
  ast::ExprPtr whole = binary(found->op, token, left, parse_sum());
  if (comparison() != std::end(kComparisons)) {
    fail<DiagnosticKind::chained_comparison>(span(peek()))
        .label(span(token), "the first comparison is here")
        .hint("write `a < b and b < c`");
  }
  return whole;
}

// sum         = product { ( "+" | "-" ) product } ;
ast::ExprPtr Parser::parse_sum() {
  return parse_chain(&Parser::parse_product, {{TokenKind::plus, BinaryOperator::add},
                                              {TokenKind::minus, BinaryOperator::subtract}});
}

// product     = unary { ( "*" | "/" | "%" ) unary } ;
ast::ExprPtr Parser::parse_product() {
  return parse_chain(&Parser::parse_unary, {{TokenKind::star, BinaryOperator::multiply},
                                            {TokenKind::slash, BinaryOperator::divide},
                                            {TokenKind::percent, BinaryOperator::remainder}});
}

// unary       = "-" unary | power ;
ast::ExprPtr Parser::parse_unary() {
  if (!at(TokenKind::minus)) return parse_power();
  const Token token = next();
  Nesting nesting(*this);
  if (!nesting.allowed()) return error_expression();
  ast::ExprPtr operand = parse_unary();
  const int below = operand->height;
  return make(token.begin, ast::Unary{UnaryOperator::negate, span(token), operand}, below);
}

// power       = postfix [ "^" unary ] ;
ast::ExprPtr Parser::parse_power() {
  ast::ExprPtr base = parse_postfix();
  if (!at(TokenKind::caret)) return base;
  const Token token = next();
  Nesting nesting(*this);
  if (!nesting.allowed()) return error_expression();
  return binary(BinaryOperator::power, token, base, parse_unary());
}

}  // namespace alhazen::parser

// parser/parse: the smallest expressions, and those in brackets.
#include <algorithm>

#include "parser/lex/literal.h"
#include "parser/parse/parser.h"

namespace alhazen::parser {

// primary     = NUMBER | ANGLE | STRING | HEX_COLOR | "true" | "false" | vector | list
//             | "(" expression ")" | object | NAME ;
ast::ExprPtr Parser::parse_primary() {
  switch (peek().kind) {
    case TokenKind::number:
    case TokenKind::angle:
    case TokenKind::string:
    case TokenKind::hex_color:
    case TokenKind::kw_true:
    case TokenKind::kw_false:
      return parse_literal();
    case TokenKind::less:
      return parse_vector();
    case TokenKind::left_bracket:
      return parse_list();
    case TokenKind::left_paren:
      return parse_parenthesized();
    case TokenKind::name:
      return parse_object_or_name();
    default:
      break;
  }
  Diagnostic& report = fail_expected("an expression");
  if (at(TokenKind::plus)) {
    report.hint("a positive number has no sign");
  } else if (at(TokenKind::kw_not) || at(TokenKind::kw_if)) {
    report.hint("put it in parentheses to use it as an operand");
  } else if (at(TokenKind::equal)) {
    report.hint("values are compared by `==`");
  }
  return error_expression();
}

ast::ExprPtr Parser::parse_literal() {
  const Token token = next();
  const std::string_view word = text(token);
  const auto value = [&]() -> Node {
    if (token.flaw != Flaw::none) return ast::ErrorExpr{};
    switch (token.kind) {
      case TokenKind::number:
        return ast::NumberLiteral{read_number(word).value};
      case TokenKind::angle:
        return ast::AngleLiteral{read_number(word).value,
                                 word.ends_with("deg") ? ast::AngleUnit::deg : ast::AngleUnit::rad};
      case TokenKind::string:
        return ast::StringLiteral{arena_.text(read_string(word))};
      case TokenKind::hex_color: {
        const auto [red, green, blue] = read_hex_color(word);
        return ast::HexColor{red, green, blue};
      }
      default:
        return ast::BoolLiteral{token.kind == TokenKind::kw_true};
    }
  };
  return make(token.begin, value());
}

// vector      = "<" sum "," sum [ "," sum ] ">" ;
ast::ExprPtr Parser::parse_vector() {
  const Token opener = next();
  std::vector<ast::ExprPtr> components;
  components.reserve(3);
  int below = 0;
  {
    const Scoped objects(objects_allowed_, true);
    Nesting nesting(*this);
    if (!nesting.allowed()) return error_expression();
    do {
      components.push_back(parse_sum());
      below = std::max(below, components.back()->height);
    } while (take(TokenKind::comma));
  }
  if (!take(TokenKind::greater)) {
    Diagnostic& report = fail_expected("`,` or `>`").label(span(opener), "the vector begins here");
    if (at(TokenKind::less) || at(TokenKind::less_equal) || at(TokenKind::greater_equal) ||
        at(TokenKind::equal_equal) || at(TokenKind::not_equal) || at(TokenKind::kw_and) ||
        at(TokenKind::kw_or) || at(TokenKind::range)) {
      report.hint("comparisons and ranges in a vector need parentheses");
    }
    return error_expression();
  }
  const std::size_t count = components.size();
  if (count < 2 || count > 3) {
    report<DiagnosticKind::vector_size>(span_from(opener.begin), count)
        .hint("write `<x, y, z>`, or `<u, v>` on a surface");
    return error_expression();
  }
  return make(opener.begin, ast::VectorLiteral{list(components)}, below);
}

// list        = "[" [ expression { "," expression } [ "," ] ] "]" ;
ast::ExprPtr Parser::parse_list() {
  const Token opener = next();
  std::vector<ast::ExprPtr> elements;
  int below = 0;
  const Scoped objects(objects_allowed_, true);
  const Scoped brackets(open_brackets_, open_brackets_ + 1);
  while (!at(TokenKind::right_bracket)) {
    elements.push_back(parse_expression());
    below = std::max(below, elements.back()->height);
    if (!take(TokenKind::comma)) break;
  }
  close(TokenKind::right_bracket, span(opener), "`,` or `]`");
  return make(opener.begin, ast::ListLiteral{list(elements)}, below);
}

ast::ExprPtr Parser::parse_parenthesized() {
  const Token opener = next();
  const Scoped objects(objects_allowed_, true);
  const Scoped brackets(open_brackets_, open_brackets_ + 1);
  ast::ExprPtr inner = parse_expression();
  const int below = inner->height;
  if (at(TokenKind::comma)) {
    fail_expected("`)`").label(span(opener), "opened here").hint("vectors are written `<0, 1, 0>`");
  } else {
    close(TokenKind::right_paren, span(opener), "`)`");
  }
  return make(opener.begin, ast::Parenthesized{inner}, below);
}

// object      = NAME [ call ] body ;
ast::ExprPtr Parser::parse_object_or_name() {
  const Token name = next();
  ast::ExprPtr head = make(name.begin, ast::NameRef{text(name)});
  if (at(TokenKind::left_paren)) head = parse_call(head);
  if (at(TokenKind::left_brace) && objects_allowed_ && !panic_) return parse_block(head);
  return head;
}

ast::ExprPtr Parser::parse_block(ast::ExprPtr head) {
  const std::uint32_t begin = head->span.begin;
  const auto* name = std::get_if<ast::NameRef>(&head->node);
  const Scoped inside(block_, name != nullptr ? name->name : std::string_view());
  const int outside = std::exchange(tallest_, head->height);
  ast::Block block{head, parse_body()};
  const int below = std::exchange(tallest_, outside);
  return make(begin, block, below);
}

}  // namespace alhazen::parser

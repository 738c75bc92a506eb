// parser/parse: items, and those that are one line.
#include "parser/lex/literal.h"
#include "parser/parse/parser.h"

namespace alhazen::parser {

ast::ItemPtr Parser::parse_item() {
  ast::Item item;
  item.leading = list(tokens_.take_comments());
  item.blank_line_before = peek().blank_line_before;
  const std::uint32_t begin = peek().begin;
  const auto interior_outside = std::exchange(interior_, {});
  {
    const Scoped brackets(open_brackets_, 0);
    const Scoped objects(objects_allowed_, true);
    parse_item_node(item);
  }
  if (panic_) synchronize();
  item.span = span_from(begin);
  item.interior = list(std::exchange(interior_, interior_outside));
  item.trailing = list(tokens_.take_trailing_comments());
  return arena_.add(item);
}

// item        = let | param | function | for | if | include | assert | print | return
//             | placement | property ;
void Parser::parse_item_node(ast::Item& item) {
  switch (peek().kind) {
    case TokenKind::kw_let:
      item.node = parse_let();
      break;
    case TokenKind::kw_param:
      item.node = parse_param();
      break;
    case TokenKind::kw_fn:
      item.node = parse_function();
      break;
    case TokenKind::kw_for:
      item.node = parse_for();
      break;
    case TokenKind::kw_if:
      item.node = parse_if();
      break;
    case TokenKind::kw_include:
      item.node = parse_include();
      break;
    case TokenKind::kw_assert:
      item.node = parse_assert();
      break;
    case TokenKind::kw_print:
      item.node = parse_print();
      break;
    case TokenKind::kw_return:
      item.node = parse_return();
      break;
    case TokenKind::name:
      parse_name_item(item);
      break;
    default:
      item.node = ast::ErrorItem{};
      fail_not_an_item();
      break;
  }
}

// let         = "let" NAME "=" expression ;
ast::Let Parser::parse_let() {
  next();
  ast::Let let;
  if (const auto name = expect_name("the name of the value")) let.name = *name;
  named_.push_back(let.name.text);
  expect(TokenKind::equal);
  let.value = parse_expression();
  return let;
}

// param       = "param" NAME "=" expression [ "in" expression ] [ STRING ] ;
ast::Param Parser::parse_param() {
  next();
  ast::Param param;
  if (const auto name = expect_name("the name of the parameter")) param.name = *name;
  named_.push_back(param.name.text);
  expect(TokenKind::equal);
  param.value = parse_expression();
  if (take(TokenKind::kw_in)) param.range = parse_expression();
  if (at(TokenKind::string)) param.text = parse_literal();
  return param;
}

// include     = "include" STRING ;
ast::Include Parser::parse_include() {
  next();
  ast::Include include;
  const Token path = peek();
  if (!expect(TokenKind::string)) return include;
  include.path_span = span(path);
  if (path.flaw == Flaw::none) include.path = arena_.text(read_string(text(path)));
  return include;
}

// assert      = "assert" expression [ "," expression ] ;
ast::Assert Parser::parse_assert() {
  next();
  ast::Assert assertion;
  assertion.condition = parse_expression();
  if (take(TokenKind::comma)) assertion.message = parse_expression();
  return assertion;
}

// print       = "print" expression { "," expression } ;
ast::Print Parser::parse_print() {
  next();
  std::vector<ast::ExprPtr> values;
  do {
    values.push_back(parse_expression());
  } while (take(TokenKind::comma));
  return {list(values)};
}

// return      = "return" expression ;
ast::Return Parser::parse_return() {
  next();
  return {parse_expression()};
}

}  // namespace alhazen::parser

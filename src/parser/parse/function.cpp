// parser/parse: functions.
#include "parser/parse/parser.h"

namespace alhazen::parser {

// function    = "fn" NAME "(" [ parameter { "," parameter } [ "," ] ] ")" ( "=" expression | body )
// ;
ast::Function Parser::parse_function() {
  next();
  ast::Function function;
  if (const auto name = expect_name("the name of the function")) function.name = *name;
  const SourceSpan opener = span(peek());
  if (expect(TokenKind::left_paren)) {
    const Scoped brackets(open_brackets_, open_brackets_ + 1);
    std::vector<ast::Parameter> parameters;
    while (!at(TokenKind::right_paren)) {
      parameters.push_back(parse_parameter());
      if (!take(TokenKind::comma)) break;
    }
    function.parameters = list(parameters);
    close(TokenKind::right_paren, opener, "`,` or `)`");
  }
  if (at(TokenKind::left_brace)) {
    function.body = parse_body();
  } else if (take(TokenKind::equal)) {
    function.body = parse_expression();
  } else {
    fail_expected("`=` and an expression or `{`");
    function.body = error_expression();
  }
  return function;
}

// parameter   = NAME [ "=" expression ] ;
ast::Parameter Parser::parse_parameter() {
  ast::Parameter parameter;
  if (const auto name = expect_name("the name of a parameter")) parameter.name = *name;
  if (at(TokenKind::colon)) {
    report<DiagnosticKind::foreign_spelling>(span(next()), ":")
        .hint("parameters have no types; a default value is written `name = value`");
    parameter.default_value = parse_expression();
  } else if (take(TokenKind::equal)) {
    parameter.default_value = parse_expression();
  }
  return parameter;
}

}  // namespace alhazen::parser

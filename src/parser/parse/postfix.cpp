// parser/parse: what follows a value: members, elements, arguments.
#include <algorithm>
#include <fmt/format.h>

#include "parser/parse/parser.h"

namespace alhazen::parser {

// postfix     = primary { "." NAME | "[" expression "]" | call } ;
ast::ExprPtr Parser::parse_postfix() {
  const std::uint32_t begin = peek().begin;
  ast::ExprPtr whole = parse_primary();
  for (;;) {
    const int height = whole->height;
    if (at(TokenKind::left_paren)) {
      whole = parse_call(whole);
    } else if (take(TokenKind::dot)) {
      const auto member = expect_name("the name of a member");
      if (!member) return whole;
      whole = make(begin, ast::Member{whole, *member}, height);
    } else if (at(TokenKind::left_bracket)) {
      const SourceSpan opener = span(next());
      const Scoped objects(objects_allowed_, true);
      const Scoped brackets(open_brackets_, open_brackets_ + 1);
      ast::ExprPtr index = parse_expression();
      if (!close(TokenKind::right_bracket, opener, "`]`")) return whole;
      const int below = std::max(height, index->height);
      whole = make(begin, ast::Index{whole, index}, below);
    } else {
      return whole;
    }
  }
}

// call        = "(" [ argument { "," argument } [ "," ] ] ")" ;
ast::ExprPtr Parser::parse_call(ast::ExprPtr callee) {
  const std::uint32_t begin = callee->span.begin;
  int below = callee->height;
  ast::Call call;
  call.callee = callee;
  const SourceSpan opener = span(next());
  {
    const Scoped objects(objects_allowed_, true);
    const Scoped brackets(open_brackets_, open_brackets_ + 1);
    std::vector<ast::Argument> arguments;
    while (!at(TokenKind::right_paren)) {
      arguments.push_back(parse_argument());
      below = std::max(below, arguments.back().value->height);
      if (!take(TokenKind::comma)) break;
    }
    call.arguments = list(arguments);
    close(TokenKind::right_paren, opener, "`,` or `)`");
  }
  call.arguments_span = span_from(opener.begin);
  return make(begin, call, below);
}

// argument    = [ NAME ":" ] expression ;
ast::Argument Parser::parse_argument() {
  ast::Argument argument;
  if (at(TokenKind::name) && at(TokenKind::colon, 1)) {
    argument.name = name_of(next());
    next();
  } else if (at(TokenKind::name) && at(TokenKind::equal, 1)) {
    argument.name = name_of(next());
    report<DiagnosticKind::foreign_spelling>(span(next()), "=")
        .hint(fmt::format("a named argument is written `{}: value`", argument.name->text));
  }
  argument.value = parse_expression();
  return argument;
}

}  // namespace alhazen::parser

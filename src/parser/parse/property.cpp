// parser/parse: items that begin with a name.
#include <algorithm>
#include <fmt/format.h>

#include "parser/parse/habits.h"
#include "parser/parse/parser.h"

namespace alhazen::parser {

void Parser::parse_name_item(ast::Item& item) {
  if (take_foreign_word(item)) return;
  const Token name = next();
  if (at(TokenKind::left_paren) && peek().begin == name.end) {
    item.node = parse_placement(name);
    return;
  }
  ast::Property property = parse_property(name);
  after_property(property);
  item.node = property;
}

// placement   = NAME call [ body ] ;
ast::Placement Parser::parse_placement(const Token& name) {
  ast::ExprPtr head = make(name.begin, ast::NameRef{text(name)});
  ast::ExprPtr object = parse_call(head);
  if (at(TokenKind::left_brace) && !panic_) object = parse_block(object);
  return {object};
}

// property    = NAME ( body | expression ) ;
ast::Property Parser::parse_property(const Token& name) {
  ast::Property property{name_of(name), {}};
  const Token after_name = peek();
  if (at(TokenKind::equal) || at(TokenKind::colon)) {
    const Token sign = next();
    if (sign.flaw == Flaw::none) {
      const bool is_change = sign.kind == TokenKind::equal && is_named(text(name));
      report<DiagnosticKind::needless_assignment>(span(sign), text(sign))
          .hint(is_change
                    ? "names cannot change: name the new value with another `let`"
                    : fmt::format("write `{0} ...` for a property, `let {0} = ...` to name a value",
                                  text(name)));
    }
  }
  if (at(TokenKind::left_brace)) {
    const Scoped block(block_, text(name));
    property.value = parse_body();
  } else if (at_expression()) {
    property.value = parse_expression();
  } else if (at(TokenKind::right_brace) || at(TokenKind::end) || at_item_keyword()) {
    // What follows is sound; only this property is not.
    report<DiagnosticKind::missing_value>(span(name), text(name))
        .hint("a property is a name and a value: `radius 2`, `material glass { ior 1.5 }`");
    property.value = error_expression(after_name);
  } else {
    const bool update = at(TokenKind::equal, 1);  // `x += 1`
    Diagnostic& report = fail_expected(fmt::format("the value of `{}`", text(name)));
    if (update) report.hint("values do not change: name the new one with `let`");
    property.value = error_expression(after_name);
  }
  return property;
}

// "(0, 0, 1)" where `first` was 0 and `, 0, 1>` comes next.
std::string Parser::rest_in_parentheses(const ast::Expr& first) {
  constexpr std::size_t kMostTokens = 16;
  Token operand;
  operand.begin = first.span.begin;
  operand.end = first.span.end;
  std::string out = "(" + std::string(text(operand));
  std::size_t ahead = 0;
  for (; !at(TokenKind::greater, ahead); ++ahead) {
    if (ahead == kMostTokens || at(TokenKind::end, ahead)) return "(...)";
    out += text(peek(ahead));
    if (at(TokenKind::comma, ahead)) out += ' ';
  }
  return out + ")";
}

bool Parser::is_named(std::string_view name) const {
  return std::find(named_.begin(), named_.end(), name) != named_.end();
}

// What follows a property and cannot begin an item, where the meaning is plain.
void Parser::after_property(const ast::Property& property) {
  if (panic_) return;
  const auto* value = std::get_if<ast::ExprPtr>(&property.value);
  const auto* reference = value != nullptr ? std::get_if<ast::NameRef>(&(*value)->node) : nullptr;
  if (at(TokenKind::equal) && reference != nullptr) {  // `lte x = 1`, `float x = 1`
    Diagnostic& report = fail_expected("the next item");
    const std::string_view keyword = nearest_keyword(property.name.text);
    report.hint(
        fmt::format("write `{} {} = ...`", keyword.empty() ? "let" : keyword, reference->name));
    return;
  }
  if (!at(TokenKind::comma)) return;
  const auto* comparison = value != nullptr ? std::get_if<ast::Binary>(&(*value)->node) : nullptr;
  if (comparison != nullptr && comparison->op == ast::BinaryOperator::less) {
    // `radius center <0, 1, 0>`: the value of radius is missing; `color rgb <0, 0, 1>`.
    const auto* function = std::get_if<ast::NameRef>(&comparison->left->node);
    const bool is_color = function != nullptr && function->name.starts_with("rgb");
    fail_expected("the next item")
        .hint(is_color ? fmt::format("write `rgb{}`", rest_in_parentheses(*comparison->right))
                       : fmt::format("`<` was read as a comparison: the value of `{}` may be "
                                     "missing before it",
                                     property.name.text));
    return;
  }
  report<DiagnosticKind::needless_separator>(span(next()), ",")
      .hint("remove it: white space alone separates items");
}

// `def f(x)`, `var x = 1`: reported, and read as what is meant.
bool Parser::take_foreign_word(ast::Item& item) {
  const ForeignWord* word = match_foreign_word(text(peek()));
  // With a body, or with a name and a body, it may be the author's own name for an object.
  if (word == nullptr || at(TokenKind::left_brace, 1)) return false;
  const SourceSpan where = span(peek());
  if (word->meaning == TokenKind::skip) {
    fail<DiagnosticKind::foreign_word>(where, word->spelling).hint(std::string(word->hint));
    next();
    item.node = ast::ErrorItem{};
    return true;
  }
  report<DiagnosticKind::foreign_word>(where, word->spelling).hint(std::string(word->hint));
  switch (word->meaning) {
    case TokenKind::kw_fn:
      item.node = parse_function();
      break;
    case TokenKind::kw_include:
      item.node = parse_include();
      break;
    default:
      item.node = parse_let();
      break;
  }
  return true;
}

}  // namespace alhazen::parser

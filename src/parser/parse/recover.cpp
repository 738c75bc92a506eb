// parser/parse: what to say about an error, and where to go on after it.
#include <fmt/format.h>

#include "parser/parse/habits.h"
#include "parser/parse/parser.h"

namespace alhazen::parser {

using Kind = DiagnosticKind;

void Parser::panic() {
  if (panic_) return;
  panic_ = true;
  panic_brackets_ = open_brackets_;
}

void Parser::stop() {
  stopped_ = true;
  tokens_.stop();
}

bool Parser::Nesting::allowed() {
  if (parser_.nesting_ <= parser_.limits_.max_nesting) return true;
  parser_.fail<Kind::nested_too_deeply>(parser_.span(parser_.peek()), parser_.limits_.max_nesting)
      .hint("name parts with `let` or `fn`");
  return false;
}

bool Parser::take(TokenKind kind) {
  if (!at(kind)) return false;
  next();
  return true;
}

bool Parser::expect(TokenKind kind) {
  if (take(kind)) return true;
  fail_expected(describe(kind));
  return false;
}

std::optional<ast::Name> Parser::expect_name(std::string_view what) {
  if (at(TokenKind::name)) return name_of(next());
  const std::string_view word = spelling(peek().kind);
  const bool keyword = !word.empty() && word[0] >= 'a' && word[0] <= 'z';
  if (!keyword || peek().newline_before) {
    fail_expected(what);
    return std::nullopt;
  }
  report<Kind::expected>(span(peek()), what, found())
      .hint(fmt::format("`{}` is a keyword; choose another name", word));
  return name_of(next());
}

std::string Parser::found() {
  const Token& token = peek();
  switch (token.kind) {
    case TokenKind::name:
      return fmt::format("the name `{}`", text(token));
    case TokenKind::number:
    case TokenKind::angle:
    case TokenKind::hex_color:
      return fmt::format("`{}`", text(token));
    default:
      return std::string(describe(token.kind));
  }
}

Diagnostic& Parser::fail_expected(std::string_view what) {
  Diagnostic& report = fail<Kind::expected>(span(peek()), what, found());
  const bool after_operand = what == "`{`" || what == "`)`" || what == "`then`";
  if (at(TokenKind::equal) && after_operand) report.hint("values are compared by `==`");
  return report;
}

bool Parser::close(TokenKind closer, SourceSpan opener, std::string_view what) {
  if (take(closer)) return true;
  fail_expected(what).label(opener, "opened here");
  return false;
}

void Parser::fail_unclosed_body(SourceSpan opener) {
  Diagnostic& report = fail<Kind::expected>(span(peek()), "`}`", found());
  if (!suspect_) {
    report.label(opener, "`{` opened here");
    return;
  }
  report.label(suspect_->opener, "did you forget to close the `{` opened here?")
      .label(suspect_->outdented, "the indentation of this line suggests it");
}

void Parser::fail_not_an_item() {
  const Token wrong = peek();
  if (wrong.kind == TokenKind::right_brace) {
    report<Kind::stray_closer>(span(next()), "}")
        .hint("remove it, or look for a `}` too many before");
    return;
  }
  if (wrong.kind == TokenKind::comma) {
    report<Kind::needless_separator>(span(next()), ",")
        .hint("remove it: white space alone separates items");
    return;
  }
  Diagnostic& report = fail_expected("an item");
  switch (wrong.kind) {
    case TokenKind::kw_else:
      report.hint("`else` directly follows the `}` of an `if`");
      break;
    case TokenKind::number:
    case TokenKind::angle:
    case TokenKind::hex_color:
    case TokenKind::string:
    case TokenKind::less:
    case TokenKind::left_bracket:
    case TokenKind::left_paren:
      if (const std::string_view example = named_values_example(block_); !example.empty()) {
        report.hint(fmt::format("values have names here: `{}`", example));
      } else {
        report.hint("a property has one value, after its name");
      }
      break;
    case TokenKind::left_brace:
      report.hint("a body follows a name: `sphere { ... }`");
      break;
    case TokenKind::less_equal:
    case TokenKind::greater_equal:
    case TokenKind::greater:
    case TokenKind::equal_equal:
    case TokenKind::not_equal:
      report.hint("comparisons do not chain: write `a < b and b < c`");
      break;
    default:
      report.hint(
          "items are `let`, `param`, `fn`, `for`, `if`, `include`, a property like `radius 2`");
      break;
  }
  if (wrong.kind != TokenKind::left_brace) next();  // a body is skipped as a whole
}

void Parser::skip_braces() {
  int depth = 0;
  do {
    if (at(TokenKind::left_brace)) ++depth;
    if (at(TokenKind::right_brace)) --depth;
    next();
  } while (depth > 0 && !at(TokenKind::end));
}

// Stops before `}`, before a keyword that can only begin an item, and before a name or `if` that
// begins a line outside of the brackets that were open at the error. Inside of them a name with a
// body still begins an item: the closing bracket is what is missing.
void Parser::synchronize() {
  int brackets = panic_brackets_;
  while (!at(TokenKind::end) && !at(TokenKind::right_brace)) {
    const TokenKind kind = peek().kind;
    const bool line_begins = peek().newline_before;
    if (at_item_keyword() && (kind != TokenKind::kw_if || line_begins)) break;
    if (kind == TokenKind::name && line_begins && (brackets == 0 || at(TokenKind::left_brace, 1))) {
      break;
    }
    if (kind == TokenKind::left_brace) {
      skip_braces();
      continue;
    }
    if (kind == TokenKind::left_paren || kind == TokenKind::left_bracket) ++brackets;
    if (kind == TokenKind::right_paren || kind == TokenKind::right_bracket) {
      brackets = brackets > 0 ? brackets - 1 : 0;
    }
    next();
  }
  panic_ = false;
}

}  // namespace alhazen::parser

// parser/parse: the recursive-descent parser. One member function per production of
// grammar/scn.ebnf, one file per family of them; the production stands above the function that
// parses it.
//
// Errors: the first one of an item puts the parser into panic, in which nothing more is reported;
// the item's end resynchronises. Functions that fail return error nodes and need not consume
// anything: an item always consumes its first token, so the parser always moves on.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/diag/diagnostic.h"
#include "parser/ast/ast.h"
#include "parser/parse/parse.h"
#include "parser/parse/token_stream.h"

namespace alhazen::parser {

class Parser {
 public:
  Parser(FileId file, std::string_view text, std::uint32_t begin, DiagnosticSink& sink,
         const ParseLimits& limits, ast::Arena& arena);

  void parse_scene(ast::File& file);
  ast::ExprPtr parse_whole_expression();

 private:
  // ---- items: item.cpp, function.cpp, control.cpp, property.cpp, body.cpp -----------------------
  ast::ItemPtr parse_item();
  void parse_item_node(ast::Item& item);
  void fail_not_an_item();
  ast::Let parse_let();
  ast::Param parse_param();
  ast::Function parse_function();
  ast::Parameter parse_parameter();
  ast::For parse_for();
  ast::If parse_if();
  ast::Include parse_include();
  ast::Assert parse_assert();
  ast::Print parse_print();
  ast::Return parse_return();
  void parse_name_item(ast::Item& item);
  ast::Placement parse_placement(const Token& name);
  ast::Property parse_property(const Token& name);
  bool take_foreign_word(ast::Item& item);
  void after_property(const ast::Property& property);
  std::string rest_in_parentheses(const ast::Expr& first);
  ast::Body parse_body();

  // ---- expressions: expression.cpp, operators.cpp, postfix.cpp, primary.cpp ---------------------
  ast::ExprPtr parse_header_expression();
  ast::ExprPtr parse_expression();
  ast::ExprPtr parse_conditional();
  ast::ExprPtr parse_range();
  ast::ExprPtr parse_or();
  ast::ExprPtr parse_and();
  ast::ExprPtr parse_not();
  ast::ExprPtr parse_comparison();
  ast::ExprPtr parse_sum();
  ast::ExprPtr parse_product();
  ast::ExprPtr parse_unary();
  ast::ExprPtr parse_power();
  ast::ExprPtr parse_postfix();
  ast::ExprPtr parse_call(ast::ExprPtr callee);
  ast::Argument parse_argument();
  ast::ExprPtr parse_primary();
  ast::ExprPtr parse_literal();
  ast::ExprPtr parse_vector();
  ast::ExprPtr parse_list();
  ast::ExprPtr parse_parenthesized();
  ast::ExprPtr parse_object_or_name();
  ast::ExprPtr parse_block(ast::ExprPtr head);

  struct Operator {
    TokenKind token;
    ast::BinaryOperator op;
  };
  // operand { operator operand }, to the left.
  ast::ExprPtr parse_chain(ast::ExprPtr (Parser::*operand)(), std::initializer_list<Operator> ops);
  ast::ExprPtr binary(ast::BinaryOperator op, const Token& token, ast::ExprPtr left,
                      ast::ExprPtr right);

  using Node = decltype(ast::Expr::node);
  // An expression from byte `begin` to the token consumed last. `below` is the height of its
  // highest part; beyond the limit the tree is dropped, reported, and an ErrorExpr stands for it.
  ast::ExprPtr make(std::uint32_t begin, const Node& node, int below = 0);
  // In place of what is missing before a token, by default the next.
  ast::ExprPtr error_expression() { return error_expression(peek()); }
  ast::ExprPtr error_expression(const Token& before);

  // ---- tokens -----------------------------------------------------------------------------------
  const Token& peek(std::size_t ahead = 0) { return tokens_.peek(ahead); }
  bool at(TokenKind kind, std::size_t ahead = 0) { return peek(ahead).kind == kind; }
  bool at_item_keyword();
  bool at_expression();
  Token next() { return tokens_.next(interior_); }
  bool take(TokenKind kind);
  std::string_view text(const Token& token) const { return tokens_.text(token); }
  SourceSpan span(const Token& token) const { return tokens_.span(token); }
  SourceSpan span_from(std::uint32_t begin) const { return {file_, begin, tokens_.last_end()}; }
  ast::Name name_of(const Token& token) const { return {text(token), span(token)}; }
  // In the tree, as many as have come together.
  template <class Element>
  ast::List<Element> list(const std::vector<Element>& elements) {
    return arena_.list(std::span(elements));
  }

  // ---- errors: recover.cpp ----------------------------------------------------------------------
  // Reports unless in panic, and panics.
  template <DiagnosticKind kind, class... Args>
  Diagnostic& fail(SourceSpan where, Args&&... args) {
    Diagnostic& reported = report<kind>(where, std::forward<Args>(args)...);
    panic();
    return reported;
  }
  // Reports unless in panic, and goes on: for mistakes whose meaning is clear. After a limit, or
  // when the sink takes no more, nothing is left to go on with.
  template <DiagnosticKind kind, class... Args>
  Diagnostic& report(SourceSpan where, Args&&... args) {
    if (panic_ || stopped_) return unreported_ = {};
    if (sink_.full()) sink_.note_truncated();
    const bool enough = sink_.full() || info(kind).code == ErrorCode::limit;
    Diagnostic& reported = sink_.report<kind>(where, std::forward<Args>(args)...);
    if (enough) stop();
    return reported;
  }
  void panic();
  void stop();
  // "expected `what`, found ...", with the hints that what was found suggests.
  Diagnostic& fail_expected(std::string_view what);
  // What the next token is, for messages: "`}`", "the name `foo`".
  std::string found();
  bool expect(TokenKind kind);
  std::optional<ast::Name> expect_name(std::string_view what);
  // The token that closes what `opener` opened.
  bool close(TokenKind closer, SourceSpan opener, std::string_view what);
  void fail_unclosed_body(SourceSpan opener);
  // After an error: to where the next item or the end of the body is.
  void synchronize();
  void skip_braces();

  // Counts one level of nesting while it lives.
  class Nesting {
   public:
    explicit Nesting(Parser& parser) : parser_(parser) { ++parser_.nesting_; }
    ~Nesting() { --parser_.nesting_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;
    // False beyond the limit, which is reported: the caller returns an error node.
    bool allowed();

   private:
    Parser& parser_;
  };

  // Sets a variable while it lives.
  template <class T>
  class Scoped {
   public:
    Scoped(T& variable, T value) : variable_(variable), saved_(std::exchange(variable, value)) {}
    ~Scoped() { variable_ = std::move(saved_); }
    Scoped(const Scoped&) = delete;
    Scoped& operator=(const Scoped&) = delete;

   private:
    T& variable_;
    T saved_;
  };

  // A body whose items or closing brace are indented as if it had ended before.
  struct Suspect {
    SourceSpan opener;
    SourceSpan outdented;
  };
  void watch_indentation(SourceSpan opener, std::uint32_t opener_indentation);

  // Whether a `let` or a `param` before has this name.
  bool is_named(std::string_view name) const;

  FileId file_;
  DiagnosticSink& sink_;
  ParseLimits limits_;
  ast::Arena& arena_;
  TokenStream tokens_;
  std::vector<ast::Comment> interior_;  // of the item that is being parsed
  Diagnostic unreported_;
  std::optional<Suspect> suspect_;
  std::string_view block_;               // name of the block whose body is being parsed, "" in none
  std::vector<std::string_view> named_;  // by `let` and `param`, for hints
  int nesting_ = 0;
  int tallest_ = 0;              // height of the highest expression in the body being parsed
  int open_brackets_ = 0;        // in the item being parsed
  int panic_brackets_ = 0;       // how many were open at the error
  bool objects_allowed_ = true;  // not in a header_expression
  bool panic_ = false;
  bool stopped_ = false;
};

}  // namespace alhazen::parser

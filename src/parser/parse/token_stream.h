// parser/parse: the tokens as the parser sees them: without comments, which wait beside the token
// they precede, and without flaws, which are reported when they come into sight.
#pragma once

#include <string_view>
#include <vector>

#include "core/diag/diagnostic.h"
#include "parser/ast/ast.h"
#include "parser/lex/lexer.h"

namespace alhazen::parser {

class TokenStream {
 public:
  TokenStream(FileId file, std::string_view text, std::uint32_t begin, DiagnosticSink& sink);

  const Token& peek(std::size_t ahead = 0) {
    if (ahead >= ahead_.size()) fetch(ahead + 1);
    return ahead_[ahead].token;
  }
  // Consumes the token; the comments before it join `comments`.
  Token next(std::vector<ast::Comment>& comments);

  // Of the comments before the next token: all; those that begin on the line where the token or
  // comment before them ended.
  std::vector<ast::Comment> take_comments();
  std::vector<ast::Comment> take_trailing_comments();

  // From now on there is only the end of the file.
  void stop();

  SourceSpan span(const Token& token) const { return {file_, token.begin, token.end}; }
  std::string_view text(const Token& token) const {
    return text_.substr(token.begin, token.end - token.begin);
  }
  // Of the token consumed last.
  std::uint32_t last_end() const { return last_end_; }
  // Bytes of white space between the beginning of the line and the token, if nothing else is there;
  // otherwise of the line's first token that was consumed.
  std::uint32_t indentation(const Token& token) const;

 private:
  struct Pending {
    ast::Comment comment;
    bool newline_before;
  };
  struct Ahead {
    Token token;
    std::vector<Pending> comments;
  };
  // Until so many tokens are in sight.
  void fetch(std::size_t count);
  Ahead read_one();

  FileId file_;
  std::string_view text_;
  Lexer lexer_;
  DiagnosticSink& sink_;
  std::vector<Ahead> ahead_;  // one or two; more only where a message is put together
  std::uint32_t last_end_;
  std::uint32_t line_indentation_ = 0;
  bool stopped_ = false;
};

}  // namespace alhazen::parser

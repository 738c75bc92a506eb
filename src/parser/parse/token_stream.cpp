#include "parser/parse/token_stream.h"

#include <algorithm>

#include "parser/lex/report.h"

namespace alhazen::parser {

TokenStream::TokenStream(FileId file, std::string_view text, std::uint32_t begin,
                         DiagnosticSink& sink)
    : file_(file), text_(text), lexer_(text, begin), sink_(sink), last_end_(begin) {}

void TokenStream::fetch(std::size_t count) {
  while (ahead_.size() < count)
    ahead_.push_back(read_one());
}

TokenStream::Ahead TokenStream::read_one() {
  Ahead ahead;
  bool newline_skipped = false;
  for (;;) {
    ahead.token = stopped_ ? Token{} : lexer_.next();
    Token& token = ahead.token;
    if (stopped_) {
      token.begin = token.end = static_cast<std::uint32_t>(text_.size());
      break;
    }
    if (token.flaw != Flaw::none) {
      // One more than the sink takes tells it that some are missing; more of them help nobody.
      const bool enough = sink_.full();
      report_flaw(token, file_, text_, sink_);
      if (enough) {
        sink_.note_truncated();
        stop();
      }
    }
    if (token.kind == TokenKind::comment) {
      ahead.comments.push_back(
          {{text(token), span(token), token.blank_line_before}, token.newline_before});
    } else if (token.kind != TokenKind::skip) {
      break;
    }
    newline_skipped = newline_skipped || token.newline_before;
  }
  ahead.token.newline_before = ahead.token.newline_before || newline_skipped;
  return ahead;
}

void TokenStream::stop() {
  stopped_ = true;
  ahead_.clear();
}

Token TokenStream::next(std::vector<ast::Comment>& comments) {
  peek();
  for (Pending& pending : ahead_.front().comments)
    comments.push_back(pending.comment);
  const Token token = ahead_.front().token;
  if (token.newline_before) line_indentation_ = indentation(token);
  last_end_ = token.end;
  if (token.kind != TokenKind::end) ahead_.erase(ahead_.begin());
  return token;
}

std::vector<ast::Comment> TokenStream::take_comments() {
  peek();
  std::vector<ast::Comment> taken;
  for (Pending& pending : ahead_.front().comments)
    taken.push_back(pending.comment);
  ahead_.front().comments.clear();
  return taken;
}

std::vector<ast::Comment> TokenStream::take_trailing_comments() {
  peek();
  std::vector<Pending>& pending = ahead_.front().comments;
  const auto end = std::find_if(pending.begin(), pending.end(),
                                [](const Pending& p) { return p.newline_before; });
  std::vector<ast::Comment> taken;
  for (auto it = pending.begin(); it != end; ++it)
    taken.push_back(it->comment);
  pending.erase(pending.begin(), end);
  return taken;
}

std::uint32_t TokenStream::indentation(const Token& token) const {
  std::uint32_t begin = token.begin;
  while (begin > 0 && (text_[begin - 1] == ' ' || text_[begin - 1] == '\t'))
    --begin;
  const bool first_on_line = begin == 0 || text_[begin - 1] == '\n';
  return first_on_line ? token.begin - begin : line_indentation_;
}

}  // namespace alhazen::parser

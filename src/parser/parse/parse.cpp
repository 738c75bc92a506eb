// parser/parse: the entry, and the production of a whole file.
#include "parser/parse/parse.h"

#include "parser/lex/header.h"
#include "parser/parse/parser.h"

namespace alhazen::parser {

ast::File parse(FileId file, const SourceManager& sources, DiagnosticSink& sink,
                const ParseLimits& limits) {
  ast::File tree;
  tree.id = file;
  const std::string_view text = sources.text(file);
  const Header header = read_header(file, text);
  report(header, text, sink);
  tree.header = header.span;
  tree.version = header.version;
  if (!header.readable()) return tree;

  // A wrong header line is passed over; text without one is read from its beginning.
  const bool has_line = header.state == HeaderState::good || header.state == HeaderState::malformed;
  Parser parser(file, text, has_line ? header.span.end : 0, sink, limits, tree.arena);
  parser.parse_scene(tree);
  return tree;
}

ast::WholeExpr parse_expression(FileId file, std::uint32_t begin, const SourceManager& sources,
                                DiagnosticSink& sink, const ParseLimits& limits) {
  ast::WholeExpr whole;
  Parser parser(file, sources.text(file), begin, sink, limits, whole.arena);
  whole.root = parser.parse_whole_expression();
  return whole;
}

Parser::Parser(FileId file, std::string_view text, std::uint32_t begin, DiagnosticSink& sink,
               const ParseLimits& limits, ast::Arena& arena)
    : file_(file), sink_(sink), limits_(limits), arena_(arena), tokens_(file, text, begin, sink) {}

// scene       = HEADER { item } END ;
void Parser::parse_scene(ast::File& file) {
  file.header_trailing = list(tokens_.take_trailing_comments());
  std::vector<ast::ItemPtr> items;
  while (!at(TokenKind::end))
    items.push_back(parse_item());
  file.items = list(items);
  file.dangling = list(tokens_.take_comments());
}

ast::ExprPtr Parser::parse_whole_expression() {
  ast::ExprPtr expression = parse_expression();
  return panic_ || !at(TokenKind::end) ? nullptr : expression;
}

}  // namespace alhazen::parser

// parser/print: from the tree to a document.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/diag/source.h"
#include "parser/ast/ast.h"
#include "parser/print/doc.h"

namespace alhazen::parser {

class Printer {
 public:
  Printer(const SourceManager& sources, DocBuilder& docs) : sources_(sources), docs_(docs) {}

  Doc file(const ast::File& file);

 private:
  // ---- print_item.cpp ---------------------------------------------------------------------------
  // Comments, blank lines and items; breaks between them, none before the first or after the last.
  Doc items(ast::List<ast::ItemPtr> items, ast::List<ast::Comment> dangling);
  Doc item(const ast::Item& item);
  // "{", the items, "}": its breaks belong to the group around it.
  Doc body(const ast::Body& body);
  Doc grouped_body(const ast::Body& body);
  Doc trailing(ast::List<ast::Comment> comments);
  Doc comment(const ast::Comment& comment);
  bool must_break(const ast::Body& body) const;
  bool must_break(const ast::If& branch) const;

  Doc node(const ast::Let& let);
  Doc node(const ast::Param& param);
  Doc node(const ast::Function& function);
  Doc node(const ast::For& loop);
  Doc node(const ast::If& branch);
  Doc node(const ast::Include& include);
  Doc node(const ast::Assert& assertion);
  Doc node(const ast::Print& print);
  Doc node(const ast::Return& statement);
  Doc node(const ast::Placement& placement);
  Doc node(const ast::Property& property);
  Doc node(const ast::ErrorItem&) { return DocBuilder::nothing(); }
  Doc if_chain(const ast::If& branch);

  // ---- print_expression.cpp ---------------------------------------------------------------------
  Doc expression(const ast::Expr& expr);
  Doc expression(ast::ExprPtr expr) { return expression(*expr); }
  Doc separated(ast::List<ast::ExprPtr> list);
  // opener, elements with commas, closer: on one line, or one element a line.
  Doc bracketed(std::string_view opener, const std::vector<Doc>& elements, std::string_view closer,
                bool broken);
  Doc binary(const ast::Binary& binary);
  Doc call(const ast::Call& call);

  // Whether the author broke the line after the byte at `opener`.
  bool broken_after(SourceSpan span) const;
  Doc source(SourceSpan span) { return docs_.text(std::string(sources_.text(span))); }
  Doc text(std::string_view text) { return docs_.text(std::string(text)); }

  const SourceManager& sources_;
  DocBuilder& docs_;
};

}  // namespace alhazen::parser

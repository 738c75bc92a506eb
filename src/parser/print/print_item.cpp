// parser/print: items, their comments and the lines between them.
#include <algorithm>
#include <utility>

#include "parser/print/printer.h"

namespace alhazen::parser {
namespace {

constexpr int kIndentation = 2;

// Whether the item ends in a body, so that a comment inside of it is better moved than left: what
// stays as it is stays so with all of its body.
bool ends_in_body(const ast::Item& item) {
  const auto is_block = [](const ast::ExprPtr& expr) {
    return std::holds_alternative<ast::Block>(expr->node);
  };
  struct Visitor {
    decltype(is_block)& block;
    bool operator()(const ast::Let& let) const { return block(let.value); }
    bool operator()(const ast::Return& statement) const { return block(statement.value); }
    bool operator()(const ast::Placement& placement) const { return block(placement.object); }
    bool operator()(const ast::For&) const { return true; }
    bool operator()(const ast::If&) const { return true; }
    bool operator()(const ast::Function& function) const {
      const auto* value = std::get_if<ast::ExprPtr>(&function.body);
      return value == nullptr || block(*value);
    }
    bool operator()(const ast::Property& property) const {
      const auto* value = std::get_if<ast::ExprPtr>(&property.value);
      return value == nullptr || block(*value);
    }
    bool operator()(const ast::Param&) const { return false; }
    bool operator()(const ast::Include&) const { return false; }
    bool operator()(const ast::Assert&) const { return false; }
    bool operator()(const ast::Print&) const { return false; }
    bool operator()(const ast::ErrorItem&) const { return false; }
  };
  return std::visit(Visitor{is_block}, item.node);
}

std::string without_carriage_returns(std::string_view text) {
  std::string lines;
  for (const char byte : text) {
    if (byte == '\n') {
      while (!lines.empty() && lines.back() == '\r')
        lines.pop_back();
    }
    lines += byte;
  }
  return lines;
}

}  // namespace

Doc Printer::comment(const ast::Comment& comment) {
  return docs_.text(without_carriage_returns(comment.text));
}

Doc Printer::trailing(ast::List<ast::Comment> comments) {
  std::string text;
  for (const ast::Comment& comment : comments) {
    text += (text.empty() ? "  " : " ") + without_carriage_returns(comment.text);
  }
  return text.empty() ? DocBuilder::nothing() : docs_.note(std::move(text));
}

Doc Printer::items(ast::List<ast::ItemPtr> items, ast::List<ast::Comment> dangling) {
  std::vector<Doc> parts;
  const auto new_line = [&](bool blank) {
    if (!parts.empty()) parts.push_back(docs_.hard(blank));
  };
  const auto own_line = [&](const ast::Comment& comment, bool blank) {
    new_line(blank);
    parts.push_back(this->comment(comment));
  };
  for (const ast::ItemPtr& item : items) {
    bool blank = item->blank_line_before;
    for (const ast::Comment& comment : item->leading)
      own_line(comment, comment.blank_line_before);
    if (ends_in_body(*item)) {
      for (const ast::Comment& comment : item->interior) {
        own_line(comment, std::exchange(blank, false));
      }
    }
    const bool plain = item->leading.empty() && item->trailing.empty() && item->interior.empty();
    if (!parts.empty() && !plain) {
      new_line(blank);
    } else if (!parts.empty()) {
      parts.push_back(blank ? docs_.hard(true) : docs_.line("  "));
    }
    parts.push_back(this->item(*item));
    parts.push_back(trailing(item->trailing));
  }
  for (const ast::Comment& comment : dangling)
    own_line(comment, comment.blank_line_before);
  return docs_.concat(std::move(parts));
}

Doc Printer::item(const ast::Item& item) {
  if (!item.interior.empty() && !ends_in_body(item)) {
    return docs_.text(without_carriage_returns(std::string(sources_.text(item.span))));
  }
  return std::visit([&](const auto& what) { return node(what); }, item.node);
}

bool Printer::must_break(const ast::Body& body) const {
  if (body.items.empty() && body.dangling.empty()) return false;  // {}
  return !body.dangling.empty() || broken_after(body.span) ||
         std::any_of(body.items.begin(), body.items.end(), [](const ast::ItemPtr& item) {
           return !item->leading.empty() || !item->interior.empty() || !item->trailing.empty();
         });
}

// All bodies of a chain of conditions are on one line, or none is.
bool Printer::must_break(const ast::If& branch) const {
  if (must_break(branch.then_body)) return true;
  if (const auto* item = std::get_if<ast::ItemPtr>(&branch.else_branch)) {
    return must_break(std::get<ast::If>((*item)->node));
  }
  const auto* body = std::get_if<ast::Body>(&branch.else_branch);
  return body != nullptr && must_break(*body);
}

Doc Printer::body(const ast::Body& body) {
  if (body.items.empty() && body.dangling.empty()) return text("{}");
  const Doc inside = docs_.concat({docs_.line(" "), items(body.items, body.dangling)});
  return docs_.concat({text("{"), docs_.nest(kIndentation, inside), docs_.line(" "), text("}")});
}

Doc Printer::grouped_body(const ast::Body& body) {
  return docs_.group(this->body(body), must_break(body));
}

Doc Printer::node(const ast::Let& let) {
  return docs_.concat({text("let "), text(let.name.text), text(" = "), expression(let.value)});
}

Doc Printer::node(const ast::Param& param) {
  std::vector<Doc> parts = {text("param "), text(param.name.text), text(" = "),
                            expression(param.value)};
  if (param.range) {
    parts.push_back(text(" in "));
    parts.push_back(expression(param.range));
  }
  if (param.text) {
    parts.push_back(
        docs_.nest(2 * kIndentation, docs_.concat({docs_.line(" "), expression(param.text)})));
  }
  return docs_.group(docs_.concat(std::move(parts)));
}

Doc Printer::node(const ast::Function& function) {
  std::vector<Doc> parameters;
  for (const ast::Parameter& parameter : function.parameters) {
    Doc doc = text(parameter.name.text);
    if (parameter.default_value) {
      doc = docs_.concat({doc, text(" = "), expression(parameter.default_value)});
    }
    parameters.push_back(doc);
  }
  const Doc head = docs_.concat(
      {text("fn "), text(function.name.text), bracketed("(", parameters, ")", false), text(" ")});
  if (const auto* value = std::get_if<ast::ExprPtr>(&function.body)) {
    return docs_.concat({head, text("= "), expression(*value)});
  }
  return docs_.concat({head, grouped_body(std::get<ast::Body>(function.body))});
}

Doc Printer::node(const ast::For& loop) {
  return docs_.concat({text("for "), text(loop.variable.text), text(" in "),
                       expression(loop.sequence), text(" "), grouped_body(loop.body)});
}

Doc Printer::node(const ast::If& branch) {
  return docs_.group(if_chain(branch), must_break(branch));
}

Doc Printer::if_chain(const ast::If& branch) {
  const Doc head =
      docs_.concat({text("if "), expression(branch.condition), text(" "), body(branch.then_body)});
  if (const auto* item = std::get_if<ast::ItemPtr>(&branch.else_branch)) {
    return docs_.concat({head, text(" else "), if_chain(std::get<ast::If>((*item)->node))});
  }
  const auto* otherwise = std::get_if<ast::Body>(&branch.else_branch);
  if (otherwise == nullptr) return head;
  return docs_.concat({head, text(" else "), body(*otherwise)});
}

Doc Printer::node(const ast::Include& include) {
  return docs_.concat({text("include "), source(include.path_span)});
}

Doc Printer::node(const ast::Assert& assertion) {
  const Doc head = docs_.concat({text("assert "), expression(assertion.condition)});
  if (!assertion.message) return head;
  const Doc message = docs_.concat({docs_.line(" "), expression(assertion.message)});
  return docs_.group(docs_.concat({head, text(","), docs_.nest(2 * kIndentation, message)}));
}

Doc Printer::node(const ast::Print& print) {
  return docs_.group(
      docs_.concat({text("print "), docs_.nest(2 * kIndentation, separated(print.values))}));
}

Doc Printer::node(const ast::Return& statement) {
  return docs_.concat({text("return "), expression(statement.value)});
}

Doc Printer::node(const ast::Placement& placement) {
  return expression(placement.object);
}

Doc Printer::node(const ast::Property& property) {
  const Doc head = docs_.concat({text(property.name.text), text(" ")});
  if (const auto* value = std::get_if<ast::ExprPtr>(&property.value)) {
    return docs_.concat({head, expression(*value)});
  }
  return docs_.concat({head, grouped_body(std::get<ast::Body>(property.value))});
}

}  // namespace alhazen::parser

// parser/print: expressions. Literals keep the author's spelling.
#include "parser/ast/operators.h"
#include "parser/print/printer.h"

namespace alhazen::parser {
namespace {

constexpr int kContinuation = 4;

// Operators of one level form one chain, broken at all of its operators or at none.
int level(ast::BinaryOperator op) {
  switch (op) {
    case ast::BinaryOperator::logical_or:
      return 0;
    case ast::BinaryOperator::logical_and:
      return 1;
    case ast::BinaryOperator::add:
    case ast::BinaryOperator::subtract:
      return 3;
    case ast::BinaryOperator::multiply:
    case ast::BinaryOperator::divide:
    case ast::BinaryOperator::remainder:
      return 4;
    case ast::BinaryOperator::power:
      return 5;
    default:
      return 2;  // comparisons
  }
}

}  // namespace

bool Printer::broken_after(SourceSpan span) const {
  const std::string_view text = sources_.text(span).substr(1);
  const std::size_t next = text.find_first_not_of(" \t\r");
  return next != std::string_view::npos && text[next] == '\n';
}

Doc Printer::separated(ast::List<ast::ExprPtr> list) {
  std::vector<Doc> parts;
  for (const ast::ExprPtr& expr : list) {
    if (!parts.empty()) parts.push_back(docs_.concat({text(","), docs_.line(" ")}));
    parts.push_back(expression(expr));
  }
  return docs_.concat(std::move(parts));
}

Doc Printer::bracketed(std::string_view opener, const std::vector<Doc>& elements,
                       std::string_view closer, bool broken) {
  if (elements.empty()) return docs_.concat({text(opener), text(closer)});
  std::vector<Doc> parts = {docs_.line("")};
  for (const Doc element : elements) {
    if (parts.size() > 1) parts.push_back(docs_.concat({text(","), docs_.line(" ")}));
    parts.push_back(element);
  }
  const Doc inside = docs_.nest(2, docs_.concat(std::move(parts)));
  return docs_.group(docs_.concat({text(opener), inside, docs_.line("", ","), text(closer)}),
                     broken);
}

Doc Printer::binary(const ast::Binary& binary) {
  if (binary.op == ast::BinaryOperator::power) {
    return docs_.concat({expression(binary.left), text("^"), expression(binary.right)});
  }
  // The chain leans to the left: collect it from the last operator to the first operand.
  std::vector<const ast::Binary*> chain = {&binary};
  while (const auto* left = std::get_if<ast::Binary>(&chain.back()->left->node)) {
    if (level(left->op) != level(binary.op)) break;
    chain.push_back(left);
  }
  std::vector<Doc> rest;
  for (auto link = chain.rbegin(); link != chain.rend(); ++link) {
    rest.push_back(docs_.concat({docs_.line(" "), text(ast::spelling((*link)->op)), text(" "),
                                 expression((*link)->right)}));
  }
  const Doc first = expression(chain.back()->left);
  return docs_.group(
      docs_.concat({first, docs_.nest(kContinuation, docs_.concat(std::move(rest)))}));
}

Doc Printer::call(const ast::Call& call) {
  std::vector<Doc> arguments;
  for (const ast::Argument& argument : call.arguments) {
    const Doc value = expression(argument.value);
    arguments.push_back(argument.name ? docs_.concat({text(argument.name->text), text(": "), value})
                                      : value);
  }
  return docs_.concat(
      {expression(call.callee), bracketed("(", arguments, ")", broken_after(call.arguments_span))});
}

Doc Printer::expression(const ast::Expr& expr) {
  struct Visitor {
    Printer& printer;
    SourceSpan span;

    Doc concat(std::vector<Doc> parts) const { return printer.docs_.concat(std::move(parts)); }
    Doc text(std::string_view text) const { return printer.text(text); }
    Doc doc(const ast::ExprPtr& expr) const { return printer.expression(*expr); }

    Doc operator()(const ast::NumberLiteral&) const { return printer.source(span); }
    Doc operator()(const ast::AngleLiteral&) const { return printer.source(span); }
    Doc operator()(const ast::StringLiteral&) const { return printer.source(span); }
    Doc operator()(const ast::HexColor&) const { return printer.source(span); }
    Doc operator()(const ast::BoolLiteral&) const { return printer.source(span); }
    Doc operator()(const ast::NameRef& reference) const { return text(reference.name); }
    Doc operator()(const ast::VectorLiteral& vector) const {
      std::vector<Doc> parts = {text("<")};
      for (const ast::ExprPtr& component : vector.components) {
        if (parts.size() > 1) parts.push_back(text(", "));
        parts.push_back(doc(component));
      }
      parts.push_back(text(">"));
      return concat(std::move(parts));
    }
    Doc operator()(const ast::ListLiteral& list) const {
      std::vector<Doc> elements;
      for (const ast::ExprPtr& element : list.elements)
        elements.push_back(doc(element));
      return printer.bracketed("[", elements, "]", printer.broken_after(span));
    }
    Doc operator()(const ast::Parenthesized& parenthesized) const {
      return concat({text("("), doc(parenthesized.inner), text(")")});
    }
    Doc operator()(const ast::Unary& unary) const {
      const bool word = unary.op == ast::UnaryOperator::logical_not;
      return concat({text(ast::spelling(unary.op)), text(word ? " " : ""), doc(unary.operand)});
    }
    Doc operator()(const ast::Binary& binary) const { return printer.binary(binary); }
    Doc operator()(const ast::Range& range) const {
      const Doc ends =
          concat({doc(range.first), text(range.inclusive ? " ..= " : " .. "), doc(range.last)});
      return range.step ? concat({ends, text(" by "), doc(range.step)}) : ends;
    }
    Doc operator()(const ast::Conditional& conditional) const {
      const Doc choices =
          concat({printer.docs_.line(" "), text("then "), doc(conditional.then_value),
                  printer.docs_.line(" "), text("else "), doc(conditional.else_value)});
      return printer.docs_.group(concat(
          {text("if "), doc(conditional.condition), printer.docs_.nest(kContinuation, choices)}));
    }
    Doc operator()(const ast::Member& member) const {
      // `1.x` would be a malformed number.
      const bool number = std::holds_alternative<ast::NumberLiteral>(member.object->node);
      return concat({doc(member.object), text(number ? " ." : "."), text(member.member.text)});
    }
    Doc operator()(const ast::Index& index) const {
      return concat({doc(index.object), text("["), doc(index.index), text("]")});
    }
    Doc operator()(const ast::Call& call) const { return printer.call(call); }
    Doc operator()(const ast::Block& block) const {
      return concat({doc(block.head), text(" "), printer.grouped_body(block.body)});
    }
    Doc operator()(const ast::ErrorExpr&) const { return DocBuilder::nothing(); }
  };
  return std::visit(Visitor{*this, expr.span}, expr.node);
}

}  // namespace alhazen::parser

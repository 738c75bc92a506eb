// parser/eval: items, one after the other.
#include <fmt/format.h>

#include "core/base/overloaded.h"
#include "parser/eval/block_builder.h"
#include "parser/eval/evaluator.h"

namespace alhazen::parser {

Flow Evaluator::run(Items items, const Body& body) {
  for (const ast::ItemPtr& item : items) {
    if (!context_.spend_fuel(1, item->span)) return Flow::returned;
    if (run_item(*item, body) == Flow::returned) return Flow::returned;
  }
  return Flow::next;
}

Flow Evaluator::run_item(const ast::Item& item, const Body& body) {
  if (const auto* property = std::get_if<ast::Property>(&item.node)) {
    body.target.take(*property, item.span, body.scope);
    return Flow::next;
  }
  const auto then_next = [](auto&& action) {
    action();
    return Flow::next;
  };
  return std::visit(
      Overloaded{[&](const ast::Let& i) { return then_next([&] { run_let(i, body); }); },
                 [&](const ast::Param& i) { return then_next([&] { run_param(i, body); }); },
                 [&](const ast::Function& i) { return then_next([&] { run_function(i, body); }); },
                 [&](const ast::For& i) { return run_for(i, body); },
                 [&](const ast::If& i) { return run_if(i, body); },
                 [&](const ast::Include& i) { return then_next([&] { run_include(i, body); }); },
                 [&](const ast::Assert& i) { return then_next([&] { run_assert(i, body); }); },
                 [&](const ast::Print& i) { return then_next([&] { run_print(item, i, body); }); },
                 [&](const ast::Return& i) { return run_return(item, i, body); },
                 [&](const ast::Property& i) {
                   return then_next([&] { body.target.take(i, item.span, body.scope); });
                 },
                 [&](const ast::Placement& i) {
                   return then_next([&] { body.target.take(i, item.span, body.scope); });
                 },
                 [&](const ast::ErrorItem&) { return Flow::next; }},
      item.node);
}

bool Evaluator::define(const ast::Name& name, Value value, const Body& body) {
  Word& word = words_[name.text];
  if (const Binding* earlier = body.scope.find_here(word)) {
    context_.report<DiagnosticKind::already_defined>(name.span, name.text)
        .label(earlier->span, "first defined here")
        .hint("names cannot change; choose another");
    return false;
  }
  body.scope.define(word, std::move(value), name.span);
  return true;
}

void Evaluator::run_let(const ast::Let& let, const Body& body) {
  const Value value = evaluate(*let.value, body.scope);
  if (value.is(Type::material) && std::holds_alternative<ast::Block>(let.value->node)) {
    context_.store().name_material(value.as<MaterialRef>().id, let.name.text);
  }
  define(let.name, value, body);
}

void Evaluator::run_function(const ast::Function& function, const Body& body) {
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (function.parameters[i].name.text != function.parameters[j].name.text) continue;
      context_
          .report<DiagnosticKind::already_defined>(function.parameters[i].name.span,
                                                   function.parameters[i].name.text)
          .label(function.parameters[j].name.span, "first defined here");
      return;
    }
  }
  body.scope.capture();
  define(function.name, Function{&function, &body.scope}, body);
}

void Evaluator::run_assert(const ast::Assert& assertion, const Body& body) {
  const auto holds = evaluate_condition(*assertion.condition, "`assert`", body.scope);
  if (!holds || *holds) return;
  std::string message = "this does not hold";
  if (assertion.message) {
    const Value value = evaluate(*assertion.message, body.scope);
    if (value.is_poison()) return;
    message = to_text(value);
  }
  context_.report<DiagnosticKind::assertion_failed>(assertion.condition->span, message);
}

void Evaluator::run_print(const ast::Item& item, const ast::Print& print, const Body& body) {
  std::string line;
  for (const ast::ExprPtr& expr : print.values) {
    const Value value = evaluate(*expr, body.scope);
    if (value.is_poison()) return;
    if (!line.empty()) line += ' ';
    line += to_text(value);
  }
  if (!context_.spend_string(line.size(), item.span)) return;
  if (out_.printed.size() >= context_.limits().printed_lines) {
    context_.halt<DiagnosticKind::memory_exhausted>(item.span, "`print`",
                                                    context_.limits().printed_lines, "lines");
    return;
  }
  out_.printed.push_back({std::move(line), item.span});
}

Flow Evaluator::run_return(const ast::Item& item, const ast::Return& statement, const Body& body) {
  if (body.result == nullptr) {
    context_.report<DiagnosticKind::return_outside>(item.span);
    return Flow::next;
  }
  body.result->value = evaluate(*statement.value, body.scope);
  body.result->span = item.span;
  return Flow::returned;
}

}  // namespace alhazen::parser

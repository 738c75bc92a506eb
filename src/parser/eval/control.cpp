// parser/eval: `for` and `if`.
#include "parser/eval/block_builder.h"
#include "parser/eval/evaluator.h"
#include "parser/eval/operator.h"

namespace alhazen::parser {

Flow Evaluator::run_for(const ast::For& loop, const Body& body) {
  const Value sequence = evaluate(*loop.sequence, body.scope);
  if (sequence.is_poison()) return Flow::next;
  const bool is_list = sequence.is(Type::list);
  if (!is_list && !sequence.is(Type::range)) {
    Diagnostic& d = context_.report<DiagnosticKind::not_a_sequence>(loop.sequence->span,
                                                                    a_type_name(sequence.type()));
    if (sequence.is(Type::number)) d.hint("write `0 .. " + to_text(sequence, 40) + "`");
    return Flow::next;
  }
  const double count = is_list ? static_cast<double>(sequence.elements().size())
                               : sequence.as<IntervalPtr>()->count();
  // Said at once rather than after so many turns.
  if (count > static_cast<double>(context_.fuel_left())) {
    context_.halt<DiagnosticKind::loop_too_long>(loop.sequence->span, number_text(count),
                                                 context_.fuel_left(), context_.limits().fuel);
    return Flow::returned;
  }
  const std::size_t errors_before = context_.sink().error_count();
  for (double k = 0; k < count; ++k) {
    if (!context_.spend_fuel(1, loop.sequence->span)) return Flow::returned;
    const ScopeLease scope(scopes_, body.scope);
    Value value = is_list ? sequence.elements()[static_cast<std::size_t>(k)]
                          : element_of(*sequence.as<IntervalPtr>(), k);
    scope->define(words_[loop.variable.text], std::move(value), loop.variable.span);
    const ScopeLease inside(scopes_, *scope);
    if (run(loop.body.items, {*inside, body.target, body.result}) == Flow::returned) {
      return Flow::returned;
    }
    // What is wrong in one turn is likely wrong in all.
    if (context_.sink().error_count() > errors_before) return Flow::next;
  }
  return Flow::next;
}

Flow Evaluator::run_if(const ast::If& statement, const Body& body) {
  const auto holds = evaluate_condition(*statement.condition, "`if`", body.scope);
  if (!holds) return Flow::next;
  const auto run_body = [&](const ast::Body& chosen) {
    const ScopeLease inside(scopes_, body.scope);
    return run(chosen.items, {*inside, body.target, body.result});
  };
  if (*holds) return run_body(statement.then_body);
  if (const auto* otherwise = std::get_if<ast::Body>(&statement.else_branch)) {
    return run_body(*otherwise);
  }
  if (const auto* next = std::get_if<ast::ItemPtr>(&statement.else_branch)) {
    return run_item(**next, body);
  }
  return Flow::next;
}

}  // namespace alhazen::parser

// parser/eval: calls of functions of the scene.
#include <fmt/format.h>

#include "core/base/near_name.h"
#include "core/base/small_vector.h"
#include "parser/eval/block_builder.h"
#include "parser/eval/evaluator.h"
#include "parser/eval/place.h"

namespace alhazen::parser {

Value Evaluator::evaluate_call(const ast::Expr& expr, const ast::Call& call, Scope& scope) {
  const Value callee = evaluate(*call.callee, scope);
  if (callee.is(Type::builtin)) {
    return call_builtin(expr, call, *callee.as<const BuiltinFunction*>(), scope);
  }
  if (callee.is(Type::function)) return call_function(expr, call, callee.as<Function>(), scope);
  if (!callee.is_poison()) {
    context_.report<DiagnosticKind::not_a_function>(call.callee->span, a_type_name(callee.type()));
  }
  return Poison{};
}

Value Evaluator::call_function(const ast::Expr& expr, const ast::Call& call,
                               const Function& function, Scope& scope) {
  const ast::Function& definition = *function.definition;
  if (call_depth_ >= context_.limits().call_depth) {
    context_
        .halt<DiagnosticKind::calls_too_deep>(expr.span, definition.name.text,
                                              context_.limits().call_depth)
        .label(definition.name.span, "defined here")
        .hint("a recursion needs a case that ends it: `if n == 0 then ... else ...`");
    return Poison{};
  }
  // Arguments see the caller's names, defaults those of the function and the parameters before.
  const std::size_t count = definition.parameters.size();
  SmallVector<const ast::Argument*, 8> given(count);
  bool failed = false;
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const ast::Argument& argument = call.arguments[i];
    std::size_t slot = i;
    if (argument.name) {
      slot = 0;
      while (slot < count && definition.parameters[slot].name.text != argument.name->text)
        ++slot;
      if (slot == count) {
        Diagnostic& d = context_.report<DiagnosticKind::unknown_argument>(
            argument.name->span, definition.name.text, argument.name->text);
        std::vector<std::string_view> names;
        for (const ast::Parameter& parameter : definition.parameters)
          names.push_back(parameter.name.text);
        if (const auto meant = near_name(argument.name->text, names)) {
          d.hint(fmt::format("did you mean `{}`?", *meant));
        }
        d.label(definition.name.span, "defined here");
        failed = true;
        continue;
      }
    } else if (i >= count) {
      context_
          .report<DiagnosticKind::wrong_argument_count>(argument.value->span, definition.name.text,
                                                        fmt::format("{}", count),
                                                        call.arguments.size())
          .label(definition.name.span, "defined here");
      return Poison{};
    }
    if (given[slot] != nullptr) {
      context_
          .report<DiagnosticKind::repeated_argument>(argument.value->span,
                                                     definition.parameters[slot].name.text)
          .label(given[slot]->value->span, "first given here");
      failed = true;
    }
    given[slot] = &argument;
  }
  if (failed) return Poison{};
  SmallVector<Value, 8> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (given[i] != nullptr) {
      values[i] = evaluate(*given[i]->value, scope);
      failed = failed || values[i].is_poison();
    } else if (!definition.parameters[i].default_value) {
      context_
          .report<DiagnosticKind::missing_argument>(call.arguments_span, definition.name.text,
                                                    definition.parameters[i].name.text)
          .label(definition.parameters[i].name.span, "it has no default");
      return Poison{};
    }
  }
  if (failed) return Poison{};
  const ScopeLease inside(scopes_, *function.scope);
  context_.enter_call(expr.span, definition.name.text);
  ++call_depth_;
  for (std::size_t i = 0; i < count; ++i) {
    const ast::Parameter& parameter = definition.parameters[i];
    if (given[i] == nullptr) values[i] = evaluate(*parameter.default_value, *inside);
    inside->define(words_[parameter.name.text], std::move(values[i]), parameter.name.span);
  }
  Value result;
  if (const auto* expression = std::get_if<ast::ExprPtr>(&definition.body)) {
    result = evaluate(**expression, *inside);
  } else {
    result = run_function_body(expr, definition, std::get<ast::Body>(definition.body), *inside);
  }
  --call_depth_;
  context_.leave();
  return result;
}

// A body that returns has that value; one that does not has all that it placed, as a group.
Value Evaluator::run_function_body(const ast::Expr& expr, const ast::Function& function,
                                   const ast::Body& body, Scope& scope) {
  BlockBuilder builder(*this, group_schema(), expr.span);
  ReturnSlot slot;
  const ScopeLease inside(scopes_, scope);
  run(body.items, {*inside, builder, &slot});
  if (context_.halted()) return Poison{};
  if (slot.value) {
    if (!builder.empty()) {
      context_.report<DiagnosticKind::mixed_function>(builder.first_span(), function.name.text)
          .label(slot.span, "it returns a value here");
      return Poison{};
    }
    return *slot.value;
  }
  auto node = make_group(*this, builder, expr.span);
  return node ? Value(object_of(std::move(*node))) : Value(Poison{});
}

}  // namespace alhazen::parser

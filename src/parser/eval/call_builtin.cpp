// parser/eval: calls of built-in functions: arguments against the function's table.
#include <algorithm>
#include <fmt/format.h>

#include "parser/eval/evaluator.h"
#include "parser/eval/operator.h"
#include "parser/eval/property_check.h"

namespace alhazen::parser {
namespace {

std::size_t required_count(const BuiltinFunction& function) {
  std::size_t count = 0;
  for (const BuiltinParameter& parameter : function.parameters)
    count += parameter.optional ? 0 : 1;
  // The parameter that may be repeated may also be left out if it follows others.
  return count;
}

// Whether every argument is for the parameter at its own place, and no required one is missing: so
// are most calls.
bool is_in_order(const ast::Call& call, const BuiltinFunction& function) {
  const std::size_t count = call.arguments.size();
  if (count < required_count(function)) return false;
  if (count > function.parameters.size() && !function.variadic) return false;
  return std::none_of(call.arguments.begin(), call.arguments.end(),
                      [](const ast::Argument& argument) { return argument.name.has_value(); });
}

using Slots = SmallVector<const ast::Argument*, 6>;

// Which parameter each argument is for; nothing after a report.
std::optional<Slots> match(Context& context, const ast::Call& call,
                           const BuiltinFunction& function) {
  const std::size_t count = function.parameters.size();
  Slots slots(count);
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const ast::Argument& argument = call.arguments[i];
    std::size_t slot = i;
    if (argument.name) {
      slot = 0;
      while (slot < count && function.parameters[slot].name != argument.name->text)
        ++slot;
      if (slot == count) {
        Diagnostic& d = context.report<DiagnosticKind::unknown_argument>(
            argument.name->span, function.name, argument.name->text);
        d.hint(fmt::format("it is `{}`", signature(function)));
        return std::nullopt;
      }
    }
    if (slot >= count && function.variadic) slots.push_back(nullptr);
    if (slot >= slots.size()) {
      context
          .report<DiagnosticKind::wrong_argument_count>(
              argument.value->span, function.name, fmt::format("{}", count), call.arguments.size())
          .hint(fmt::format("it is `{}`", signature(function)));
      return std::nullopt;
    }
    if (slots[slot] != nullptr) {
      context
          .report<DiagnosticKind::repeated_argument>(argument.value->span,
                                                     function.parameters[slot].name)
          .label(slots[slot]->value->span, "first given here");
      return std::nullopt;
    }
    slots[slot] = &argument;
  }
  for (std::size_t i = 0; i < required_count(function); ++i) {
    if (slots[i] != nullptr) continue;
    const bool may_be_left_out = function.variadic && i + 1 == count && i > 0;
    if (may_be_left_out) {
      slots.pop_back();
      break;
    }
    context
        .report<DiagnosticKind::missing_argument>(call.arguments_span, function.name,
                                                  function.parameters[i].name)
        .hint(fmt::format("it is `{}`", signature(function)));
    return std::nullopt;
  }
  return slots;
}

// False, after a report unless the value is poison, where it does not suit the parameter.
bool check_argument(Context& context, const BuiltinFunction& function,
                    const BuiltinParameter& parameter, const ast::Argument& argument,
                    const Value& value) {
  if (value.is_poison()) return false;
  if ((parameter.types & set_of(value.type())) != 0) return true;
  Diagnostic& d = context.report<DiagnosticKind::argument_type>(
      argument.value->span, function.name, describe(parameter.types), a_type_name(value.type()));
  const std::string hint = conversion_hint(parameter.types, value);
  if (!hint.empty()) d.hint(hint);
  return false;
}

}  // namespace

Value Evaluator::call_builtin(const ast::Expr& expr, const ast::Call& call,
                              const BuiltinFunction& function, Scope& scope) {
  BuiltinCall checked{context_, expr.span, {}, {}, function.name};
  bool poisoned = false;
  const auto take = [&](const ast::Argument& argument) {
    Value value = evaluate(*argument.value, scope);
    const std::size_t i = std::min(checked.values.size(), function.parameters.size() - 1);
    if (!check_argument(context_, function, function.parameters[i], argument, value)) {
      poisoned = true;
    }
    checked.values.push_back(std::move(value));
    checked.spans.push_back(argument.value->span);
  };
  const auto leave_out = [&] {
    checked.values.push_back(Value());
    checked.spans.push_back(expr.span);
  };
  if (is_in_order(call, function)) {
    for (const ast::Argument& argument : call.arguments)
      take(argument);
    while (checked.values.size() < function.parameters.size())
      leave_out();
  } else {
    const auto slots = match(context_, call, function);
    if (!slots) return Poison{};
    for (const ast::Argument* argument : *slots)
      argument != nullptr ? take(*argument) : leave_out();
  }
  if (poisoned || context_.halted()) return Poison{};
  Value result = function.apply(checked);
  if (!is_finite(result)) result = report_not_finite(context_, expr.span);
  return result;
}

}  // namespace alhazen::parser

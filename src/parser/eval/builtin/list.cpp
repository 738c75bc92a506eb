// parser/eval: functions of lists, strings and ranges.
#include "parser/eval/builtin/builtin.h"
#include "parser/eval/operator.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {
namespace {

constexpr BuiltinParameter kAny[] = {{"value", kAnyType}};
constexpr BuiltinParameter kSized[] = {{"value", kList | kString | kRange}};
constexpr BuiltinParameter kSequence[] = {{"values", kList | kRange}};
constexpr BuiltinParameter kCount[] = {{"from", kNumber}, {"to", kNumber}, {"count", kNumber}};

Value len_of(const BuiltinCall& call) {
  const Value& value = call.values[0];
  if (value.is(Type::list)) return static_cast<double>(value.elements().size());
  if (value.is(Type::range)) return value.as<IntervalPtr>()->count();
  if (!call.context.spend_scan(value.text().size(), call.span)) return Poison{};
  double code_points = 0;
  for (const char byte : value.text())
    code_points += (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U ? 1 : 0;
  return code_points;
}

Value str_of(const BuiltinCall& call) {
  return call.context.make_text(to_text(call.values[0]), call.span);
}

// The values of a list or a range, or nothing when a limit was hit.
std::optional<std::vector<Value>> values_of(const BuiltinCall& call) {
  const Value& sequence = call.values[0];
  if (sequence.is(Type::list)) {
    const std::vector<Value>& elements = sequence.elements();
    if (!call.context.spend_fuel(elements.size(), call.span)) return std::nullopt;
    return elements;
  }
  const Interval& range = *sequence.as<IntervalPtr>();
  const double count = range.count();
  const auto limit = static_cast<double>(call.context.limits().list_elements);
  if (!call.context.spend_list(static_cast<std::uint64_t>(smaller(count, limit + 1)), call.span)) {
    return std::nullopt;
  }
  std::vector<Value> values;
  for (double k = 0; k < count; ++k)
    values.push_back(element_of(range, k));
  return values;
}

Value list_of(const BuiltinCall& call) {
  auto values = values_of(call);
  if (!values) return Poison{};
  return call.context.make_list(std::move(*values), call.span);
}

Value reverse_of(const BuiltinCall& call) {
  auto values = values_of(call);
  if (!values) return Poison{};
  return call.context.make_list({values->rbegin(), values->rend()}, call.span);
}

Value sum_of(const BuiltinCall& call) {
  const auto values = values_of(call);
  if (!values) return Poison{};
  if (values->empty()) return 0.0;
  Value sum = values->front();
  for (std::size_t i = 1; i < values->size() && !sum.is_poison(); ++i) {
    sum = apply_binary(call.context, ast::BinaryOperator::add, sum, call.spans[0], (*values)[i],
                       call.spans[0]);
  }
  return sum;
}

// Both ends included, each value computed from both, so that the last is exactly `to`.
Value linspace(const BuiltinCall& call) {
  const double from = call.number(0), to = call.number(1), count = call.number(2);
  if (count != round_down(count) || !(count >= 2)) {
    return call.outside_domain(2, "a whole number of at least 2");
  }
  const auto limit = static_cast<double>(call.context.limits().list_elements);
  // More than can be paid for is not even made.
  if (count > limit) {
    call.context.spend_list(call.context.limits().list_elements + 1, call.span);
    return Poison{};
  }
  std::vector<Value> values;
  for (double k = 0; k < count; ++k) {
    const double w = k / (count - 1);
    values.emplace_back((1 - w) * from + w * to);
  }
  return call.context.make_list(std::move(values), call.span);
}

constexpr BuiltinFunction kFunctions[] = {
    {"len", kSized, false, "number", "how many elements, values or characters it has", len_of},
    {"linspace", kCount, false, "list",
     "so many numbers, evenly from `from` to `to`, both included", linspace},
    {"list", kSequence, false, "list", "the values of a range as a list", list_of},
    {"reverse", kSequence, false, "list", "the values in the opposite order", reverse_of},
    {"str", kAny, false, "string", "the value as text", str_of},
    {"sum", kSequence, false, "as the elements", "all elements added up; 0 if there are none",
     sum_of},
};

}  // namespace

std::span<const BuiltinFunction> list_functions() {
  return kFunctions;
}

}  // namespace alhazen::parser

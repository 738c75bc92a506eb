// parser/eval: arithmetic, comparison and their errors.
#include "parser/eval/operator.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

#include "core/math/elementary.h"
#include "parser/eval/builtin/componentwise.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {
namespace {

using Op = ast::BinaryOperator;

// What has a sum, a difference and multiples.
constexpr TypeSet kLinear = kNumber | kAngle | kVec2 | kVec3 | kAngles | kColor;
// What is multiplied and divided component by component.
constexpr TypeSet kFields = kNumber | kVec2 | kVec3 | kColor;

bool is_one_of(const Value& value, TypeSet types) {
  return (set_of(value.type()) & types) != 0;
}

Value scaled(const Value& value, double factor) {
  return map_components(value, [factor](double c) { return c * factor; });
}

// Poison: these types do not go together.
Value multiply(const Value& a, const Value& b) {
  if (a.type() == b.type() && is_one_of(a, kFields)) return combine(a, b, std::multiplies<>());
  if (a.is(Type::number) && is_one_of(b, kLinear)) return scaled(b, a.number());
  if (b.is(Type::number) && is_one_of(a, kLinear)) return scaled(a, b.number());
  // `y * 30deg`: a rotation about y.
  if (a.is(Type::vec3) && b.is(Type::angle)) {
    return AngleVector{a.as<Vec3d>() * b.as<Angle>().deg};
  }
  if (a.is(Type::angle) && b.is(Type::vec3)) return multiply(b, a);
  return Poison{};
}

Value divide(const Value& a, const Value& b) {
  if (a.type() == b.type() && is_one_of(a, kFields)) return combine(a, b, std::divides<>());
  if (a.is(Type::angle) && b.is(Type::angle)) return a.as<Angle>().deg / b.as<Angle>().deg;
  if (b.is(Type::number) && is_one_of(a, kLinear)) {
    return map_components(a, [d = b.number()](double c) { return c / d; });
  }
  return Poison{};
}

bool has_zero(const Value& value) {
  bool found = false;
  if (is_one_of(value, kLinear)) {
    map_components(value, [&](double c) {
      found = found || c == 0;
      return c;
    });
  }
  return found;
}

Value arithmetic(Op op, const Value& a, const Value& b) {
  const bool same = a.type() == b.type();
  switch (op) {
    case Op::add:
      return same && is_one_of(a, kLinear) ? combine(a, b, std::plus<>()) : Value(Poison{});
    case Op::subtract:
      return same && is_one_of(a, kLinear) ? combine(a, b, std::minus<>()) : Value(Poison{});
    case Op::multiply:
      return multiply(a, b);
    case Op::divide:
      return divide(a, b);
    case Op::remainder:
      return same && is_one_of(a, kNumber | kAngle) ? combine(a, b, floored_remainder)
                                                    : Value(Poison{});
    default:
      return Poison{};
  }
}

// -1, 0, 1, or nothing where the types have no order.
std::optional<int> order(const Value& a, const Value& b) {
  if (a.type() != b.type()) return std::nullopt;
  const auto of = [](const auto& p, const auto& q) { return p < q ? -1 : q < p ? 1 : 0; };
  if (a.is(Type::number)) return of(a.number(), b.number());
  if (a.is(Type::angle)) return of(a.as<Angle>().deg, b.as<Angle>().deg);
  if (a.is(Type::string)) return of(a.text(), b.text());
  return std::nullopt;
}

bool holds(Op op, int order) {
  switch (op) {
    case Op::less:
      return order < 0;
    case Op::less_equal:
      return order <= 0;
    case Op::greater:
      return order > 0;
    default:
      return order >= 0;
  }
}

// What it costs to compare two strings; nothing for other types.
bool spend_on_texts(Context& context, const Value& a, SourceSpan at, const Value& b) {
  if (!a.is(Type::string) || !b.is(Type::string)) return true;
  return context.spend_scan(std::min(a.text().size(), b.text().size()), at);
}

Value report_types(Context& context, Op op, const Value& a, SourceSpan a_span, const Value& b,
                   SourceSpan b_span) {
  struct Words {
    std::string_view verb, between;
  };
  const Words words = [&]() -> Words {
    switch (op) {
      case Op::add:
        return {"add", "and"};
      case Op::subtract:
        return {"subtract", "and"};
      case Op::multiply:
        return {"multiply", "and"};
      case Op::divide:
        return {"divide", "by"};
      case Op::remainder:
        return {"take the remainder of", "by"};
      case Op::power:
        return {"raise", "to the power of"};
      default:
        return {"compare", "and"};
    }
  }();
  Diagnostic& d = context.report<DiagnosticKind::operand_types>(
      b_span, words.verb, a_type_name(a.type()), words.between, a_type_name(b.type()));
  d.label(a_span, std::string("this is ") + std::string(a_type_name(a.type())));
  const TypeSet both = set_of(a.type()) | set_of(b.type());
  if (both == (kNumber | kAngle)) d.hint("angles carry a unit: `30deg` or `0.5rad`");
  if (both == (kNumber | kColor)) d.hint("a colour is written with its space: `rgb(0.5)`");
  if (both == (kVec3 | kColor)) d.hint("a colour is written with its space: `rgb(1, 0.5, 0)`");
  if (op == Op::add && (both & kString) != 0) d.hint("`str(...)` turns any value into a string");
  return Poison{};
}

}  // namespace

double floored_remainder(double a, double b) {
  const double r = std::fmod(a, b);  // exact (IEEE 754), with the sign of a
  return r != 0 && (r < 0) != (b < 0) ? r + b : r;
}

Value element_of(const Interval& range, double k) {
  const double value = range.first + k * range.step;
  return range.of_angles ? Value(Angle{value}) : Value(value);
}

Value report_not_finite(Context& context, SourceSpan span) {
  context.report<DiagnosticKind::result_not_finite>(span);
  return Poison{};
}

Value raise_to_power(Context& context, double base, SourceSpan base_span, double exponent,
                     SourceSpan exponent_span) {
  const bool is_whole = exponent == round_down(exponent);
  if (base < 0 && !is_whole) {
    context.report<DiagnosticKind::power_of_negative>(base_span, number_text(base))
        .label(exponent_span, "this is not a whole number");
    return Poison{};
  }
  if (base == 0 && exponent < 0) {
    context.report<DiagnosticKind::division_by_zero>(base_span);
    return Poison{};
  }
  // Small whole powers by products: `x^2` is x*x to the last bit.
  double result = 1;
  if (is_whole && absolute(exponent) <= 16) {
    for (double k = 0; k < absolute(exponent); ++k)
      result *= base;
    if (exponent < 0) result = 1 / result;
  } else {
    result = power(absolute(base), exponent);
    if (base < 0 && std::fmod(exponent, 2) != 0) result = -result;
  }
  return alhazen::is_finite(result) ? Value(result) : report_not_finite(context, base_span);
}

Value apply_binary(Context& context, Op op, const Value& a, SourceSpan a_span, const Value& b,
                   SourceSpan b_span) {
  if (a.is_poison() || b.is_poison()) return Poison{};
  if (op == Op::equal || op == Op::not_equal) {
    if (a.type() != b.type()) return report_types(context, op, a, a_span, b, b_span);
    if (a.is(Type::list) && !context.spend_fuel(a.as<ListPtr>()->weight, a_span)) return Poison{};
    if (!spend_on_texts(context, a, a_span, b)) return Poison{};
    return equal(a, b) == (op == Op::equal);
  }
  if (op == Op::less || op == Op::less_equal || op == Op::greater || op == Op::greater_equal) {
    if (!spend_on_texts(context, a, a_span, b)) return Poison{};
    const auto o = order(a, b);
    return o ? Value(holds(op, *o)) : report_types(context, op, a, a_span, b, b_span);
  }
  if (op == Op::power && a.is(Type::number) && b.is(Type::number)) {
    return raise_to_power(context, a.number(), a_span, b.number(), b_span);
  }
  if (op == Op::add && a.is(Type::string) && b.is(Type::string)) {
    return context.make_text(a.text() + b.text(), b_span);
  }
  if (op == Op::add && a.is(Type::list) && b.is(Type::list)) {
    const std::uint64_t total = a.elements().size() + b.elements().size();
    if (!context.spend_fuel(total, b_span)) return Poison{};
    std::vector<Value> all = a.elements();
    all.insert(all.end(), b.elements().begin(), b.elements().end());
    return context.make_list(std::move(all), b_span);
  }
  if ((op == Op::divide || op == Op::remainder) && has_zero(b) && !divide(a, b).is_poison()) {
    context.report<DiagnosticKind::division_by_zero>(b_span);
    return Poison{};
  }
  Value result = arithmetic(op, a, b);
  if (result.is_poison()) return report_types(context, op, a, a_span, b, b_span);
  if (is_finite(result)) return result;
  context.report<DiagnosticKind::result_not_finite>(b_span).label(a_span, "with this");
  return Poison{};
}

Value apply_unary(Context& context, ast::UnaryOperator op, const Value& operand, SourceSpan span) {
  if (operand.is_poison()) return Poison{};
  if (op == ast::UnaryOperator::logical_not) {
    if (operand.is(Type::boolean)) return !operand.as<bool>();
    context.report<DiagnosticKind::condition_not_bool>(span, "`not`", a_type_name(operand.type()));
    return Poison{};
  }
  if (is_one_of(operand, kLinear)) return map_components(operand, std::negate<>());
  context.report<DiagnosticKind::cannot_negate>(span, a_type_name(operand.type()));
  return Poison{};
}

}  // namespace alhazen::parser

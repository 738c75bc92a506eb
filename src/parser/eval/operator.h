// parser/eval: what operators do, by the types of their operands.
#pragma once

#include "parser/eval/context.h"
#include "parser/eval/value.h"

namespace alhazen::parser {

// The value of `left op right`; poison after a report at the wrong operand, and without one when an
// operand is poison. Precondition: op is not one of `and`, `or`, which do not always evaluate both.
Value apply_binary(Context& context, ast::BinaryOperator op, const Value& left,
                   SourceSpan left_span, const Value& right, SourceSpan right_span);
Value apply_unary(Context& context, ast::UnaryOperator op, const Value& operand, SourceSpan span);

Value raise_to_power(Context& context, double base, SourceSpan base_span, double exponent,
                     SourceSpan exponent_span);

// a - b floor(a / b): has the sign of b; one rounding at most. Precondition: b is not 0.
double floored_remainder(double a, double b);

// The k-th value of a range: first + k step.
Value element_of(const Interval& range, double k);

// Poison, after a report at `span` that a part of the result is not finite.
Value report_not_finite(Context& context, SourceSpan span);

}  // namespace alhazen::parser

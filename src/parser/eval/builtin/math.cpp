// parser/eval: functions of numbers. min, max, abs and the roundings work on vectors, component by
// component, and on angles where that makes sense.
#include <array>
#include <cmath>

#include "core/math/elementary.h"
#include "parser/eval/builtin/builtin.h"
#include "parser/eval/builtin/componentwise.h"
#include "parser/eval/operator.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {
namespace {

constexpr TypeSet kScalars = kNumber | kAngle;
constexpr TypeSet kArrays = kNumber | kVec2 | kVec3;

constexpr BuiltinParameter kValue[] = {{"value", kArrays}};
constexpr BuiltinParameter kMeasure[] = {{"value", kArrays | kAngle}};
constexpr BuiltinParameter kMany[] = {{"first", kScalars | kVec2 | kVec3},
                                      {"others", kScalars | kVec2 | kVec3}};
constexpr BuiltinParameter kOne[] = {{"value", kNumber}};
constexpr BuiltinParameter kPower[] = {{"base", kNumber}, {"exponent", kNumber}};
constexpr BuiltinParameter kModulus[] = {{"value", kScalars}, {"modulus", kScalars}};
constexpr BuiltinParameter kClamp[] = {{"value", kScalars}, {"low", kScalars}, {"high", kScalars}};
constexpr BuiltinParameter kMix[] = {
    {"from", kArrays | kAngle | kColor}, {"to", kArrays | kAngle | kColor}, {"weight", kNumber}};
constexpr BuiltinParameter kStep[] = {{"low", kNumber}, {"high", kNumber}, {"value", kNumber}};

// All arguments have the type of the first; otherwise a report at the first that has not.
bool same_types(const BuiltinCall& call, std::size_t count) {
  for (std::size_t i = 1; i < count; ++i) {
    if (call.values[i].type() == call.values[0].type()) continue;
    call.context
        .report<DiagnosticKind::argument_types_differ>(call.spans[i], call.function,
                                                       a_type_name(call.values[i].type()),
                                                       a_type_name(call.values[0].type()))
        .label(call.spans[0], "the first argument");
    return false;
  }
  return true;
}

template <class Choose>
Value extreme(const BuiltinCall& call, Choose choose) {
  if (!same_types(call, call.values.size())) return Poison{};
  Value best = call.values[0];
  for (std::size_t i = 1; i < call.values.size(); ++i)
    best = combine(best, call.values[i], choose);
  return best;
}

Value min_of(const BuiltinCall& call) {
  return extreme(call, smaller<double>);
}
Value max_of(const BuiltinCall& call) {
  return extreme(call, larger<double>);
}

Value abs_of(const BuiltinCall& call) {
  return map_components(call.values[0], absolute<double>);
}
Value floor_of(const BuiltinCall& call) {
  return map_components(call.values[0], round_down<double>);
}
Value ceil_of(const BuiltinCall& call) {
  return map_components(call.values[0], [](double v) { return -round_down(-v); });
}
// Halves go away from zero, as people do it. Not floor(v + 1/2): that sum may round.
Value round_of(const BuiltinCall& call) {
  return map_components(call.values[0], [](double v) { return std::round(v); });
}
Value sign_of(const BuiltinCall& call) {
  const double v = call.number(0);
  return v > 0 ? 1.0 : v < 0 ? -1.0 : 0.0;
}
Value sqrt_of(const BuiltinCall& call) {
  if (call.number(0) < 0) return call.outside_domain(0, "a number that is not negative");
  return square_root(call.number(0));
}
Value exp_of_value(const BuiltinCall& call) {
  return exp_of(call.number(0));
}
Value log_of_value(const BuiltinCall& call) {
  if (!(call.number(0) > 0)) return call.outside_domain(0, "a number above 0");
  return log_of(call.number(0));
}
Value pow_of(const BuiltinCall& call) {
  return raise_to_power(call.context, call.number(0), call.spans[0], call.number(1), call.spans[1]);
}
Value mod_of(const BuiltinCall& call) {
  if (!same_types(call, 2)) return Poison{};
  if (call.values[0].is(Type::angle)) {
    if (call.deg(1) == 0) return call.outside_domain(1, "a modulus other than 0");
    return Angle{floored_remainder(call.deg(0), call.deg(1))};
  }
  if (call.number(1) == 0) return call.outside_domain(1, "a modulus other than 0");
  return floored_remainder(call.number(0), call.number(1));
}
Value clamp_of(const BuiltinCall& call) {
  if (!same_types(call, 3)) return Poison{};
  const Value low = combine(call.values[1], call.values[2], smaller<double>);
  if (!equal(low, call.values[1])) {
    return call.outside_domain(1, "a lower bound that is not above the upper");
  }
  return combine(combine(call.values[0], call.values[1], larger<double>), call.values[2],
                 smaller<double>);
}
// (1 - w) from + w to: exact at both ends.
Value mix_of(const BuiltinCall& call) {
  if (!same_types(call, 2)) return Poison{};
  const double w = call.number(2);
  return combine(call.values[0], call.values[1],
                 [w](double from, double to) { return (1 - w) * from + w * to; });
}
Value smoothstep_of(const BuiltinCall& call) {
  const double low = call.number(0), high = call.number(1);
  if (!(low < high)) return call.outside_domain(0, "a lower end that is below the upper");
  const double t = smaller(1.0, larger(0.0, (call.number(2) - low) / (high - low)));
  return t * t * (3 - 2 * t);
}

constexpr BuiltinFunction kFunctions[] = {
    {"abs", kMeasure, false, "as given", "the value without its sign", abs_of},
    {"ceil", kValue, false, "as given", "the next whole number above", ceil_of},
    {"clamp", kClamp, false, "as given", "the value, or the bound that it lies beyond", clamp_of},
    {"exp", kOne, false, "number", "e to the power of the value", exp_of_value},
    {"floor", kValue, false, "as given", "the next whole number below", floor_of},
    {"log", kOne, false, "number", "the natural logarithm", log_of_value},
    {"max", kMany, true, "as given", "the largest; of vectors, in each component", max_of},
    {"min", kMany, true, "as given", "the smallest; of vectors, in each component", min_of},
    {"mix", kMix, false, "as given", "from one to the other as the weight goes from 0 to 1",
     mix_of},
    {"mod", kModulus, false, "as given",
     "the remainder of the division, with the sign of the modulus, as `%`", mod_of},
    {"pow", kPower, false, "number", "the base to the power of the exponent, as `^`", pow_of},
    {"round", kValue, false, "as given", "the nearest whole number; halves go away from 0",
     round_of},
    {"sign", kOne, false, "number", "-1, 0 or 1", sign_of},
    {"smoothstep", kStep, false, "number",
     "from 0 at `low` to 1 at `high` along a smooth curve, constant beyond", smoothstep_of},
    {"sqrt", kOne, false, "number", "the square root", sqrt_of},
};

}  // namespace

std::span<const BuiltinFunction> math_functions() {
  return kFunctions;
}

}  // namespace alhazen::parser

// parser/eval: ranges, `.x` and `[i]`.
#include <fmt/format.h>

#include "parser/eval/evaluator.h"
#include "parser/eval/operator.h"

namespace alhazen::parser {

Value Evaluator::evaluate_range(const ast::Range& range, Scope& scope) {
  const Value first = evaluate(*range.first, scope), last = evaluate(*range.last, scope);
  const Value step = range.step ? evaluate(*range.step, scope) : Value(1.0);
  if (first.is_poison() || last.is_poison() || step.is_poison()) return Poison{};
  if (!first.is(Type::number) && !first.is(Type::angle)) {
    context_.report<DiagnosticKind::range_type>(range.first->span, a_type_name(first.type()));
    return Poison{};
  }
  if (last.type() != first.type()) {
    context_
        .report<DiagnosticKind::range_ends_differ>(range.last->span, a_type_name(first.type()),
                                                   a_type_name(last.type()))
        .label(range.first->span, fmt::format("this is {}", a_type_name(first.type())));
    return Poison{};
  }
  Interval out;
  out.inclusive = range.inclusive;
  out.of_angles = first.is(Type::angle);
  const auto size = [&](const Value& v) { return out.of_angles ? v.as<Angle>().deg : v.number(); };
  out.first = size(first);
  out.last = size(last);
  if (range.step) {
    if (step.type() != first.type()) {
      context_.report<DiagnosticKind::range_ends_differ>(
          range.step->span, a_type_name(first.type()), a_type_name(step.type()));
      return Poison{};
    }
    out.step = size(step);
    out.has_step = true;
    if (out.step == 0) {
      context_.report<DiagnosticKind::range_step_zero>(range.step->span);
      return Poison{};
    }
  }
  return std::make_shared<const Interval>(out);
}

Value Evaluator::evaluate_member(const ast::Member& member, Scope& scope) {
  const Value object = evaluate(*member.object, scope);
  if (object.is_poison()) return Poison{};
  const std::string_view name = member.member.text;
  const auto index_in = [&](std::string_view letters) {
    return name.size() == 1 ? letters.find(name[0]) : std::string_view::npos;
  };
  const std::size_t axis = index_in("xyz"), channel = index_in("rgb");
  if (axis < 3) {
    const auto i = static_cast<int>(axis);
    if (object.is(Type::vec3)) return object.as<Vec3d>()[i];
    if (object.is(Type::angles)) return Angle{object.as<AngleVector>().deg[i]};
    if (object.is(Type::vec2) && axis < 2) {
      return axis == 0 ? object.as<Vec2d>().x : object.as<Vec2d>().y;
    }
  }
  if (channel < 3 && object.is(Type::color)) {
    const auto c = object.as<Rgbd>();
    return Vec3d{c.r, c.g, c.b}[static_cast<int>(channel)];
  }
  Diagnostic& d = context_.report<DiagnosticKind::no_such_member>(member.member.span,
                                                                  a_type_name(object.type()), name);
  if (object.is(Type::color)) d.hint("a colour has `.r`, `.g` and `.b`");
  if (object.is(Type::vec2)) d.hint("a vector of two has `.x` and `.y`");
  if (object.is(Type::vec3) || object.is(Type::angles)) d.hint("a vector has `.x`, `.y` and `.z`");
  return Poison{};
}

Value Evaluator::evaluate_index(const ast::Index& index, Scope& scope) {
  const Value object = evaluate(*index.object, scope), at = evaluate(*index.index, scope);
  if (object.is_poison() || at.is_poison()) return Poison{};
  const bool is_list = object.is(Type::list);
  if (!is_list && !object.is(Type::range)) {
    context_.report<DiagnosticKind::not_indexable>(index.object->span, a_type_name(object.type()));
    return Poison{};
  }
  const double count =
      is_list ? static_cast<double>(object.elements().size()) : object.as<IntervalPtr>()->count();
  const bool is_whole = at.is(Type::number) && at.number() == round_down(at.number());
  if (!is_whole || at.number() < 0 || at.number() >= count) {
    context_
        .report<DiagnosticKind::index_out_of_range>(index.index->span, number_text(count),
                                                    to_text(at, 40))
        .hint("the first has index 0");
    return Poison{};
  }
  if (is_list) return object.elements()[static_cast<std::size_t>(at.number())];
  return element_of(*object.as<IntervalPtr>(), at.number());
}

}  // namespace alhazen::parser

// parser/eval: `param` and `-D`.
#include <algorithm>
#include <fmt/format.h>

#include "core/base/near_name.h"
#include "parser/eval/block_builder.h"
#include "parser/eval/evaluator.h"
#include "parser/eval/schema/types.h"
#include "parser/parse/parse.h"

namespace alhazen::parser {
namespace {

constexpr TypeSet kParamTypes =
    kNumber | kAngle | kBool | kString | kVec2 | kVec3 | kAngles | kColor | kList;

// Between both ends of a range, the last one too where it is written `..`: a person who reads
// `in 1 .. 3` means 3 as well.
bool lies_in(const Value& value, const Value& allowed) {
  if (allowed.is(Type::list)) {
    const auto& choices = allowed.elements();
    return std::any_of(choices.begin(), choices.end(),
                       [&](const Value& choice) { return equal(choice, value); });
  }
  const Interval& range = *allowed.as<IntervalPtr>();
  const double size = value.is(Type::angle) ? value.as<Angle>().deg : value.number();
  return size >= range.first && size <= range.last;
}

}  // namespace

// The value of `define` in a text that shows it as it stands on the command line.
SourceSpan Evaluator::show_define(const Define& define) {
  const std::string start =
      define.option == Define::Option::frames ? "--frames " : "-D " + define.name + "=";
  const FileId id = context_.sources().add("command line", start + define.text);
  context_.set_folder(id, context_.root());
  const auto begin = static_cast<std::uint32_t>(start.size());
  return {id, begin, static_cast<std::uint32_t>(begin + define.text.size())};
}

// The value that `-D` gives this parameter, if one does: nothing after a report, too, so that the
// default stands in.
std::optional<Value> Evaluator::override_for(const ast::Param& param, const Value& default_value) {
  const Define* define = nullptr;
  for (const Define& candidate : context_.options().defines) {
    if (candidate.name == param.name.text) define = &candidate;  // the last one holds
  }
  if (define == nullptr) return std::nullopt;
  defines_used_.push_back(define->name);
  const SourceSpan whole = show_define(*define);
  context_.sink().set_trace({});
  const std::size_t errors_before = context_.sink().error_count();
  ast::WholeExpr expr =
      parse_expression(whole.file, whole.begin, context_.sources(), context_.sink());
  if (context_.sink().error_count() > errors_before) return std::nullopt;
  if (expr.root == nullptr) {
    context_.report<DiagnosticKind::define_not_expression>(whole, define->name);
    return std::nullopt;
  }
  // Only what is built in is visible: the value does not depend on where the parameter stands.
  define_values_.push_back(std::move(expr));
  // No value of an expression hands out a function that would hold on to it.
  Scope nothing(nullptr);
  const Value value = evaluate(*define_values_.back().root, nothing);
  if (value.is_poison()) return std::nullopt;
  if (value.type() != default_value.type()) {
    context_
        .report<DiagnosticKind::define_type>(whole, define->name, a_type_name(default_value.type()),
                                             a_type_name(value.type()))
        .label(param.value->span,
               fmt::format("the default is {}", a_type_name(default_value.type())));
    return std::nullopt;
  }
  return value;
}

void Evaluator::run_param(const ast::Param& param, const Body& body) {
  if (&body.scope != &root_) {
    context_.report<DiagnosticKind::param_not_at_top>(param.name.span, param.name.text);
    return;
  }
  const Value by_default = evaluate(*param.value, body.scope);
  Value range;
  if (param.range) range = evaluate(*param.range, body.scope);
  const Value text = param.text ? evaluate(*param.text, body.scope) : Value();
  if (by_default.is_poison() || (param.range && range.is_poison())) {
    define(param.name, Poison{}, body);
    return;
  }
  if ((kParamTypes & set_of(by_default.type())) == 0) {
    context_.report<DiagnosticKind::param_type>(param.value->span, a_type_name(by_default.type()));
    define(param.name, Poison{}, body);
    return;
  }
  if (param.range) {
    const bool fits =
        range.is(Type::list) ||
        (range.is(Type::range) && !range.as<IntervalPtr>()->has_step &&
         by_default.is(range.as<IntervalPtr>()->of_angles ? Type::angle : Type::number));
    if (!fits) {
      context_.report<DiagnosticKind::param_range>(param.range->span, param.name.text)
          .hint("write `in 0 .. 1`, with the type of the default, or a list of choices");
      define(param.name, Poison{}, body);
      return;
    }
    if (!lies_in(by_default, range)) {
      context_
          .report<DiagnosticKind::param_out_of_range>(param.value->span, param.name.text,
                                                      to_text(range, 80), to_text(by_default, 80))
          .label(param.range->span, "the range");
    }
  }
  Value value = by_default;
  if (auto overridden = override_for(param, by_default)) {
    value = *overridden;
    if (param.range && !lies_in(value, range)) {
      context_
          .report<DiagnosticKind::define_out_of_range>(define_values_.back().root->span,
                                                       param.name.text, to_text(range, 80),
                                                       to_text(value, 80))
          .label(param.range->span, "the range");
    }
  }
  if (!define(param.name, value, body)) return;
  out_.params.push_back({std::string(param.name.text), std::string(type_name(by_default.type())),
                         to_text(by_default), to_text(value), param.range ? to_text(range) : "",
                         text.is(Type::string) ? text.text() : "", param.name.span});
}

void Evaluator::report_unused_defines() {
  for (const Define& define : context_.options().defines) {
    if (std::find(defines_used_.begin(), defines_used_.end(), define.name) != defines_used_.end()) {
      continue;
    }
    const SourceSpan value = show_define(define);
    if (define.option == Define::Option::frames) {
      context_.report<DiagnosticKind::frames_without_param>(value).hint(
          "write `param frame = 1` and use `frame` in it");
      continue;
    }
    const auto end_of_name = value.begin - 1;
    const SourceSpan span{value.file, end_of_name - static_cast<std::uint32_t>(define.name.size()),
                          end_of_name};
    Diagnostic& d = context_.report<DiagnosticKind::unknown_define>(span, define.name);
    std::vector<std::string_view> names;
    for (const ParamInfo& param : out_.params)
      names.push_back(param.name);
    if (const auto meant = near_name(define.name, names)) {
      d.hint(fmt::format("did you mean `{}`?", *meant));
    } else if (names.empty()) {
      d.hint("the scene has no `param`");
    } else {
      d.hint(fmt::format("the scene has `{}`", fmt::join(names, "`, `")));
    }
  }
}

}  // namespace alhazen::parser

// parser/eval: expressions to values.
#include <fmt/format.h>

#include "core/base/near_name.h"
#include "core/base/overloaded.h"
#include "core/base/small_vector.h"
#include "parser/eval/evaluator.h"
#include "parser/eval/habits.h"
#include "parser/eval/operator.h"
#include "parser/eval/schema/schema.h"

namespace alhazen::parser {

namespace {

// One level of evaluations within each other, for as long as it lives.
class Deeper {
 public:
  explicit Deeper(int& depth) : depth_(depth) { ++depth_; }
  ~Deeper() { --depth_; }
  Deeper(const Deeper&) = delete;
  Deeper& operator=(const Deeper&) = delete;

 private:
  int& depth_;
};

}  // namespace

Value Evaluator::evaluate(const ast::Expr& expr, Scope& scope) {
  if (!context_.spend_fuel(1, expr.span)) return Poison{};
  // What a scene has most of; it was read as finite.
  if (const auto* number = std::get_if<ast::NumberLiteral>(&expr.node)) return number->value;
  if (nesting_ >= context_.limits().nesting) {
    context_.halt<DiagnosticKind::nested_too_deep>(expr.span, "evaluations",
                                                   context_.limits().nesting);
    return Poison{};
  }
  const Deeper deeper(nesting_);
  return evaluate_node(expr, scope);
}

Value Evaluator::evaluate_node(const ast::Expr& expr, Scope& scope) {
  // What loops are made of goes without the table of functions that std::visit asks.
  if (const auto* name = std::get_if<ast::NameRef>(&expr.node)) {
    return evaluate_name(expr, name->name, scope);
  }
  if (std::holds_alternative<ast::Binary>(expr.node)) return evaluate_chain(expr, scope);
  if (const auto* call = std::get_if<ast::Call>(&expr.node)) {
    return evaluate_call(expr, *call, scope);
  }
  return std::visit(
      Overloaded{[&](const ast::NumberLiteral& n) -> Value { return n.value; },
                 [&](const ast::AngleLiteral& a) {
                   const double deg = a.unit == ast::AngleUnit::deg
                                          ? a.value
                                          : a.value * 180 / alhazen::pi<double>();
                   return alhazen::is_finite(deg) ? Value(Angle{deg})
                                                  : report_not_finite(context_, expr.span);
                 },
                 [&](const ast::StringLiteral& s) {
                   return context_.make_text(std::string(s.value), expr.span);
                 },
                 [&](const ast::HexColor& c) -> Value {
                   return context_.from_srgb({c.red / 255.0, c.green / 255.0, c.blue / 255.0});
                 },
                 [&](const ast::BoolLiteral& b) -> Value { return b.value; },
                 [&](const ast::NameRef& n) { return evaluate_name(expr, n.name, scope); },
                 [&](const ast::VectorLiteral& v) { return evaluate_vector(v, scope); },
                 [&](const ast::ListLiteral& l) { return evaluate_list(expr, l, scope); },
                 [&](const ast::Parenthesized& p) { return evaluate(*p.inner, scope); },
                 [&](const ast::Unary& u) {
                   return apply_unary(context_, u.op, evaluate(*u.operand, scope), u.operand->span);
                 },
                 [&](const ast::Binary&) { return evaluate_chain(expr, scope); },
                 [&](const ast::Range& r) { return evaluate_range(r, scope); },
                 [&](const ast::Conditional& c) {
                   const auto holds = evaluate_condition(*c.condition, "`if`", scope);
                   if (!holds) return Value(Poison{});
                   return evaluate(*holds ? *c.then_value : *c.else_value, scope);
                 },
                 [&](const ast::Member& m) { return evaluate_member(m, scope); },
                 [&](const ast::Index& i) { return evaluate_index(i, scope); },
                 [&](const ast::Call& c) { return evaluate_call(expr, c, scope); },
                 [&](const ast::Block& b) { return evaluate_block(expr, b, scope); },
                 [&](const ast::ErrorExpr&) -> Value { return Poison{}; }},
      expr.node);
}

// What the author defined comes first: built-in names may be taken.
Value Evaluator::evaluate_name(const ast::Expr& expr, std::string_view name, Scope& scope) {
  const Word& word = words_[name];
  if (const Binding* binding = scope.find(word)) return binding->value;
  if (word.constant != nullptr) return word.constant->value;
  if (word.function != nullptr) return word.function;
  if (word.kind != nullptr && word.kind != &group_schema()) {
    context_.report<DiagnosticKind::kind_needs_body>(expr.span, name)
        .hint(fmt::format("for instance `{}`", word.kind->example));
    return Poison{};
  }
  Diagnostic& d = context_.report<DiagnosticKind::unknown_name>(expr.span, name);
  std::vector<std::string_view> candidates = scope.visible_names();
  for (const std::string_view builtin : builtin_names())
    candidates.push_back(builtin);
  for (const auto kinds : {material_schemas(), highlight_schemas(), shape_schemas()}) {
    for (const BlockSchema* kind : kinds)
      candidates.push_back(kind->name);
  }
  if (std::string hint = foreign_value_hint(name); !hint.empty()) {
    d.hint(std::move(hint));
  } else if (const auto meant = near_name(name, candidates)) {
    d.hint(fmt::format("did you mean `{}`?", *meant));
  }
  return Poison{};
}

// `<0, 30deg, 0>` is a vector of angles: a plain 0 needs no unit.
Value Evaluator::evaluate_vector(const ast::VectorLiteral& vector, Scope& scope) {
  const std::size_t count = vector.components.size();
  std::array<double, 3> numbers{};
  std::array<bool, 3> is_angle{};
  const ast::Expr* angle = nullptr;
  const ast::Expr* number = nullptr;  // the first that is not 0
  bool poisoned = false;
  for (std::size_t i = 0; i < count; ++i) {
    const ast::Expr& component = *vector.components[i];
    const Value value = evaluate(component, scope);
    if (value.is(Type::number)) {
      numbers[i] = value.number();
      if (value.number() != 0 && number == nullptr) number = &component;
    } else if (value.is(Type::angle)) {
      numbers[i] = value.as<Angle>().deg;
      is_angle[i] = true;
      if (angle == nullptr) angle = &component;
    } else {
      if (!value.is_poison()) {
        context_.report<DiagnosticKind::component_type>(component.span, a_type_name(value.type()));
      }
      poisoned = true;
    }
  }
  if (poisoned) return Poison{};
  if (angle != nullptr && number != nullptr) {
    context_.report<DiagnosticKind::mixed_components>(number->span)
        .label(angle->span, "this is an angle")
        .hint("angles carry a unit: `<0, 30deg, 0>`");
    return Poison{};
  }
  if (count == 2) {
    if (angle != nullptr) {
      context_.report<DiagnosticKind::component_type>(angle->span, "an angle");
      return Poison{};
    }
    return Vec2d{numbers[0], numbers[1]};
  }
  const Vec3d v{numbers[0], numbers[1], numbers[2]};
  return angle != nullptr ? Value(AngleVector{v}) : Value(v);
}

Value Evaluator::evaluate_list(const ast::Expr& expr, const ast::ListLiteral& list, Scope& scope) {
  std::vector<Value> elements;
  elements.reserve(list.elements.size());
  for (const ast::ExprPtr& element : list.elements)
    elements.push_back(evaluate(*element, scope));
  return context_.make_list(std::move(elements), expr.span);
}

// a + b + c + ... is deep to the left; a loop takes it without stack.
Value Evaluator::evaluate_chain(const ast::Expr& expr, Scope& scope) {
  SmallVector<const ast::Binary*, 8> chain;
  const ast::Expr* leftmost = &expr;
  while (const auto* binary = std::get_if<ast::Binary>(&leftmost->node)) {
    chain.push_back(binary);
    leftmost = binary->left;
  }
  if (!context_.spend_fuel(chain.size(), expr.span)) return Poison{};
  Value value = evaluate(*leftmost, scope);
  for (std::size_t i = chain.size(); i-- > 0;) {
    const ast::Binary& binary = *chain[i];
    const bool is_and = binary.op == ast::BinaryOperator::logical_and;
    if (!is_and && binary.op != ast::BinaryOperator::logical_or) {
      const Value right = evaluate(*binary.right, scope);
      value =
          apply_binary(context_, binary.op, value, binary.left->span, right, binary.right->span);
      continue;
    }
    const std::string_view word = is_and ? "`and`" : "`or`";
    if (value.is_poison()) continue;
    if (!value.is(Type::boolean)) {
      context_.report<DiagnosticKind::condition_not_bool>(binary.left->span, word,
                                                          a_type_name(value.type()));
      value = Poison{};
    } else if (value.as<bool>() == is_and) {
      const auto right = evaluate_condition(*binary.right, word, scope);
      value = right ? Value(*right) : Value(Poison{});
    }
  }
  return value;
}

std::optional<bool> Evaluator::evaluate_condition(const ast::Expr& expr, std::string_view what,
                                                  Scope& scope) {
  const Value value = evaluate(expr, scope);
  if (value.is(Type::boolean)) return value.as<bool>();
  if (!value.is_poison()) {
    context_.report<DiagnosticKind::condition_not_bool>(expr.span, what, a_type_name(value.type()));
  }
  return std::nullopt;
}

}  // namespace alhazen::parser

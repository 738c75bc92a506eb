// parser/eval: properties against their schema: unknown, repeated, missing, of a wrong kind.
#include "parser/eval/block_builder.h"

#include <algorithm>
#include <fmt/format.h>

#include "core/base/near_name.h"
#include "parser/eval/group_survey.h"
#include "parser/eval/habits.h"
#include "parser/eval/place.h"
#include "parser/eval/property_check.h"

namespace alhazen::parser {
namespace {

// Objects within objects are walked by recursion.
constexpr int kMaxObjectDepth = 500;
// A group of so few that adds nothing of its own is not kept as a group: its nodes are taken over.
// Functions that call themselves make one such group for each call.
constexpr std::size_t kMostSpliced = 32;

std::string example_hint(const BlockSchema& schema) {
  return fmt::format("for instance `{}`", schema.example);
}

std::vector<std::string_view> names_of(std::span<const BlockSchema* const> kinds) {
  std::vector<std::string_view> names;
  for (const BlockSchema* kind : kinds)
    names.push_back(kind->name);
  return names;
}

}  // namespace

bool BlockBuilder::is_defined(const ast::NameRef& name, const Scope& scope) {
  return scope.find(evaluator_.word(name.name)) != nullptr;
}

void BlockBuilder::take(const ast::Property& item, SourceSpan span, Scope& scope) {
  if (!first_) first_ = span;
  Word& name = evaluator_.word(item.name.text);
  if (const PropertySpec* spec = name.property_of(properties_.schema())) {
    take_property(*spec, item, span, scope);
  } else if (properties_.schema().places && name.placeable != Placeable::no) {
    auto node = evaluator_.place(item, name, span, scope);
    if (!node) {
      broken_ = true;
      return;
    }
    add(std::move(*node), span);
  } else {
    report_unknown(item.name, scope);
    broken_ = true;
  }
}

void BlockBuilder::take(const ast::Placement& item, SourceSpan span, Scope& scope) {
  if (!first_) first_ = span;
  const BlockSchema& schema = properties_.schema();
  const auto* block = std::get_if<ast::Block>(&item.object->node);
  const auto& call = std::get<ast::Call>((block != nullptr ? *block->head : *item.object).node);
  const auto* name = std::get_if<ast::NameRef>(&call.callee->node);
  const bool is_property = name != nullptr && !is_defined(*name, scope) &&
                           evaluator_.word(name->name).property_of(schema) != nullptr;
  if (is_property || !schema.places) {
    const SourceSpan at = call.callee->span;
    if (is_property) {
      evaluator_.context()
          .report<DiagnosticKind::property_called>(at, name->name)
          .hint(fmt::format("write `{} ...`, without parentheses or with a space before them",
                            name->name));
    } else {
      evaluator_.context().report<DiagnosticKind::cannot_place_here>(at, schema.name);
    }
    broken_ = true;
    return;
  }
  auto node = evaluator_.place_value(*item.object, span, scope);
  if (node) {
    add(std::move(*node), span);
  } else {
    broken_ = true;
  }
}

void BlockBuilder::add(Node&& node, SourceSpan span) {
  if (const auto inner = bare_group(node); inner && inner->children.size() <= kMostSpliced) {
    inner->children.for_each([&](const auto& content, const Placing& placing, MaterialId material) {
      push(Node{content, placing, material}, span);
      return !evaluator_.context().halted();
    });
  } else {
    push(std::move(node), span);
  }
}

void BlockBuilder::push(Node&& node, SourceSpan span) {
  if (const auto* inner = std::get_if<std::shared_ptr<const Group>>(&node.content)) {
    // A large group is kept once, however often it is placed here.
    const bool is_known =
        (*inner)->node_count >= kLeastShared && !counted_.insert(inner->get()).second;
    group_.node_count += is_known ? 1 : (*inner)->node_count;
    group_.depth = std::max(group_.depth, (*inner)->depth + 1);
  } else {
    ++group_.node_count;
  }
  const EvalLimits& limits = evaluator_.context().limits();
  if (group_.node_count > limits.shapes) {
    evaluator_.context().halt<DiagnosticKind::too_many_shapes>(span, limits.shapes);
  } else if (group_.depth > kMaxObjectDepth) {
    evaluator_.context().halt<DiagnosticKind::nested_too_deep>(span, "objects", kMaxObjectDepth);
  } else {
    group_.children.push_back(std::move(node));
  }
}

void BlockBuilder::take_property(const PropertySpec& spec, const ast::Property& item,
                                 SourceSpan span, Scope& scope) {
  const Property* earlier = properties_.find(spec);
  if (earlier != nullptr && spec.presence != Presence::repeatable) {
    evaluator_.context()
        .report<DiagnosticKind::repeated_property>(item.name.span, spec.name)
        .label(earlier->name_span, "first given here");
    broken_ = true;
    return;
  }
  Property property{&spec, Value(), nullptr, item.name.span, {}};
  if (!read(property, item, span, scope)) {
    broken_ = true;
    // Known to be there: a second one is still one too many, and it is not missing.
    property.value_span = item.name.span;
  }
  properties_.add(std::move(property));
}

bool BlockBuilder::read(Property& out, const ast::Property& item, SourceSpan span, Scope& scope) {
  const PropertySpec& spec = *out.spec;
  if (const auto* expr = std::get_if<ast::ExprPtr>(&item.value)) {
    return read_value(out, **expr, scope);
  }
  if (!spec.blocks.empty() && !spec.kind_named) {
    return read_block(out, *spec.blocks[0], item.name.span, span, std::get<ast::Body>(item.value),
                      scope);
  }
  Context& context = evaluator_.context();
  if (spec.blocks.empty()) {
    context.report<DiagnosticKind::property_takes_no_body>(item.name.span, spec.name,
                                                           describe(spec.types));
    return false;
  }
  context
      .report<DiagnosticKind::kind_missing>(item.name.span, spec.name,
                                            fmt::join(names_of(spec.blocks), "`, `"))
      .hint((spec.types & set_of(Type::color)) != 0
                ? fmt::format("one colour is written `{} rgb(0.3, 0.5, 0.8)`", spec.name)
                : example_hint(*spec.blocks[0]));
  return false;
}

bool BlockBuilder::read_value(Property& out, const ast::Expr& expr, Scope& scope) {
  const PropertySpec& spec = *out.spec;
  Context& context = evaluator_.context();
  const auto* name = std::get_if<ast::NameRef>(&expr.node);
  const auto is_word = [&] {
    return std::find(spec.words.begin(), spec.words.end(), name->name) != spec.words.end();
  };
  Value value;
  if (name != nullptr && !spec.words.empty() && (is_word() || !is_defined(*name, scope))) {
    value = context.make_text(std::string(name->name), expr.span);
  } else {
    if (!spec.blocks.empty()) {
      const auto* block = std::get_if<ast::Block>(&expr.node);
      const bool is_kind =
          block != nullptr && std::holds_alternative<ast::NameRef>(block->head->node);
      const bool is_bare_kind = name != nullptr && !is_defined(*name, scope);
      if (is_kind || is_bare_kind || spec.types == 0) return read_kind(out, expr, scope);
    }
    value = evaluator_.evaluate(expr, scope);
  }
  if (value.is_poison() || !check_property(context, spec, value, expr.span)) return false;
  out.value = std::move(value);
  out.value_span = expr.span;
  return true;
}

bool BlockBuilder::read_kind(Property& out, const ast::Expr& expr, Scope& scope) {
  const PropertySpec& spec = *out.spec;
  Context& context = evaluator_.context();
  const auto* block = std::get_if<ast::Block>(&expr.node);
  const ast::Expr& head = block != nullptr ? *block->head : expr;
  const auto* name = std::get_if<ast::NameRef>(&head.node);
  const BlockSchema* kind = name != nullptr ? find_schema(spec.blocks, name->name) : nullptr;
  if (kind != nullptr && block != nullptr) {
    return read_block(out, *kind, head.span, expr.span, block->body, scope);
  }
  if (kind != nullptr) {
    context.report<DiagnosticKind::kind_needs_body>(expr.span, kind->name)
        .hint(example_hint(*kind));
    return false;
  }
  if (!spec.kind_named) {
    context.report<DiagnosticKind::kind_needs_body>(expr.span, spec.name)
        .hint(example_hint(*spec.blocks[0]));
    return false;
  }
  Diagnostic& d = context.report<DiagnosticKind::unknown_kind>(
      head.span, spec.name, fmt::join(names_of(spec.blocks), "`, `"));
  if (name != nullptr) {
    if (const auto meant = near_name(name->name, names_of(spec.blocks))) {
      d.hint(fmt::format("did you mean `{}`?", *meant));
    }
  }
  d.hint(example_hint(*spec.blocks[0]));
  return false;
}

bool BlockBuilder::read_block(Property& out, const BlockSchema& kind, SourceSpan head,
                              SourceSpan span, const ast::Body& body, Scope& scope) {
  BlockBuilder inner(evaluator_, kind, head);
  evaluator_.fill(inner, body, scope);
  Properties* properties = inner.finish();
  if (properties == nullptr) return false;
  out.block = std::make_shared<const Properties>(std::move(*properties));
  out.value_span = span;
  return true;
}

void BlockBuilder::report_unknown(const ast::Name& name, Scope& scope) {
  const BlockSchema& schema = properties_.schema();
  Diagnostic& d = evaluator_.context().report<DiagnosticKind::unknown_property>(
      name.span, schema.name, name.text);
  std::vector<std::string_view> candidates = schema.property_names();
  if (schema.places) {
    const auto shapes = names_of(shape_schemas());
    candidates.insert(candidates.end(), shapes.begin(), shapes.end());
    candidates.insert(candidates.end(), {"group", "object", "light"});
  }
  const Binding* binding = scope.find(evaluator_.word(name.text));
  std::string habit;
  if (schema.places) habit = foreign_item_hint(name.text);
  if (habit.empty() && schema.find("material") != nullptr) habit = foreign_material_hint(name.text);
  if (binding == nullptr && !habit.empty()) {
    d.hint(std::move(habit));
  } else if (const auto meant = near_name(name.text, candidates)) {
    d.hint(fmt::format("did you mean `{}`?", *meant));
  } else if (schema.places && binding != nullptr &&
             (binding->value.is(Type::function) || binding->value.is(Type::object))) {
    d.hint(binding->value.is(Type::function)
               ? fmt::format("to place it write `{}(...)`", name.text)
               : fmt::format("to place it write `object {}`", name.text));
  } else if (schema.places && find_schema(material_schemas(), name.text) != nullptr) {
    d.hint(fmt::format("a material belongs to something: `material {} {{ ... }}`", name.text));
  } else if (!schema.places) {
    d.hint(fmt::format("`{}` has `{}`", schema.name, fmt::join(schema.property_names(), "`, `")));
  }
}

Properties* BlockBuilder::finish() {
  if (evaluator_.context().halted()) return nullptr;
  for (const auto& table : properties_.schema().tables) {
    for (const PropertySpec& spec : table) {
      if (spec.presence != Presence::required || properties_.find(spec) != nullptr) continue;
      if (&properties_.schema() == &scene_schema()) {
        evaluator_.context()
            .report<DiagnosticKind::missing_camera>(properties_.head(), spec.name)
            .hint(example_hint(*spec.blocks[0]));
        broken_ = true;
        continue;
      }
      evaluator_.context()
          .report<DiagnosticKind::missing_property>(properties_.head(), properties_.schema().name,
                                                    spec.name)
          .hint(spec.blocks.empty() ? fmt::format("`{}` is {}", spec.name, spec.doc)
                                    : example_hint(*spec.blocks[0]));
      broken_ = true;
    }
  }
  return broken_ ? nullptr : &properties_;
}

std::shared_ptr<const Group> BlockBuilder::finish_group() {
  return std::make_shared<const Group>(std::move(group_));
}

}  // namespace alhazen::parser

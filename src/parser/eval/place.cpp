// parser/eval: shapes, groups, objects and lights where they stand as items.
#include "parser/eval/place.h"

#include <fmt/format.h>

#include "parser/eval/lower.h"

namespace alhazen::parser {
namespace {

// Transform, material and name of a block that places something.
bool lower_placing(Context& context, const Properties& p, Node& node) {
  const auto map = lower_transform(context, p);
  if (!map) return false;
  if (!(*map == Affined())) node.placing.parent_from_child = *map;
  if (const Property* material = p.find("material")) {
    node.material = material->value.as<MaterialRef>().id;
  }
  if (const Property* name = p.find("name")) node.placing.name = name->value.text();
  return true;
}

}  // namespace

std::shared_ptr<const Group> bare_group(const Node& node) {
  const auto* group = std::get_if<std::shared_ptr<const Group>>(&node.content);
  const bool adds_nothing =
      !node.placing.parent_from_child && node.placing.name.empty() && node.material == kNoId;
  return group != nullptr && adds_nothing ? *group : nullptr;
}

std::optional<Node> make_shape(Evaluator& evaluator, const Properties& properties,
                               SourceSpan span) {
  const auto geometry = lower_shape(evaluator.context(), properties);
  if (!geometry) return std::nullopt;
  Node node{*geometry, {std::nullopt, "", span}};
  if (!lower_placing(evaluator.context(), properties, node)) return std::nullopt;
  return node;
}

std::optional<Node> make_group(Evaluator& evaluator, BlockBuilder& builder, SourceSpan span) {
  return make_placed(evaluator, builder, nullptr, span);
}

std::optional<Node> make_placed(Evaluator& evaluator, BlockBuilder& builder,
                                std::shared_ptr<const Group> group, SourceSpan span) {
  const Properties* properties = builder.finish();
  if (!properties) return std::nullopt;
  if (group == nullptr) group = builder.finish_group();
  Node node{std::move(group), {std::nullopt, "", span}};
  if (!lower_placing(evaluator.context(), *properties, node)) return std::nullopt;
  return node;
}

Object object_of(Node node) {
  if (auto inner = bare_group(node)) return Object{std::move(inner)};
  auto group = std::make_shared<Group>();
  group->node_count = 2;
  group->depth = 1;
  if (const auto* inner = std::get_if<std::shared_ptr<const Group>>(&node.content)) {
    group->node_count = (*inner)->node_count + 1;
    group->depth = (*inner)->depth + 1;
  }
  group->children.push_back(std::move(node));
  return Object{std::move(group)};
}

std::optional<Node> Evaluator::place(const ast::Property& item, const Word& name, SourceSpan span,
                                     Scope& scope) {
  if (name.placeable == Placeable::object) return place_object(item, span, scope);
  if (name.placeable == Placeable::light) return place_light(item, span, scope);
  const bool is_group = name.placeable == Placeable::group;
  const BlockSchema& schema = is_group ? group_schema() : *name.shape;
  const auto* body = std::get_if<ast::Body>(&item.value);
  if (body == nullptr) {
    context_
        .report<DiagnosticKind::kind_needs_body>(std::get<ast::ExprPtr>(item.value)->span,
                                                 item.name.text)
        .hint(fmt::format("for instance `{}`", schema.example));
    return std::nullopt;
  }
  BlockBuilder builder(*this, schema, item.name.span);
  fill(builder, *body, scope);
  if (is_group) return make_group(*this, builder, span);
  const Properties* properties = builder.finish();
  if (!properties) return std::nullopt;
  return make_shape(*this, *properties, span);
}

std::optional<Node> Evaluator::place_object(const ast::Property& item, SourceSpan span,
                                            Scope& scope) {
  if (!std::holds_alternative<ast::ExprPtr>(item.value)) {
    context_.report<DiagnosticKind::object_needs_value>(item.name.span)
        .hint("several things as one are a `group { ... }`");
    return std::nullopt;
  }
  return place_value(*std::get<ast::ExprPtr>(item.value), span, scope);
}

std::optional<Node> Evaluator::place_value(const ast::Expr& expr, SourceSpan span, Scope& scope) {
  const Value value = evaluate(expr, scope);
  if (value.is_poison()) return std::nullopt;
  if (!value.is(Type::object)) {
    Diagnostic& d =
        context_.report<DiagnosticKind::not_an_object>(expr.span, a_type_name(value.type()));
    if (value.is(Type::function)) d.hint("call it: `name(...)`");
    return std::nullopt;
  }
  return Node{value.as<Object>().group, {std::nullopt, "", span}};
}

std::optional<Node> Evaluator::place_light(const ast::Property& item, SourceSpan span,
                                           Scope& scope) {
  // Read as a property that takes the kinds of lights.
  static const PropertySpec kLight = {
      .name = "light", .blocks = light_schemas(), .doc = "a light of some kind"};
  static const BlockSchema kHolder = {.name = "light", .tables = {std::span(&kLight, 1)}};
  BlockBuilder builder(*this, kHolder, item.name.span);
  builder.take(item, span, scope);
  const Properties* holder = builder.finish();
  if (!holder) return std::nullopt;
  const Properties& properties = *holder->find("light")->block;
  const auto light = lower_light(context_, properties);
  if (!light) return std::nullopt;
  Node node{*light, {std::nullopt, "", span}};
  const auto map = lower_transform(context_, properties);
  if (!map) return std::nullopt;
  if (!(*map == Affined())) node.placing.parent_from_child = *map;
  node.placing.name = properties.text_or_empty("name");
  return node;
}

}  // namespace alhazen::parser

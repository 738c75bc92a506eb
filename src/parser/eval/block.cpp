// parser/eval: `head { ... }` as an expression: a new material, highlight or object, or a variation
// of a value.
#include <fmt/format.h>

#include "parser/eval/block_builder.h"
#include "parser/eval/evaluator.h"
#include "parser/eval/lower.h"
#include "parser/eval/place.h"

namespace alhazen::parser {
namespace {

// A block whose head is the name of a kind.
Value make_new(Evaluator& evaluator, const ast::Expr& expr, const ast::Block& block,
               const BlockSchema& schema, Scope& scope) {
  BlockBuilder builder(evaluator, schema, block.head->span);
  evaluator.fill(builder, block.body, scope);
  if (&schema == &group_schema()) {
    auto node = make_group(evaluator, builder, expr.span);
    return node ? Value(object_of(std::move(*node))) : Value(Poison{});
  }
  const Properties* properties = builder.finish();
  if (!properties) return Poison{};
  if (find_schema(material_schemas(), schema.name) == &schema) {
    const auto id = lower_material(evaluator.context(), *properties, nullptr);
    return id ? Value(MaterialRef{*id}) : Value(Poison{});
  }
  if (find_schema(highlight_schemas(), schema.name) == &schema) {
    return HighlightPtr{std::make_shared<const Highlight>(lower_highlight(*properties))};
  }
  auto node = make_shape(evaluator, *properties, expr.span);
  return node ? Value(object_of(std::move(*node))) : Value(Poison{});
}

Value vary_material(Evaluator& evaluator, MaterialId id, const ast::Block& block, Scope& scope) {
  const Material base = evaluator.context().store().material(id);
  BlockBuilder builder(evaluator, schema_of(base), block.head->span);
  evaluator.fill(builder, block.body, scope);
  const Properties* properties = builder.finish();
  if (!properties) return Poison{};
  const auto varied = lower_material(evaluator.context(), *properties, &base);
  return varied ? Value(MaterialRef{*varied}) : Value(Poison{});
}

Value vary_texture(Evaluator& evaluator, TextureId id, const ast::Block& block, Scope& scope) {
  BlockBuilder builder(evaluator, schema_of(evaluator.context().store().texture(id)),
                       block.head->span);
  evaluator.fill(builder, block.body, scope);
  const Properties* properties = builder.finish();
  if (!properties) return Poison{};
  const auto varied = lower_texture(evaluator.context(), *properties, id);
  return varied ? Value(TextureRef{*varied}) : Value(Poison{});
}

// An object moved, named or given a material: the same group at another place.
Value vary_object(Evaluator& evaluator, const Object& object, const ast::Expr& expr,
                  const ast::Block& block, Scope& scope) {
  BlockBuilder builder(evaluator, object_schema(), block.head->span);
  evaluator.fill(builder, block.body, scope);
  auto node = make_placed(evaluator, builder, object.group, expr.span);
  return node ? Value(object_of(std::move(*node))) : Value(Poison{});
}

}  // namespace

void Evaluator::fill(BlockBuilder& builder, const ast::Body& body, Scope& scope) {
  if (nesting_ >= context_.limits().nesting) {
    context_.halt<DiagnosticKind::nested_too_deep>(body.span, "evaluations",
                                                   context_.limits().nesting);
    return;
  }
  ++nesting_;
  const ScopeLease inside(scopes_, scope);
  run(body.items, {*inside, builder, nullptr});
  --nesting_;
}

Value Evaluator::evaluate_block(const ast::Expr& expr, const ast::Block& block, Scope& scope) {
  if (const auto* name = std::get_if<ast::NameRef>(&block.head->node)) {
    const Word& word = words_[name->name];
    if (word.kind != nullptr && scope.find(word) == nullptr) {
      return make_new(*this, expr, block, *word.kind, scope);
    }
  }
  const Value head = evaluate(*block.head, scope);
  switch (head.type()) {
    case Type::poison:
      return Poison{};
    case Type::material:
      return vary_material(*this, head.as<MaterialRef>().id, block, scope);
    case Type::texture:
      return vary_texture(*this, head.as<TextureRef>().id, block, scope);
    case Type::object:
      return vary_object(*this, head.as<Object>(), expr, block, scope);
    default: {
      Diagnostic& d = context_.report<DiagnosticKind::takes_no_body>(block.head->span,
                                                                     a_type_name(head.type()));
      if (head.is(Type::builtin)) {
        d.hint(fmt::format("call it first: `{} {{ ... }}`",
                           signature(*head.as<const BuiltinFunction*>())));
      }
      if (head.is(Type::function)) d.hint("call it first: `name(...) { ... }`");
      return Poison{};
    }
  }
}

}  // namespace alhazen::parser

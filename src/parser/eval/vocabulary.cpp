#include "parser/eval/vocabulary.h"

namespace alhazen::parser {
namespace {

const BlockSchema* kind_of(std::string_view name) {
  if (name == "group") return &group_schema();
  for (const auto kinds : {material_schemas(), highlight_schemas(), shape_schemas()}) {
    if (const BlockSchema* kind = find_schema(kinds, name)) return kind;
  }
  return nullptr;
}

Placeable placeable_of(std::string_view name, const BlockSchema* shape) {
  if (shape != nullptr) return Placeable::shape;
  if (name == "group") return Placeable::group;
  if (name == "object") return Placeable::object;
  return name == "light" ? Placeable::light : Placeable::no;
}

}  // namespace

Word::Word(std::string_view spelling)
    : text(spelling),
      constant(find_constant(spelling)),
      function(find_builtin(spelling)),
      kind(kind_of(spelling)),
      shape(find_schema(shape_schemas(), spelling)),
      placeable(placeable_of(spelling, shape)) {}

Word& Vocabulary::look_up(std::string_view name) {
  return words_.try_emplace(name, name).first->second;
}

}  // namespace alhazen::parser

// parser/eval: transforms in the order written.
#include "parser/eval/lower.h"

namespace alhazen::parser {
namespace {

Affined euler(Vec3d deg) {
  return rotation({0, 0, 1}, deg.z) * rotation({0, 1, 0}, deg.y) * rotation({1, 0, 0}, deg.x);
}

// Three rows of four numbers, or nothing.
std::optional<Affined> matrix_of(const Value& value) {
  if (value.is(Type::transform)) return *value.as<TransformPtr>().matrix;
  const auto& rows = value.elements();
  if (rows.size() != 3) return std::nullopt;
  Affined map;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!rows[i].is(Type::list) || rows[i].elements().size() != 4) return std::nullopt;
    for (std::size_t j = 0; j < 4; ++j) {
      const Value& entry = rows[i].elements()[j];
      if (!entry.is(Type::number)) return std::nullopt;
      map.rows[i][j] = entry.number();
    }
  }
  return map;
}

std::optional<Affined> one_transform(Context& context, const Property& property) {
  const std::string_view name = property.spec->name;
  const Value& value = property.value;
  if (name == "translate") return translation(value.as<Vec3d>());
  if (name == "scale") {
    return scaling(value.is(Type::number) ? Vec3d{value.number(), value.number(), value.number()}
                                          : value.as<Vec3d>());
  }
  if (name == "rotate" && value.is(Type::angles)) return euler(value.as<AngleVector>().deg);
  const auto map = matrix_of(value);
  if (!map) {
    context.report<DiagnosticKind::bad_matrix>(property.value_span)
        .hint("the identity is `[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]`");
  }
  return map;
}

}  // namespace

std::optional<Affined> lower_transform(Context& context, const Properties& properties) {
  Affined whole;
  for (const Property& property : properties.written()) {
    if (property.spec->presence != Presence::repeatable) continue;
    const auto map = one_transform(context, property);
    if (!map) return std::nullopt;
    whole = *map * whole;
    if (!inverse(*map) || !inverse(whole)) {
      context.report<DiagnosticKind::singular_transform>(property.value_span, property.spec->name)
          .hint("no factor may be 0, and none so large or small that numbers do not hold it");
      return std::nullopt;
    }
  }
  return whole;
}

}  // namespace alhazen::parser

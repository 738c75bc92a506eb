// parser/eval: POV-Ray's surface model.
#include <fmt/format.h>

#include "parser/eval/lower.h"

namespace alhazen::parser {
namespace {

PovReflection reflection(const Property& property) {
  if (property.block != nullptr) {
    const Properties& p = *property.block;
    return {p.color("min"), p.color("max"), p.number("falloff"), p.boolean("fresnel"),
            p.number("metallic")};
  }
  PovReflection even;
  even.min = even.max =
      property.value.is(Type::number) ? Rgbd(property.value.number()) : property.value.as<Rgbd>();
  return even;
}

// What is written but cannot do anything without `other`.
bool report_lonely(Context& context, const Properties& p, std::string_view name,
                   std::string_view other) {
  const Property* property = p.find(name);
  const SourceSpan at = property != nullptr ? property->name_span : p.head();
  context.report<DiagnosticKind::needs_other_property>(at, name, other)
      .hint(fmt::format("write `{}` too, above 0, or leave `{}` out", other, name));
  return false;
}

bool check_fade(Context& context, const Properties& p, const PovFinish& m) {
  if (fades(m)) return true;
  if (m.fade_power > 0) return report_lonely(context, p, "fade_power", "fade_distance");
  if (m.fade_distance > 0) return report_lonely(context, p, "fade_distance", "fade_power");
  if (!is_black(m.fade_color)) return report_lonely(context, p, "fade_color", "fade_distance");
  return true;
}

bool check_transparency(Context& context, const Properties& p, const PovFinish& m) {
  if (opacity(m) >= 0) return true;
  const bool has_filter = p.has("filter");
  Diagnostic& d = context.report<DiagnosticKind::too_transparent>(
      p.span(has_filter ? "filter" : "transmit"), number_text(m.filter + m.transmit));
  if (has_filter && p.has("transmit")) d.label(p.span("transmit"), "with this");
  d.hint("make `filter` or `transmit` less");
  return false;
}

}  // namespace

std::optional<PovFinish> lower_pov_finish(Context& context, const Properties& p, TextureId color,
                                          const PovFinish* base) {
  PovFinish out = base != nullptr ? *base : PovFinish{};
  out.color = color;
  const auto given = [&](std::string_view name) { return base == nullptr || p.has(name); };
  const auto number = [&](std::string_view name, double& field) {
    if (given(name)) field = p.number(name);
  };
  number("filter", out.filter);
  number("transmit", out.transmit);
  number("diffuse", out.diffuse);
  number("brilliance", out.brilliance);
  number("phong", out.phong);
  number("phong_size", out.phong_size);
  number("specular", out.specular);
  number("roughness", out.roughness);
  number("metallic", out.metallic);
  number("ior", out.ior);
  number("fade_distance", out.fade_distance);
  number("fade_power", out.fade_power);
  if (given("ambient")) out.ambient = p.color("ambient");
  if (given("emission")) out.emission = p.color("emission");
  if (given("conserve_energy")) out.conserve_energy = p.boolean("conserve_energy");
  if (given("fade_color")) out.fade_color = p.color("fade_color");
  if (const Property* property = p.find("reflection")) out.reflection = reflection(*property);
  const bool sound = check_transparency(context, p, out) && check_fade(context, p, out);
  return sound ? std::optional(out) : std::nullopt;
}

}  // namespace alhazen::parser

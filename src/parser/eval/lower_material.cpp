// parser/eval: materials and highlights. No more light leaves a surface than reaches it.
#include <fmt/format.h>

#include "core/base/overloaded.h"
#include "core/base/same_name.h"
#include "parser/eval/lower.h"
#include "parser/eval/metal_presets.h"
#include "parser/eval/texture_value.h"

namespace alhazen::parser {
namespace {

using Lowered = std::optional<Scattering>;

// The property's texture, or what `base` has, or the default.
TextureId texture_or(Context& context, const Properties& p, const TextureId* base) {
  if (const Property* color = p.find("color")) {
    return texture_of(context, color->value, color->value_span);
  }
  return base != nullptr ? *base : texture_of(context, p.color("color"), p.head());
}

Lowered diffuse(Context& context, const Properties& p, const Diffuse* base) {
  Diffuse out;
  out.albedo = texture_or(context, p, base != nullptr ? &base->albedo : nullptr);
  if (base != nullptr) out.highlight = base->highlight;
  const Property* highlight = p.find("highlight");
  if (highlight != nullptr) out.highlight = *highlight->value.as<HighlightPtr>().highlight;
  const Rgbd most = context.store().largest(out.albedo) + out.highlight.strength;
  if (!is_black(out.highlight.strength) && largest_channel(most) > 1) {
    Diagnostic& d = context.report<DiagnosticKind::too_reflective>(
        highlight != nullptr ? highlight->value_span : p.span("color"), to_text(most));
    if (p.has("color") && highlight != nullptr) d.label(p.span("color"), "with this colour");
    d.hint("make `color` or `strength` less, so that their sum is at most 1 in each channel");
    return std::nullopt;
  }
  return out;
}

Lowered mirror(Context& context, const Properties& p, const Mirror* base) {
  return Mirror{texture_or(context, p, base != nullptr ? &base->reflectance : nullptr)};
}

Lowered metal(Context& context, const Properties& p, const Metal* base) {
  if (p.has("preset") && (p.has("n") || p.has("k"))) {
    const std::string_view other = p.has("n") ? "n" : "k";
    context
        .report<DiagnosticKind::one_or_the_other>(p.find(other)->name_span, "metal", "preset",
                                                  other)
        .label(p.find("preset")->name_span, "`preset` is here");
    return std::nullopt;
  }
  if (p.has("preset")) return *metal_preset(p.word("preset"));
  if (base == nullptr && !(p.has("n") && p.has("k"))) {
    context.report<DiagnosticKind::metal_incomplete>(p.head()).hint(
        "write `preset gold` or the like, or both `n` and `k`");
    return std::nullopt;
  }
  return Metal{p.has("n") ? p.color("n") : base->n, p.has("k") ? p.color("k") : base->k};
}

Lowered glass(Context&, const Properties& p, const Glass* base) {
  Glass out = base != nullptr ? *base : Glass{};
  if (base == nullptr || p.has("ior")) out.ior = p.number("ior");
  if (base == nullptr || p.has("absorption")) out.absorption = p.color("absorption");
  if (base == nullptr || p.has("priority")) out.priority = static_cast<int>(p.number("priority"));
  return out;
}

Lowered coat(Context& context, const Properties& p, const Coat* base) {
  Coat out = base != nullptr ? *base : Coat{};
  out.base_albedo = texture_or(context, p, base != nullptr ? &base->base_albedo : nullptr);
  if (base == nullptr || p.has("ior")) out.ior = p.number("ior");
  if (base == nullptr || p.has("absorption")) out.absorption = p.color("absorption");
  return out;
}

Lowered pov_finish(Context& context, const Properties& p, const PovFinish* base) {
  const TextureId color = texture_or(context, p, base != nullptr ? &base->color : nullptr);
  return lower_pov_finish(context, p, color, base);
}

template <class Kind>
const Kind* part_of(const Material* base) {
  return base != nullptr ? std::get_if<Kind>(&base->scattering) : nullptr;
}

Lowered scattering(Context& context, const Properties& p, const Material* base) {
  const auto is = [name = p.schema().name](std::string_view kind) { return same_name(name, kind); };
  if (is("diffuse")) return diffuse(context, p, part_of<Diffuse>(base));
  if (is("mirror")) return mirror(context, p, part_of<Mirror>(base));
  if (is("metal")) return metal(context, p, part_of<Metal>(base));
  if (is("glass")) return glass(context, p, part_of<Glass>(base));
  if (is("coat")) return coat(context, p, part_of<Coat>(base));
  if (is("pov_finish")) return pov_finish(context, p, part_of<PovFinish>(base));
  return Black{};
}

}  // namespace

std::optional<MaterialId> lower_material(Context& context, const Properties& properties,
                                         const Material* base) {
  const auto scatters = scattering(context, properties, base);
  if (!scatters) return std::nullopt;
  Material out{*scatters, {}, false, "", properties.head()};
  // POV-Ray's emission depends on the colour: it is part of the finish.
  if (std::holds_alternative<PovFinish>(*scatters)) return context.add(std::move(out));
  // What glows says so by its colour, all others by `emission`.
  const bool glows = properties.schema().name == "glow";
  const std::string_view emission = glows ? "color" : "emission";
  out.emission =
      base != nullptr && !properties.has(emission) ? base->emission : properties.color(emission);
  return context.add(std::move(out));
}

const BlockSchema& schema_of(const Material& material) {
  const std::string_view name = std::visit(
      Overloaded{[](const Diffuse&) { return "diffuse"; }, [](const Mirror&) { return "mirror"; },
                 [](const Metal&) { return "metal"; }, [](const Glass&) { return "glass"; },
                 [](const Coat&) { return "coat"; }, [](const Black&) { return "glow"; },
                 [](const PovFinish&) { return "pov_finish"; }},
      material.scattering);
  return *find_schema(material_schemas(), name);
}

Highlight lower_highlight(const Properties& properties) {
  const bool is_phong = properties.schema().name == "phong";
  return {is_phong ? HighlightModel::phong : HighlightModel::blinn, properties.color("strength"),
          properties.number("exponent")};
}

}  // namespace alhazen::parser

// parser/eval: lights.
#include <algorithm>
#include <fmt/format.h>

#include "core/base/overloaded.h"
#include "parser/eval/direction.h"
#include "parser/eval/lower.h"

namespace alhazen::parser {
namespace {

using Lowered = std::optional<LightSource>;

Falloff falloff_of(const Properties& p) {
  return p.word("falloff") == "none" ? Falloff::none : Falloff::inverse_square;
}

Lowered spot(Context& context, const Properties& p) {
  const Vec3d position = p.vec3("position"), target = p.vec3("look_at");
  if (position == target) {
    context.report<DiagnosticKind::same_point>(p.span("look_at"), "light", "look_at", "position")
        .label(p.span("position"), "`position` is here");
    return std::nullopt;
  }
  const double inner = p.angle_deg("inner_angle"), outer = p.angle_deg("outer_angle");
  if (inner > outer) {
    const bool at_outer = p.has("outer_angle");
    context
        .report<DiagnosticKind::spot_angles>(p.span(at_outer ? "outer_angle" : "inner_angle"),
                                             number_text(inner), number_text(outer))
        .hint("the light fades from `inner_angle` to `outer_angle`");
    return std::nullopt;
  }
  return SpotLight{
      position,     unit_direction(target - position), p.color("intensity"), inner, outer,
      falloff_of(p)};
}

Lowered rectangle(Context& context, const Properties& p) {
  const Vec3d u = p.vec3("edge_u"), v = p.vec3("edge_v");
  if (is_parallel(u, v)) {
    context.report<DiagnosticKind::no_area>(p.span("edge_v"), "rectangle")
        .label(p.span("edge_u"), "this edge has the same direction");
    return std::nullopt;
  }
  return RectangleLight{p.vec3("corner"), u, v, p.color("radiance"),
                        static_cast<int>(p.number("samples"))};
}

Lowered lower_source(Context& context, const Properties& p) {
  const std::string_view name = p.schema().name;
  if (name == "point") return PointLight{p.vec3("position"), p.color("intensity"), falloff_of(p)};
  if (name == "directional") {
    return DirectionalLight{unit_direction(p.vec3("direction")), p.color("irradiance")};
  }
  if (name == "spot") return spot(context, p);
  if (name == "sphere") {
    return SphereLight{p.vec3("center"), p.number("radius"), p.color("radiance"),
                       static_cast<int>(p.number("samples"))};
  }
  if (name == "rectangle") return rectangle(context, p);
  return AmbientLight{p.color("radiance")};
}

// The factor by which a map stretches all lengths, if it is the same in all directions: its columns
// are orthogonal and of one length, to the rounding of a few products of rotations.
std::optional<double> uniform_scale(const Affined& map) {
  const Vec3d c[] = {map.vector({1, 0, 0}), map.vector({0, 1, 0}), map.vector({0, 0, 1})};
  const double size = std::max({length(c[0]), length(c[1]), length(c[2])});
  const double bound = 64 * ScalarTraits<double>::unit_roundoff() * size;
  for (int i = 0; i < 3; ++i) {
    if (absolute(length(c[i]) - size) > bound) return std::nullopt;
    if (absolute(dot(c[i] / size, c[(i + 1) % 3])) > bound) return std::nullopt;
  }
  return size;
}

}  // namespace

std::optional<PlacedLight> lower_light(Context& context, const Properties& properties) {
  const auto source = lower_source(context, properties);
  if (!source) return std::nullopt;
  PlacedLight out{*source, true, false};
  if (properties.schema().find("shadows") != nullptr) {
    out.casts_shadows = properties.boolean("shadows");
  }
  if (properties.schema().find("visible") != nullptr) out.visible = properties.boolean("visible");
  return out;
}

std::optional<LightSource> transformed(Context& context, const LightSource& source,
                                       const Affined& map, SourceSpan span) {
  return std::visit(
      Overloaded{[&](PointLight light) -> Lowered {
                   light.position = map.point(light.position);
                   return light;
                 },
                 [&](DirectionalLight light) -> Lowered {
                   light.direction = unit_direction(map.vector(light.direction));
                   return light;
                 },
                 [&](SpotLight light) -> Lowered {
                   light.position = map.point(light.position);
                   light.axis = unit_direction(map.vector(light.axis));
                   return light;
                 },
                 [&](SphereLight light) -> Lowered {
                   const auto factor = uniform_scale(map);
                   if (!factor) {
                     context.report<DiagnosticKind::light_not_round>(span).hint(
                         "scale it by the same factor along all axes, or move it out of the group");
                     return std::nullopt;
                   }
                   light.center = map.point(light.center);
                   light.radius *= *factor;
                   return light;
                 },
                 [&](RectangleLight light) -> Lowered {
                   light.corner = map.point(light.corner);
                   light.edge_u = map.vector(light.edge_u);
                   light.edge_v = map.vector(light.edge_v);
                   // A reflection turns cross(u, v) around; exchanging the edges turns it back, so
                   // that the light shines to the side that the mirrored picture of it shines to.
                   if (determinant(map) < 0) std::swap(light.edge_u, light.edge_v);
                   return light;
                 },
                 [&](const AmbientLight& light) -> Lowered { return light; }},
      source);
}

}  // namespace alhazen::parser

// parser/eval: shapes, and what makes one degenerate.
#include <fmt/format.h>

#include "core/base/same_name.h"
#include "parser/eval/direction.h"
#include "parser/eval/lower.h"

namespace alhazen::parser {
namespace {

using Lowered = std::optional<Geometry>;

Lowered sphere(Context&, const Properties& p) {
  return Sphere{p.vec3("center"), p.number("radius")};
}

Lowered plane(Context& context, const Properties& p) {
  const Vec3d normal = unit_direction(p.vec3("normal"));
  if (p.has("offset") && p.has("point")) {
    context
        .report<DiagnosticKind::one_or_the_other>(p.find("point")->name_span, "plane", "offset",
                                                  "point")
        .label(p.find("offset")->name_span, "`offset` is here");
    return std::nullopt;
  }
  const double offset = p.has("point") ? dot(normal, p.vec3("point")) : p.number("offset");
  return Plane{normal, offset};
}

Lowered box(Context& context, const Properties& p) {
  const Vec3d min = p.vec3("min"), max = p.vec3("max");
  for (int axis = 0; axis < 3; ++axis) {
    if (min[axis] < max[axis]) continue;
    context
        .report<DiagnosticKind::box_is_flat>(p.span("max"), "xyz"[axis], number_text(max[axis]),
                                             number_text(min[axis]))
        .label(p.span("min"), "`min` is here")
        .hint("exchange the two, or use a `quad` for something flat");
    return std::nullopt;
  }
  return Box{min, max};
}

Lowered disc(Context& context, const Properties& p) {
  const double radius = p.number("radius"), hole = p.number("hole_radius");
  if (!(hole < radius)) {
    context.report<DiagnosticKind::hole_too_large>(p.span("hole_radius"), number_text(hole),
                                                   number_text(radius));
    return std::nullopt;
  }
  return Disc{p.vec3("center"), unit_direction(p.vec3("normal")), radius, hole};
}

bool has_length(Context& context, const Properties& p) {
  if (!(p.vec3("base") == p.vec3("top"))) return true;
  context.report<DiagnosticKind::no_length>(p.span("top"), p.schema().name)
      .label(p.span("base"), "`base` is the same point")
      .hint("use a `disc` for something flat");
  return false;
}

Lowered cylinder(Context& context, const Properties& p) {
  if (!has_length(context, p)) return std::nullopt;
  return Cylinder{p.vec3("base"), p.vec3("top"), p.number("radius"), !p.boolean("open")};
}

Lowered cone(Context& context, const Properties& p) {
  if (!has_length(context, p)) return std::nullopt;
  const double base = p.number("base_radius"), top = p.number("top_radius");
  if (base == 0 && top == 0) {
    context.report<DiagnosticKind::cone_without_radius>(p.span("base_radius"));
    return std::nullopt;
  }
  return Cone{p.vec3("base"), p.vec3("top"), base, top, !p.boolean("open")};
}

// The area of the parallelogram of two edges, or nothing where they lie along one line.
bool spans_area(Vec3d u, Vec3d v) {
  return !is_zero(u) && !is_zero(v) && !is_parallel(u, v);
}

Lowered triangle(Context& context, const Properties& p) {
  const Vec3d a = p.vec3("a"), b = p.vec3("b"), c = p.vec3("c");
  if (!spans_area(b - a, c - a) || is_zero(c - b)) {
    context.report<DiagnosticKind::no_area>(p.head(), "triangle")
        .hint("its corners lie on one line; move one of them");
    return std::nullopt;
  }
  Triangle out{{a, b, c}, std::nullopt};
  if (!p.has("normals")) return out;
  const auto& normals = p.find("normals")->value.elements();
  out.normals.emplace();
  for (std::size_t i = 0; i < 3; ++i) {
    if (normals.size() != 3 || !normals[i].is(Type::vec3) || is_zero(normals[i].as<Vec3d>())) {
      context.report<DiagnosticKind::bad_normals>(p.span("normals"))
          .hint("for instance `normals [<0, 1, 0>, <0, 1, 0.1>, <0.1, 1, 0>]`");
      return std::nullopt;
    }
    (*out.normals)[i] = unit_direction(normals[i].as<Vec3d>());
  }
  return out;
}

Lowered quad(Context& context, const Properties& p) {
  const Vec3d u = p.vec3("edge_u"), v = p.vec3("edge_v");
  if (!spans_area(u, v)) {
    context.report<DiagnosticKind::no_area>(p.span("edge_v"), "quad")
        .label(p.span("edge_u"), "this edge has the same direction");
    return std::nullopt;
  }
  return Quad4{p.vec3("corner"), u, v};
}

struct ShapeKind {
  std::string_view name;
  Lowered (*lower)(Context&, const Properties&);
};
constexpr ShapeKind kKinds[] = {{"sphere", sphere},     {"plane", plane}, {"box", box},
                                {"disc", disc},         {"cone", cone},   {"cylinder", cylinder},
                                {"triangle", triangle}, {"quad", quad}};

}  // namespace

std::optional<Geometry> lower_shape(Context& context, const Properties& properties) {
  for (const ShapeKind& kind : kKinds) {
    if (same_name(kind.name, properties.schema().name)) return kind.lower(context, properties);
  }
  return std::nullopt;
}

}  // namespace alhazen::parser

// parser/eval: finite numbers everywhere; warnings.
#include "parser/eval/check_scene.h"

#include <algorithm>

#include "core/base/overloaded.h"

namespace alhazen::parser {
namespace {

bool finite(double x) {
  return alhazen::is_finite(x);
}
bool finite(Vec3d v) {
  return alhazen::is_finite(v);
}
bool finite(Rgbd c) {
  return finite(Vec3d{c.r, c.g, c.b});
}
template <class... Rest>
bool finite(const auto& first, const Rest&... rest) requires(sizeof...(Rest) > 0) {
  return finite(first) && finite(rest...);
}

bool is_finite(const Geometry& geometry) {
  return std::visit(
      Overloaded{[](const Sphere& s) { return finite(s.center, s.radius); },
                 [](const Plane& p) { return finite(p.normal, p.offset); },
                 [](const Box& b) { return finite(b.min, b.max); },
                 [](const Disc& d) { return finite(d.center, d.normal, d.radius, d.hole_radius); },
                 [](const Cylinder& c) { return finite(c.base, c.top, c.radius); },
                 [](const Cone& c) { return finite(c.base, c.top, c.base_radius, c.top_radius); },
                 [](const Triangle& t) {
                   const bool corners = finite(t.corners[0], t.corners[1], t.corners[2]);
                   if (!t.normals) return corners;
                   return corners && finite((*t.normals)[0], (*t.normals)[1], (*t.normals)[2]);
                 },
                 [](const Quad4& q) { return finite(q.corner, q.edge_u, q.edge_v); }},
      geometry);
}

bool is_finite(const LightSource& source) {
  return std::visit(
      Overloaded{
          [](const PointLight& l) { return finite(l.position, l.intensity); },
          [](const DirectionalLight& l) { return finite(l.direction, l.irradiance); },
          [](const SpotLight& l) {
            return finite(l.position, l.axis, l.intensity, l.inner_angle_deg, l.outer_angle_deg);
          },
          [](const SphereLight& l) { return finite(l.center, l.radius, l.radiance); },
          [](const RectangleLight& l) { return finite(l.corner, l.edge_u, l.edge_v, l.radiance); },
          [](const AmbientLight& l) { return finite(l.radiance); }},
      source);
}

bool is_finite(const Camera& camera) {
  const CameraFrame& f = camera.frame;
  return finite(f.position, f.right, f.up, f.forward);
}

bool glows(const Material& material) {
  if (!is_black(material.emission)) return true;
  const auto* finish = std::get_if<PovFinish>(&material.scattering);
  return finish != nullptr && !(is_black(finish->ambient) && is_black(finish->emission));
}

bool is_lit(const Scene& scene) {
  const auto* solid = std::get_if<SolidBackground>(&scene.background.source);
  return !scene.lights.empty() || solid == nullptr || !is_black(solid->color) ||
         std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& m) { return glows(m); });
}

// The inside of a material on a shape that has none.
void check_open_shape(Context& context, const Scene& scene, const Shape& shape) {
  const Scattering& scattering = scene.materials[shape.material].scattering;
  const auto* finish = std::get_if<PovFinish>(&scattering);
  if (std::holds_alternative<Glass>(scattering)) {
    context.report<DiagnosticKind::glass_without_inside>(shape.span, kind_name(shape.geometry))
        .hint("light bends on its way in and out of a solid: use a closed shape");
  } else if (finish != nullptr && opacity(*finish) < 1 && (finish->ior != 1 || fades(*finish))) {
    context.report<DiagnosticKind::finish_without_inside>(shape.span, kind_name(shape.geometry))
        .hint("use a closed shape, or several that close with their normals outward");
  }
}

}  // namespace

void check_scene(Context& context, const Scene& scene) {
  if (!is_finite(scene.camera)) {
    context.report<DiagnosticKind::not_finite_in_scene>(scene.camera.span, "camera");
  }
  scene.shapes.for_each_different([&](const Shape& shape, ShapeId id) {
    if (!is_finite(shape.geometry)) {
      context.report<DiagnosticKind::not_finite_in_scene>(shape.span, scene.shapes.name(id));
    }
    if (!is_closed(shape.geometry)) check_open_shape(context, scene, shape);
  });
  for (const Light& light : scene.lights) {
    if (!is_finite(light.source)) {
      context.report<DiagnosticKind::not_finite_in_scene>(light.span, light.name);
    }
  }
  if (!is_lit(scene)) {
    context.report<DiagnosticKind::no_light>(scene.camera.span)
        .hint("add one, for instance `light point { position <5, 8, -5>  intensity rgb(60) }`");
  }
}

}  // namespace alhazen::parser

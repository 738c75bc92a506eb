// core/scene: the scene as text, one record a line, with every digit.
#include <charconv>
#include <fmt/format.h>

#include "core/base/overloaded.h"
#include "core/scene/scene.h"

namespace alhazen {
namespace {

std::string text(double x) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr};
}
std::string text(Vec3d v) {
  return fmt::format("<{}, {}, {}>", text(v.x), text(v.y), text(v.z));
}
std::string text(Rgbd c) {
  return fmt::format("rgb({}, {}, {})", text(c.r), text(c.g), text(c.b));
}

std::string text(const Affined& map) {
  std::string out = "[";
  for (const auto& row : map.rows) {
    for (const double entry : row)
      out += (out.size() > 1 ? " " : "") + text(entry);
    out += ';';
  }
  out.back() = ']';
  return out;
}

std::string text(const std::vector<GradientStop>& stops) {
  std::string out;
  for (const GradientStop& stop : stops)
    out += fmt::format(" {} {}", text(stop.position), text(stop.color));
  return out;
}

std::string quoted(std::string_view name) {
  std::string out = "\"";
  for (const char byte : name) {
    if (byte == '"' || byte == '\\') out += '\\';
    out += byte == '\n' ? ' ' : byte;
  }
  return out + '"';
}

std::string text(const Geometry& geometry) {
  return std::visit(
      Overloaded{
          [](const Sphere& s) {
            return fmt::format("center {} radius {}", text(s.center), text(s.radius));
          },
          [](const Plane& p) {
            return fmt::format("normal {} offset {}", text(p.normal), text(p.offset));
          },
          [](const Box& b) { return fmt::format("min {} max {}", text(b.min), text(b.max)); },
          [](const Disc& d) {
            return fmt::format("center {} normal {} radius {} hole_radius {}", text(d.center),
                               text(d.normal), text(d.radius), text(d.hole_radius));
          },
          [](const Cylinder& c) {
            return fmt::format("base {} top {} radius {} capped {}", text(c.base), text(c.top),
                               text(c.radius), c.capped);
          },
          [](const Cone& c) {
            return fmt::format("base {} top {} base_radius {} top_radius {} capped {}",
                               text(c.base), text(c.top), text(c.base_radius), text(c.top_radius),
                               c.capped);
          },
          [](const Triangle& t) {
            std::string out = fmt::format("a {} b {} c {}", text(t.corners[0]), text(t.corners[1]),
                                          text(t.corners[2]));
            if (t.normals) {
              out += fmt::format(" normals {} {} {}", text((*t.normals)[0]), text((*t.normals)[1]),
                                 text((*t.normals)[2]));
            }
            return out;
          },
          [](const Quad4& q) {
            return fmt::format("corner {} edge_u {} edge_v {}", text(q.corner), text(q.edge_u),
                               text(q.edge_v));
          }},
      geometry);
}

std::string text(const Pattern& pattern) {
  return std::visit(
      Overloaded{
          [](const SolidPattern& p) { return "solid " + text(p.color); },
          [](const CheckerPattern& p) { return fmt::format("checker {} {}", p.even, p.odd); },
          [](const StripesPattern& p) { return fmt::format("stripes {} {}", p.even, p.odd); },
          [](const BrickPattern& p) {
            return fmt::format("brick {} {} size {} mortar_width {}", p.brick, p.mortar,
                               text(p.size), text(p.mortar_width));
          },
          [](const GradientPattern& p) { return "gradient" + text(p.stops); },
          [](const ImagePattern& p) {
            static constexpr const char* kWraps[] = {"repeat", "clamp", "mirror"};
            return fmt::format("image {} wrap {} filter {}", p.image,
                               kWraps[static_cast<int>(p.wrap)],
                               p.filter == ImageFilter::nearest ? "nearest" : "bilinear");
          }},
      pattern);
}

std::string text(const PovFinish& m) {
  const PovReflection& r = m.reflection;
  return fmt::format("pov_finish color {} filter {} transmit {} ambient {} emission {}", m.color,
                     text(m.filter), text(m.transmit), text(m.ambient), text(m.emission)) +
         fmt::format(" diffuse {} brilliance {} phong {} phong_size {} specular {} roughness {}",
                     text(m.diffuse), text(m.brilliance), text(m.phong), text(m.phong_size),
                     text(m.specular), text(m.roughness)) +
         fmt::format(" metallic {} reflection min {} max {} falloff {} fresnel {} metallic {}",
                     text(m.metallic), text(r.min), text(r.max), text(r.falloff), r.fresnel,
                     text(r.metallic)) +
         fmt::format(" conserve_energy {} ior {} fade_distance {} fade_power {} fade_color {}",
                     m.conserve_energy, text(m.ior), text(m.fade_distance), text(m.fade_power),
                     text(m.fade_color));
}

std::string text(const Scattering& scattering) {
  return std::visit(
      Overloaded{
          [](const Diffuse& d) {
            std::string out = fmt::format("diffuse albedo {}", d.albedo);
            if (!is_black(d.highlight.strength)) {
              out += fmt::format(" {} strength {} exponent {}",
                                 d.highlight.model == HighlightModel::phong ? "phong" : "blinn",
                                 text(d.highlight.strength), text(d.highlight.exponent));
            }
            return out;
          },
          [](const Mirror& m) { return fmt::format("mirror reflectance {}", m.reflectance); },
          [](const Metal& m) { return fmt::format("metal n {} k {}", text(m.n), text(m.k)); },
          [](const Glass& g) {
            return fmt::format("glass ior {} absorption {} priority {}", text(g.ior),
                               text(g.absorption), g.priority);
          },
          [](const Coat& c) {
            return fmt::format("coat ior {} absorption {} base_albedo {}", text(c.ior),
                               text(c.absorption), c.base_albedo);
          },
          [](const Black&) { return std::string("black"); },
          [](const PovFinish& m) { return text(m); }},
      scattering);
}

const char* text(Falloff falloff) {
  return falloff == Falloff::none ? "none" : "inverse_square";
}

std::string text(const LightSource& source) {
  return std::visit(
      Overloaded{[](const PointLight& l) {
                   return fmt::format("point position {} intensity {} falloff {}", text(l.position),
                                      text(l.intensity), text(l.falloff));
                 },
                 [](const DirectionalLight& l) {
                   return fmt::format("directional direction {} irradiance {}", text(l.direction),
                                      text(l.irradiance));
                 },
                 [](const SpotLight& l) {
                   return fmt::format(
                       "spot position {} axis {} intensity {} angles {} {} falloff {}",
                       text(l.position), text(l.axis), text(l.intensity), text(l.inner_angle_deg),
                       text(l.outer_angle_deg), text(l.falloff));
                 },
                 [](const SphereLight& l) {
                   return fmt::format("sphere center {} radius {} radiance {} samples {}",
                                      text(l.center), text(l.radius), text(l.radiance), l.samples);
                 },
                 [](const RectangleLight& l) {
                   return fmt::format(
                       "rectangle corner {} edge_u {} edge_v {} radiance {} samples {}",
                       text(l.corner), text(l.edge_u), text(l.edge_v), text(l.radiance), l.samples);
                 },
                 [](const AmbientLight& l) { return "ambient radiance " + text(l.radiance); }},
      source);
}

std::string text(const Camera& camera) {
  const CameraFrame& f = camera.frame;
  std::string out = std::visit(
      Overloaded{[](const PerspectiveCamera& p) {
                   std::string lens;
                   if (p.lens) {
                     lens =
                         fmt::format(" aperture_radius {} focus_distance {}",
                                     text(p.lens->aperture_radius), text(p.lens->focus_distance));
                   }
                   return fmt::format("perspective fov {}{}", text(p.fov_deg), lens);
                 },
                 [](const OrthographicCamera& o) { return "orthographic width " + text(o.width); }},
      camera.projection);
  return out + fmt::format(" position {} right {} up {} forward {}", text(f.position),
                           text(f.right), text(f.up), text(f.forward));
}

std::string text(const Background& background) {
  return std::visit(
      Overloaded{[](const SolidBackground& b) { return "solid " + text(b.color); },
                 [](const GradientBackground& b) { return "gradient" + text(b.stops); },
                 [](const EnvironmentBackground& b) {
                   return fmt::format("environment {} rotation {} intensity {}", b.image,
                                      text(b.rotation_deg), text(b.intensity));
                 }},
      background.source);
}

std::string text(const RenderSettings& s) {
  static constexpr const char* kFilters[] = {"box", "tent", "gaussian", "mitchell"};
  std::string adaptive;
  if (s.adaptive) {
    adaptive = fmt::format(" adaptive {} min_samples {}", text(s.adaptive->threshold),
                           s.adaptive->min_samples);
  }
  if (s.max_error) {
    adaptive +=
        fmt::format(" max_error {} share {}", text(s.max_error->error), text(s.max_error->share));
  }
  return fmt::format(
      "size {}x{} samples {}{} depth {} cutoff {} filter {} {} transparent {} seed {}", s.width,
      s.height, s.samples, adaptive, s.max_depth, text(s.cutoff),
      kFilters[static_cast<int>(s.filter.kind)], text(s.filter.radius), s.transparent_background,
      s.seed);
}

std::string text(const Shape& s, std::string_view name) {
  std::string out = fmt::format("{} {} {}", quoted(name), kind_name(s.geometry), text(s.geometry));
  if (s.material != kNoId) out += fmt::format(" material {}", s.material);
  if (s.world_from_object) out += " world " + text(*s.world_from_object);
  if (s.light != kNoId) out += fmt::format(" light {}", s.light);
  return out + '\n';
}

// Single shapes and instances in the order of their ids; what has no id of its own goes before.
void append_shapes(const SceneShapes& shapes, std::string& out) {
  for (std::size_t p = 0; p < shapes.prototypes().size(); ++p) {
    const ShapeList& prototype = shapes.prototypes()[p];
    for (std::size_t i = 0; i < prototype.size(); ++i)
      out += fmt::format("prototype {} shape {}: {}", p, i, text(prototype[i], prototype.name(i)));
  }
  InstanceId next = 0;
  const auto append_instances_before = [&](ShapeId id) {
    for (; next < shapes.instance_count() && shapes.index().first(next) < id; ++next) {
      const Instance instance = shapes.instance(next);
      out += fmt::format(
          "shape {} to {}: {} prototype {}", shapes.index().first(next),
          shapes.index().first(next) + shapes.prototypes()[instance.prototype].size() - 1,
          quoted(instance.path), instance.prototype);
      if (instance.material != kNoId) out += fmt::format(" material {}", instance.material);
      out += " world " + text(instance.world_from_group) + '\n';
    }
  };
  for (ShapeId n = 0; n < shapes.singles().size(); ++n) {
    const ShapeId id = shapes.index().id_of_single(n);
    append_instances_before(id);
    out += fmt::format("shape {}: {}", id, text(shapes.singles()[n], shapes.singles().name(n)));
  }
  append_instances_before(static_cast<ShapeId>(shapes.size()));
}

}  // namespace

std::string dump(const Scene& scene) {
  std::string out = fmt::format("camera {}\nbackground {}\nrender {}\n", text(scene.camera),
                                text(scene.background), text(scene.settings));
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    out += fmt::format("image {}: {} color_space {}\n", i, quoted(scene.images[i].path),
                       quoted(scene.images[i].color_space));
  }
  static constexpr const char* kMappings[] = {"object", "world", "uv"};
  for (std::size_t i = 0; i < scene.textures.size(); ++i) {
    const Texture& t = scene.textures[i];
    out += fmt::format("texture {}: {}", i, text(t.pattern));
    if (!std::holds_alternative<SolidPattern>(t.pattern)) {
      out += fmt::format(" mapping {}", kMappings[static_cast<int>(t.mapping)]);
    }
    if (!(t.pattern_from_mapped == Affined())) out += " from " + text(t.pattern_from_mapped);
    out += '\n';
  }
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& m = scene.materials[i];
    out += fmt::format("material {}: {} {} emission {}{}\n", i, quoted(m.name), text(m.scattering),
                       text(m.emission), m.one_sided_emission ? " of one side" : "");
  }
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& l = scene.lights[i];
    out += fmt::format("light {}: {} {} shadows {}", i, quoted(l.name), text(l.source),
                       l.casts_shadows);
    if (l.visible_shape != kNoId) out += fmt::format(" shape {}", l.visible_shape);
    out += '\n';
  }
  append_shapes(scene.shapes, out);
  return out;
}

}  // namespace alhazen

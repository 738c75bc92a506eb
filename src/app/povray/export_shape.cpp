// app/povray: shapes, each with a line that says where it comes from. Materials that look the same
// on every shape are declared once.
#include "app/povray/exporter.h"
#include "core/base/overloaded.h"

namespace alhazen {
namespace {

std::string open_word(bool capped) {
  return capped ? "" : " open";
}

std::string corners(const Triangle& t) {
  if (!t.normals) {
    return fmt::format("triangle {{ {}, {}, {} }}", pov_vector(t.corners[0]),
                       pov_vector(t.corners[1]), pov_vector(t.corners[2]));
  }
  return fmt::format("smooth_triangle {{ {}, {},  {}, {},  {}, {} }}", pov_vector(t.corners[0]),
                     pov_vector((*t.normals)[0]), pov_vector(t.corners[1]),
                     pov_vector((*t.normals)[1]), pov_vector(t.corners[2]),
                     pov_vector((*t.normals)[2]));
}

// Whether light bends or fades inside of what wears the material.
bool has_inside(const Material& material) {
  const auto* finish = std::get_if<PovFinish>(&material.scattering);
  return std::holds_alternative<Glass>(material.scattering) ||
         (finish != nullptr && opacity(*finish) < 1 && (finish->ior != 1 || fades(*finish)));
}

// "sphere {" and the numbers that make it.
struct ShapeText {
  std::string head, numbers;
};

ShapeText shape_text(const Geometry& geometry) {
  return std::visit(
      Overloaded{
          [](const Sphere& s) -> ShapeText {
            return {"sphere", fmt::format("{}, {}", pov_vector(s.center), pov_number(s.radius))};
          },
          [](const Plane& p) -> ShapeText {
            return {"plane", fmt::format("{}, {}", pov_vector(p.normal), pov_number(p.offset))};
          },
          [](const Box& b) -> ShapeText {
            return {"box", fmt::format("{}, {}", pov_vector(b.min), pov_vector(b.max))};
          },
          [](const Disc& d) -> ShapeText {
            return {"disc",
                    fmt::format("{}, {}, {}, {}", pov_vector(d.center), pov_vector(d.normal),
                                pov_number(d.radius), pov_number(d.hole_radius))};
          },
          [](const Cylinder& c) -> ShapeText {
            return {"cylinder", fmt::format("{}, {}, {}{}", pov_vector(c.base), pov_vector(c.top),
                                            pov_number(c.radius), open_word(c.capped))};
          },
          [](const Cone& c) -> ShapeText {
            return {"cone",
                    fmt::format("{}, {}, {}, {}{}", pov_vector(c.base), pov_number(c.base_radius),
                                pov_vector(c.top), pov_number(c.top_radius), open_word(c.capped))};
          },
          [](const Triangle& t) -> ShapeText {
            return {"mesh", corners(t)};
          },
          [](const Quad4& q) -> ShapeText {
            const Vec3d last = q.corner + q.edge_v;
            return {"polygon",
                    fmt::format("5, {}, {}, {}, {}, {}", pov_vector(q.corner),
                                pov_vector(q.corner + q.edge_u), pov_vector(last + q.edge_u),
                                pov_vector(last), pov_vector(q.corner))};
          }},
      geometry);
}

class ShapesExport {
 public:
  explicit ShapesExport(Exporter& exporter) : exporter_(exporter) {}

  void declare_materials() {
    std::vector<bool> seen(exporter_.scene.materials.size());
    for (const Shape& shape : shapes()) {
      const Material& material = exporter_.scene.materials[shape.material];
      if (seen[shape.material] || !is_shareable(exporter_, material)) continue;
      seen[shape.material] = true;
      out().comment(origin_of(exporter_, material.span,
                              material.name.empty() ? "material" : "material " + material.name));
      out().open("#declare " + name_of(shape.material) + " = material");
      export_material(exporter_, material, {Affined{}, Affined{}, &shape});
      out().close();
    }
    out().blank();
  }

  void write_shapes() {
    for (std::size_t i = 0; i < shapes().size();) {
      std::size_t end = i + 1;
      while (end < shapes().size() && joins_mesh(shapes()[i], shapes()[end]))
        ++end;
      write(i, end);
      i = end;
    }
  }

 private:
  PovWriter& out() { return exporter_.out; }
  const ShapeList& shapes() const { return exporter_.scene.shapes; }
  static std::string name_of(MaterialId id) { return fmt::format("material_{}", id); }

  // Triangles of one material that follow each other are one mesh: POV-Ray finds its way in a mesh
  // much faster, and a solid made of triangles has one inside.
  bool joins_mesh(const Shape& first, const Shape& next) const {
    const auto is_plain = [](const Shape& s) {
      return std::holds_alternative<Triangle>(s.geometry) && !s.world_from_object;
    };
    return is_plain(first) && is_plain(next) && first.material == next.material &&
           first.light == next.light &&
           is_shareable(exporter_, exporter_.scene.materials[first.material]);
  }

  // Shapes begin .. end - 1 as one object.
  void write(std::size_t begin, std::size_t end) {
    const Shape shape = shapes()[begin];
    const ShapeText text = shape_text(shape.geometry);
    say_what_differs(begin, end);
    out().comment(origin_of(exporter_, shape.span, shapes().name(begin)));
    out().open(text.head);
    out().line(text.numbers);
    for (std::size_t i = begin + 1; i < end; ++i) {
      const Shape next = shapes()[i];
      if (!(next.span == shapes()[i - 1].span)) {
        out().comment(origin_of(exporter_, next.span, shapes().name(i)));
      }
      out().line(corners(std::get<Triangle>(next.geometry)));
    }
    wear_material(shape);
    if (shape.light != kNoId) no_shadow(shape);
    if (shape.world_from_object) out().line(pov_matrix(*shape.world_from_object));
    out().close();
  }

  void say_what_differs(std::size_t begin, std::size_t end) {
    const Shape shape = shapes()[begin];
    if (has_inside(exporter_.scene.materials[shape.material]) && !is_closed(shape.geometry) &&
        !std::holds_alternative<Triangle>(shape.geometry)) {
      exporter_.deviate(DeviationKind::open_solid, shape.span);
    }
    // Smooth triangles come by the thousand: the first of a mesh stands for all.
    for (std::size_t i = begin; i < end; ++i) {
      const Shape next = shapes()[i];
      const auto* triangle = std::get_if<Triangle>(&next.geometry);
      if (triangle == nullptr || !triangle->normals) continue;
      exporter_.deviate(DeviationKind::smooth_normals, next.span);
      break;
    }
  }

  // Before the shape's own matrix, which then moves the texture along.
  void wear_material(const Shape& shape) {
    const Material& material = exporter_.scene.materials[shape.material];
    if (is_shareable(exporter_, material)) {
      out().line(fmt::format("material {{ {} }}", name_of(shape.material)));
      return;
    }
    Affined object_from_world;
    if (shape.world_from_object) object_from_world = *inverse(*shape.world_from_object);
    out().open("material");
    export_material(exporter_, material, {Affined{}, object_from_world, &shape});
    out().close();
  }

  // A lamp's own shape does not shadow its light; in POV-Ray then it shadows none.
  void no_shadow(const Shape& shape) {
    out().line("no_shadow");
    for (LightId id = 0; id < exporter_.scene.lights.size(); ++id) {
      const Light& other = exporter_.scene.lights[id];
      if (id == shape.light || !shines(other) || !other.casts_shadows ||
          std::holds_alternative<AmbientLight>(other.source)) {
        continue;
      }
      exporter_.deviate(DeviationKind::lamp_shadow, shape.span);
    }
  }

  Exporter& exporter_;
};

}  // namespace

void export_shapes(Exporter& exporter) {
  ShapesExport shapes(exporter);
  shapes.declare_materials();
  shapes.write_shapes();
}

}  // namespace alhazen

// app/povray: shapes, each with a line that says where it comes from. Materials that look the same
// on every shape are declared once.
#include <map>
#include <utility>

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
    shapes().for_each_different([&](const Shape& shape, ShapeId) {
      const Material& material = exporter_.scene.materials[shape.material];
      if (seen[shape.material] || !is_shareable(exporter_, material)) return;
      seen[shape.material] = true;
      out().comment(origin_of(exporter_, material.span,
                              material.name.empty() ? "material" : "material " + material.name));
      out().open("#declare " + name_of(shape.material) + " = material");
      export_material(exporter_, material, {Affined{}, Affined{}, &shape});
      out().close();
    });
    out().blank();
  }

  // Instances of one prototype and one material are places of one declared object.
  void write_shapes() {
    const ShapeList& singles = shapes().singles();
    const InstanceIndex& index = shapes().index();
    ShapeId written = 0;
    const auto write_singles_before = [&](ShapeId id) {
      ShapeId end = written;
      while (end < singles.size() && index.id_of_single(end) < id)
        ++end;
      write_run(singles, written, end, "");
      written = end;
    };
    for (InstanceId id = 0; id < shapes().instance_count(); ++id) {
      write_singles_before(index.first(id));
      write_instance(id);
    }
    write_singles_before(static_cast<ShapeId>(shapes().size()));
  }

 private:
  PovWriter& out() { return exporter_.out; }
  const SceneShapes& shapes() const { return exporter_.scene.shapes; }
  static std::string name_of(MaterialId id) { return fmt::format("material_{}", id); }

  // The shapes of an instance in the group's frame, with the materials that they wear.
  ShapeList worn_shapes(const Instance& instance) const {
    ShapeList worn;
    for (Shape shape : shapes().prototypes()[instance.prototype]) {
      if (shape.material == kNoId) shape.material = instance.material;
      worn.push_back(shape);
    }
    return worn;
  }

  void write_instance(InstanceId id) {
    const Instance instance = shapes().instance(id);
    const auto [known, is_new] =
        declared_.try_emplace({instance.prototype, instance.material}, std::string());
    if (is_new) known->second = declare(instance);
    if (!known->second.empty()) {
      out().line(
          fmt::format("object {{ {} {} }}", known->second, pov_matrix(instance.world_from_group)));
      return;
    }
    // A texture that lies in the world, or on a shape's own coordinates, is of one place.
    const ShapeId first = shapes().index().first(id);
    ShapeList single;
    for (ShapeId n = 0; n < shapes().prototypes()[instance.prototype].size(); ++n)
      single.push_back(shapes()[first + n]);
    write_run(single, 0, single.size(), "");
  }

  // The name of the object that was declared; empty if its materials cannot be shared.
  std::string declare(const Instance& instance) {
    const ShapeList worn = worn_shapes(instance);
    for (const Shape& shape : worn) {
      if (!is_shareable(exporter_, exporter_.scene.materials[shape.material])) return "";
    }
    std::string name = fmt::format("group_{}", declared_.size());
    out().comment(origin_of(exporter_, instance.span, "a group that is placed several times"));
    out().open("#declare " + name + " = union");
    write_run(worn, 0, worn.size(), instance.path);
    out().close();
    return name;
  }

  void write_run(const ShapeList& list, std::size_t begin, std::size_t last,
                 const std::string& path) {
    for (std::size_t i = begin; i < last;) {
      std::size_t end = i + 1;
      while (end < last && joins_mesh(list[i], list[end]))
        ++end;
      write(list, i, end, path);
      i = end;
    }
  }

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

  // Shapes begin .. end - 1 as one object; `path` is that of the groups around the list.
  void write(const ShapeList& list, std::size_t begin, std::size_t end, const std::string& path) {
    const Shape shape = list[begin];
    const ShapeText text = shape_text(shape.geometry);
    say_what_differs(list, begin, end);
    out().comment(origin_of(exporter_, shape.span, path + list.name(begin)));
    out().open(text.head);
    out().line(text.numbers);
    for (std::size_t i = begin + 1; i < end; ++i) {
      const Shape next = list[i];
      if (!(next.span == list[i - 1].span)) {
        out().comment(origin_of(exporter_, next.span, path + list.name(i)));
      }
      out().line(corners(std::get<Triangle>(next.geometry)));
    }
    wear_material(shape);
    if (shape.light != kNoId) no_shadow(shape);
    if (shape.world_from_object) out().line(pov_matrix(*shape.world_from_object));
    out().close();
  }

  void say_what_differs(const ShapeList& list, std::size_t begin, std::size_t end) {
    const Shape shape = list[begin];
    if (has_inside(exporter_.scene.materials[shape.material]) && !is_closed(shape.geometry) &&
        !std::holds_alternative<Triangle>(shape.geometry)) {
      exporter_.deviate(DeviationKind::open_solid, shape.span);
    }
    // Smooth triangles come by the thousand: the first of a mesh stands for all.
    for (std::size_t i = begin; i < end; ++i) {
      const Shape next = list[i];
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
  std::map<std::pair<PrototypeId, MaterialId>, std::string> declared_;
};

}  // namespace

void export_shapes(Exporter& exporter) {
  ShapesExport shapes(exporter);
  shapes.declare_materials();
  shapes.write_shapes();
}

}  // namespace alhazen

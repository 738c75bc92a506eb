// parser/eval: composing transforms, handing materials down, giving names.
#include "parser/eval/flatten.h"

#include <array>
#include <fmt/format.h>

#include "core/base/overloaded.h"
#include "parser/eval/lower.h"
#include "parser/eval/used_records.h"

namespace alhazen::parser {
namespace {

// What a node has from the groups around it.
struct Surroundings {
  std::optional<Affined> world_from_parent;
  MaterialId material = kNoId;
  std::string path;  // "table/leg/"
};

class Flattener {
 public:
  Flattener(Context& context, Scene& scene, UsedRecords& used)
      : context_(context), scene_(scene), used_(used) {}

  // As deep as objects nest (BlockBuilder bounds it).
  void walk(const Group& group, const Surroundings& around) {
    for (const Node& node : group.children) {
      if (context_.halted()) return;
      std::visit(Overloaded{[&](const PlacedShape& s) { add(s, node, around); },
                            [&](const PlacedLight& l) { add(l, node, around); },
                            [&](const std::shared_ptr<const Group>& inner) {
                              walk(*inner, inside(node, around));
                            }},
                 node.content);
    }
  }

 private:
  static std::optional<Affined> world_from(const Node& node, const Surroundings& around) {
    if (!around.world_from_parent) return node.parent_from_child;
    if (!node.parent_from_child) return around.world_from_parent;
    return *around.world_from_parent * *node.parent_from_child;
  }

  static Surroundings inside(const Node& node, const Surroundings& around) {
    return {world_from(node, around), node.material != kNoId ? node.material : around.material,
            node.name.empty() ? around.path : around.path + node.name + "/"};
  }

  bool is_sound(const std::optional<Affined>& map, SourceSpan span) {
    if (!map || inverse(*map)) return true;
    context_.report<DiagnosticKind::singular_transform>(span, "all transforms together")
        .hint("no factor may be 0, and none so large or small that numbers do not hold it");
    return false;
  }

  // Without any material around it, a shape is of plain light grey.
  MaterialId default_material() {
    if (default_material_ == kNoId) {
      Store& store = context_.store();
      const TextureId grey = store.add(Texture{SolidPattern{Rgbd(0.8)}, Mapping::object, {}, {}});
      default_material_ = store.add(Material{Diffuse{grey, {}}, {}, false, "", {}});
    }
    return default_material_;
  }

  void add(const PlacedShape& placed, const Node& node, const Surroundings& around) {
    Shape shape;
    shape.geometry = placed.geometry;
    shape.world_from_object = world_from(node, around);
    if (!is_sound(shape.world_from_object, node.span)) return;
    const MaterialId material = node.material != kNoId ? node.material : around.material;
    shape.material = used_.material(material != kNoId ? material : default_material());
    shape.span = node.span;
    shape.name =
        name_of(node, around, kind_name(shape.geometry), shape_counts_[shape.geometry.index()]);
    scene_.shapes.push_back(std::move(shape));
  }

  void add(const PlacedLight& placed, const Node& node, const Surroundings& around) {
    static constexpr const char* kKinds[] = {"point light",  "directional light", "spot light",
                                             "sphere light", "rectangle light",   "ambient light"};
    const auto map = world_from(node, around);
    if (!is_sound(map, node.span)) return;
    Light light;
    light.source = placed.source;
    if (map) {
      const auto moved = transformed(context_, placed.source, *map, node.span);
      if (!moved) return;
      light.source = *moved;
    }
    light.casts_shadows = placed.casts_shadows;
    light.span = node.span;
    const std::size_t kind = light.source.index();
    light.name = name_of(node, around, kKinds[kind], light_counts_[kind]);
    if (placed.visible) add_visible_shape(light);
    scene_.lights.push_back(std::move(light));
  }

  void add_visible_shape(Light& light) {
    Shape shape;
    Rgbd radiance;
    std::visit(Overloaded{[&](const SphereLight& l) {
                            shape.geometry = Sphere{l.center, l.radius};
                            radiance = l.radiance;
                          },
                          [&](const RectangleLight& l) {
                            shape.geometry = Quad4{l.corner, l.edge_u, l.edge_v};
                            radiance = l.radiance;
                          },
                          [](const auto&) {}},
               light.source);
    // A rectangle is seen to shine from the side to which it shines; a ball has only one.
    Material worn{Black{}, radiance, true, "", light.span};
    shape.material = used_.material(context_.store().add(std::move(worn)));
    shape.light = static_cast<LightId>(scene_.lights.size());
    shape.name = light.name;
    shape.span = light.span;
    light.visible_shape = static_cast<ShapeId>(scene_.shapes.size());
    scene_.shapes.push_back(std::move(shape));
  }

  std::string name_of(const Node& node, const Surroundings& around, const char* kind, int& count) {
    ++count;
    std::string name =
        around.path + (node.name.empty() ? fmt::format("{} {}", kind, count) : node.name);
    // What the objects around it add to each name is not counted anywhere else.
    context_.spend_string(around.path.size(), node.span);
    return name;
  }

  Context& context_;
  Scene& scene_;
  UsedRecords& used_;
  MaterialId default_material_ = kNoId;
  std::array<int, std::variant_size_v<Geometry>> shape_counts_{};
  std::array<int, std::variant_size_v<LightSource>> light_counts_{};
};

}  // namespace

void flatten(Context& context, const Group& root, Scene& scene) {
  UsedRecords used(context.store(), scene);
  if (auto* environment = std::get_if<EnvironmentBackground>(&scene.background.source)) {
    environment->image = used.image(environment->image);
  }
  Flattener(context, scene, used).walk(root, {});
}

}  // namespace alhazen::parser

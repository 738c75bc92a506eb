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
    group.children.for_each([&](const auto& content, const Placing& placing, MaterialId material) {
      if (context_.halted()) return false;
      add(content, placing, material, around);
      return true;
    });
  }

 private:
  static std::optional<Affined> world_from(const Placing& placing, const Surroundings& around) {
    if (!around.world_from_parent) return placing.parent_from_child;
    if (!placing.parent_from_child) return around.world_from_parent;
    return *around.world_from_parent * *placing.parent_from_child;
  }

  void add(const std::shared_ptr<const Group>& group, const Placing& placing, MaterialId material,
           const Surroundings& around) {
    walk(*group, {world_from(placing, around), material != kNoId ? material : around.material,
                  placing.name.empty() ? around.path : around.path + placing.name + "/"});
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

  template <class Kind>
  void add(const Kind& geometry, const Placing& placing, MaterialId material,
           const Surroundings& around) {
    Shape shape;
    shape.geometry = geometry;
    shape.world_from_object = world_from(placing, around);
    if (!is_sound(shape.world_from_object, placing.span)) return;
    if (material == kNoId) material = around.material;
    shape.material = used_.material(material != kNoId ? material : default_material());
    shape.span = placing.span;
    const ShapeId number = ++shape_counts_[shape.geometry.index()];
    if (placing.name.empty()) shape.number = number;
    shape.name = around.path + placing.name;
    // What the objects around it add to each name is not counted anywhere else.
    context_.spend_string(around.path.size(), placing.span);
    scene_.shapes.push_back(shape);
  }

  void add(const PlacedLight& placed, const Placing& placing, MaterialId,
           const Surroundings& around) {
    static constexpr const char* kKinds[] = {"point light",  "directional light", "spot light",
                                             "sphere light", "rectangle light",   "ambient light"};
    const auto map = world_from(placing, around);
    if (!is_sound(map, placing.span)) return;
    Light light;
    light.source = placed.source;
    if (map) {
      const auto moved = transformed(context_, placed.source, *map, placing.span);
      if (!moved) return;
      light.source = *moved;
    }
    light.casts_shadows = placed.casts_shadows;
    light.span = placing.span;
    const std::size_t kind = light.source.index();
    ++light_counts_[kind];
    light.name = around.path + (placing.name.empty()
                                    ? fmt::format("{} {}", kKinds[kind], light_counts_[kind])
                                    : placing.name);
    context_.spend_string(around.path.size(), placing.span);
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
    scene_.shapes.push_back(shape);
  }

  Context& context_;
  Scene& scene_;
  UsedRecords& used_;
  MaterialId default_material_ = kNoId;
  std::array<ShapeId, std::variant_size_v<Geometry>> shape_counts_{};
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

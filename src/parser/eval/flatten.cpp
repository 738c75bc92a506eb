// parser/eval: composing transforms, handing materials down, giving names.
#include "parser/eval/flatten.h"

#include <array>
#include <fmt/format.h>
#include <unordered_map>
#include <utility>

#include "core/base/overloaded.h"
#include "parser/eval/group_survey.h"
#include "parser/eval/kept_group.h"
#include "parser/eval/lower.h"
#include "parser/eval/used_records.h"

namespace alhazen::parser {
namespace {

// What a node has from the groups around it.
struct Surroundings {
  std::optional<Affined> frame_from_parent;  // of the world, or of the group that is being kept
  MaterialId material = kNoId;
  std::string path;  // "table/leg/"
};

class Flattener {
 public:
  Flattener(Context& context, const GroupSurvey& survey, Scene& scene, UsedRecords& used)
      : context_(context), survey_(survey), scene_(scene), used_(used) {}

  // As deep as objects nest (BlockBuilder bounds it).
  void walk(const Group& group, const Surroundings& around) {
    group.children.for_each([&](const auto& content, const Placing& placing, MaterialId material) {
      if (context_.halted()) return false;
      add(content, placing, material, around);
      return true;
    });
  }

 private:
  static std::optional<Affined> composed(const std::optional<Affined>& outer,
                                         const std::optional<Affined>& inner) {
    if (!outer) return inner;
    if (!inner) return outer;
    return *outer * *inner;
  }

  void add(const std::shared_ptr<const Group>& group, const Placing& placing, MaterialId material,
           const Surroundings& around) {
    const Surroundings inside{
        composed(around.frame_from_parent, placing.parent_from_child),
        material != kNoId ? material : around.material,
        placing.name.empty() ? around.path : around.path + placing.name + "/"};
    if (keeping_ == nullptr && inside.frame_from_parent && survey_.is_shared(*group)) {
      place(kept(group), inside, placing.span);
    } else {
      walk(*group, inside);
    }
  }

  const KeptGroup& kept(const std::shared_ptr<const Group>& group) {
    const auto [known, is_new] = kept_.try_emplace(group.get());
    if (is_new) {
      keeping_ = &known->second;
      walk(*group, {});
      keeping_ = nullptr;
      known->second.keep_long_runs(scene_.shapes, used_);
    }
    return known->second;
  }

  void place(const KeptGroup& group, const Surroundings& around, SourceSpan span) {
    const Affined& world_from_group = *around.frame_from_parent;
    if (!is_sound(world_from_group, span)) return;
    for (const KeptGroup::Part& part : group.parts()) {
      if (context_.halted()) return;
      if (const auto* light = std::get_if<KeptGroup::Light>(&part)) {
        Surroundings inside = around;
        inside.path += light->path;
        add(light->light, light->placing, kNoId, inside);
        continue;
      }
      const auto& run = std::get<KeptGroup::Run>(part);
      if (run.prototype) {
        add_instance(run, around, span);
        continue;
      }
      for (Shape shape : run.shapes) {
        shape.world_from_object = composed(world_from_group, shape.world_from_object);
        add_single(std::move(shape), around);
      }
    }
  }

  void add_instance(const KeptGroup::Run& run, const Surroundings& around, SourceSpan span) {
    context_.spend_string(around.path.size(), span);
    if (!has_room_for(run.size, span)) return;
    Instance instance;
    instance.world_from_group = *around.frame_from_parent;
    instance.prototype = *run.prototype;
    if (run.asks_for_material) instance.material = used_.material(worn(kNoId, around));
    instance.path = around.path;
    instance.span = span;
    instance.numbered_before = shape_counts_;
    scene_.shapes.push_back(instance);
    for (std::size_t kind = 0; kind < shape_counts_.size(); ++kind)
      shape_counts_[kind] += run.counts[kind];
  }

  // Each record of the scene counts once, and all copies have ids.
  bool has_room_for(std::size_t ids, SourceSpan span) {
    constexpr std::uint64_t kMostIds = (std::uint64_t{1} << 31) - 2;
    const std::uint64_t limit = context_.limits().shapes;
    if (++records_ > limit) {
      context_.halt<DiagnosticKind::too_many_shapes>(span, limit);
    } else if (scene_.shapes.size() + ids > kMostIds) {
      context_.halt<DiagnosticKind::too_many_shapes>(span, kMostIds);
    }
    return !context_.halted();
  }

  bool is_sound(const std::optional<Affined>& map, SourceSpan span) {
    if (!map || inverse(*map)) return true;
    context_.report<DiagnosticKind::singular_transform>(span, "all transforms together")
        .hint("no factor may be 0, and none so large or small that numbers do not hold it");
    return false;
  }

  MaterialId worn(MaterialId own, const Surroundings& around) {
    if (own != kNoId) return own;
    return around.material != kNoId ? around.material : default_material();
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
    shape.world_from_object = composed(around.frame_from_parent, placing.parent_from_child);
    if (!is_sound(shape.world_from_object, placing.span)) return;
    shape.material = material;
    shape.span = placing.span;
    shape.name = placing.name;
    shape.number = placing.name.empty() ? 1 : 0;
    if (keeping_ == nullptr) {
      add_single(std::move(shape), around);
      return;
    }
    if (material == kNoId) shape.material = around.material;
    shape.name = around.path + shape.name;
    context_.spend_string(around.path.size(), placing.span);
    if (has_room_for(1, placing.span)) keeping_->add(std::move(shape));
  }

  // A shape whose name and material are still those within `around`.
  void add_single(Shape shape, const Surroundings& around) {
    if (!has_room_for(1, shape.span)) return;
    shape.material = used_.material(worn(shape.material, around));
    const ShapeId number = ++shape_counts_[shape.geometry.index()];
    if (shape.number != 0) shape.number = number;
    shape.name = around.path + shape.name;
    // What the objects around it add to each name is not counted anywhere else.
    context_.spend_string(around.path.size(), shape.span);
    scene_.shapes.push_back(shape);
  }

  void add(const PlacedLight& placed, const Placing& placing, MaterialId,
           const Surroundings& around) {
    static constexpr const char* kKinds[] = {"point light",  "directional light", "spot light",
                                             "sphere light", "rectangle light",   "ambient light"};
    const auto map = composed(around.frame_from_parent, placing.parent_from_child);
    if (!is_sound(map, placing.span)) return;
    if (keeping_ != nullptr) {
      keeping_->add(KeptGroup::Light{placed, {map, placing.name, placing.span}, around.path});
      return;
    }
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
  const GroupSurvey& survey_;
  Scene& scene_;
  UsedRecords& used_;
  std::unordered_map<const Group*, KeptGroup> kept_;
  KeptGroup* keeping_ = nullptr;  // what shapes and lights go to: nothing, then to the scene
  std::uint64_t records_ = 0;
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
  Flattener(context, GroupSurvey(root), scene, used).walk(root, {});
}

}  // namespace alhazen::parser

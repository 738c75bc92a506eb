// parser/eval: a group that is kept once, as its places share it: runs of shapes, and between them
// what is placed each time anew, lights and planes.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/scene/scene.h"
#include "parser/eval/object.h"
#include "parser/eval/used_records.h"

namespace alhazen::parser {

class KeptGroup {
 public:
  // Shapes in the frame of the group; those without a material or a light get them where it is
  // placed. Names and numbers begin within the group.
  struct Run {
    ShapeList shapes;  // empty where there is a prototype
    std::size_t size = 0;
    std::array<ShapeId, std::variant_size_v<Geometry>> counts{};  // of each kind
    bool asks_for_material = false;
    bool has_bounds = true;                // no planes
    std::optional<PrototypeId> prototype;  // in the scene
  };
  struct Light {
    PlacedLight light;
    Placing placing;   // in the group
    std::string path;  // of the groups around it, within this one
  };
  using Part = std::variant<Run, Light>;

  const std::vector<Part>& parts() const { return parts_; }

  // In the order of the text. Materials are those of the store. A shape has a number if it has no
  // name; which one does not matter.
  void add(Shape shape);
  void add(Light light) { parts_.emplace_back(std::move(light)); }
  // Gives the runs that are long enough to the scene, as prototypes.
  void keep_long_runs(SceneShapes& scene, UsedRecords& used);

 private:
  std::vector<Part> parts_;
};

}  // namespace alhazen::parser

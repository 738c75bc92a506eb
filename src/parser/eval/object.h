// parser/eval: what bodies place: a tree of shapes, lights and groups, each with its transform to
// the frame of its parent. It becomes the lists of the scene in flatten.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/scene/light.h"
#include "core/scene/shape.h"

namespace alhazen::parser {

struct Group;

struct PlacedShape {
  Geometry geometry;
};
struct PlacedLight {
  LightSource source;
  bool casts_shadows = true;
  bool visible = false;  // area lights only
};

struct Node {
  std::variant<PlacedShape, PlacedLight, std::shared_ptr<const Group>> content;
  std::optional<Affined> parent_from_child;  // nothing: the identity
  MaterialId material = kNoId;               // in the evaluator's store; kNoId: the parent's
  std::string name;
  SourceSpan span;
};

struct Group {
  std::vector<Node> children;
  // Of the whole tree, this group included, and how deep it is: kept so that both can be bounded
  // where a tree is made, before anything walks it.
  std::uint64_t node_count = 1;
  int depth = 1;
};

}  // namespace alhazen::parser

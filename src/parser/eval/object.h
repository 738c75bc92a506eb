// parser/eval: what bodies place: a tree of shapes, lights and groups, each with its transform to
// the frame of its parent. It becomes the lists of the scene in flatten.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/chunked_vector.h"
#include "core/scene/light.h"
#include "core/scene/shape.h"

namespace alhazen::parser {

struct Group;

struct PlacedLight {
  LightSource source;
  bool casts_shadows = true;
  bool visible = false;  // area lights only
};

// How a node stands in its group.
struct Placing {
  std::optional<Affined> parent_from_child;  // nothing: the identity
  std::string name;
  SourceSpan span;
  friend bool operator==(const Placing&, const Placing&) = default;
};

struct Node {
  std::variant<Geometry, PlacedLight, std::shared_ptr<const Group>> content;
  Placing placing;
  MaterialId material = kNoId;  // in the evaluator's store; kNoId: the parent's
};

// The nodes of one group, in order. A loop may place a million balls: runs of one kind stand
// together without gaps, and what neighbours have in common is kept once.
class NodeList {
 public:
  std::size_t size() const { return size_; }
  void push_back(Node&& node);

  // visit(content, placing, material) for each node, with the content as one kind of geometry, a
  // light or a group, until it returns false.
  template <class Visit>
  void for_each(Visit visit) const {
    for (const AnyRun& run : runs_) {
      const bool goes_on = std::visit(
          [&](const auto& entries) {
            for (std::size_t i = 0; i < entries.size(); ++i) {
              const auto& entry = entries[i];
              if (!visit(entry.content, placings_[entry.placing], entry.material)) return false;
            }
            return true;
          },
          run);
      if (!goes_on) return;
    }
  }

  // visit(group) for each node that is a group.
  template <class Visit>
  void for_each_group(const Visit& visit) const {
    using Groups = Run<std::shared_ptr<const Group>>;
    for (const AnyRun& run : runs_) {
      const auto* groups = std::get_if<Groups>(&run);
      for (std::size_t i = 0; groups != nullptr && i < groups->size(); ++i)
        visit((*groups)[i].content);
    }
  }

 private:
  template <class Content>
  struct Entry {
    Content content;
    MaterialId material;
    std::uint32_t placing;
  };
  template <class Content>
  using Run = ChunkedVector<Entry<Content>>;
  template <class Variant>
  struct RunsOf;
  template <class... Kinds>
  struct RunsOf<std::variant<Kinds...>> {
    using Type = std::variant<Run<Kinds>..., Run<PlacedLight>, Run<std::shared_ptr<const Group>>>;
  };
  using AnyRun = RunsOf<Geometry>::Type;

  template <class Content>
  void append(Content content, MaterialId material);

  std::vector<AnyRun> runs_;
  std::vector<Placing> placings_;
  std::size_t size_ = 0;
};

struct Group {
  NodeList children;
  // Of the whole tree, this group included, what its children have in common counted once; and how
  // deep it is: kept so that both can be bounded where a tree is made, before anything walks it.
  std::uint64_t node_count = 1;
  int depth = 1;
};

}  // namespace alhazen::parser

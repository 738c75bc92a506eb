// render/shape: shapes whose surfaces are one and the same.
//
// Where two solids have one curved surface, which of them a ray meets first is beyond the digits of
// any point on it. So it is not asked: shapes that differ by less than the roundings of a point on
// them are one stack of layers, in an order that is a rule, and only the first of them in the scene
// is tested against rays; it stands in for the others. A ray from outside meets the outermost
// layer, one from inside the innermost, and from a layer it goes on to the next in its way
// (accel/twin_hits.h). docs/hard_cases.md tells more.
#pragma once

#include <functional>
#include <unordered_map>
#include <vector>

#include "core/scene/shape.h"
#include "render/shape/landmarks.h"

namespace alhazen::render {

class Twins {
 public:
  bool none() const { return stacks_.empty(); }

  bool has_twin(ShapeId id) const { return places_.contains(id); }
  // What is tested in place of the shape: mostly itself.
  ShapeId stand_in(ShapeId id) const {
    const auto place = places_.find(id);
    return place == places_.end() ? id : stacks_[place->second.stack].stand_in;
  }
  // Whether another shape stands in for it.
  bool is_hidden(ShapeId id) const { return !none() && stand_in(id) != id; }

  // The layer that a ray meets first at the surface of the shape.
  ShapeId first(ShapeId id, bool entering) const {
    const auto place = places_.find(id);
    if (place == places_.end()) return id;
    const auto& layers = stacks_[place->second.stack].layers;
    return entering ? layers.front() : layers.back();
  }
  // The layer that it meets after this one; kNoId if there is none.
  ShapeId after(ShapeId id, bool inward) const {
    const auto place = places_.find(id);
    if (place == places_.end()) return kNoId;
    const auto& layers = stacks_[place->second.stack].layers;
    const std::size_t layer = place->second.layer;
    if (inward) return layer + 1 < layers.size() ? layers[layer + 1] : kNoId;
    return layer > 0 ? layers[layer - 1] : kNoId;
  }

  // A stack of two shapes or more, those of the lowest rank(id) outermost, of equal ones the first
  // in the scene. That one stands in for all.
  void add(std::vector<ShapeId> layers, const std::function<int(ShapeId)>& rank);

  // The stacks of shapes that have other ids here, id_of(shape), and an order of their own: by
  // rank(id), then by id.
  void add(const Twins& others, const std::function<ShapeId(ShapeId)>& id_of,
           const std::function<int(ShapeId)>& rank);

 private:
  struct Stack {
    ShapeId stand_in;
    std::vector<ShapeId> layers;
  };
  struct Place {
    std::size_t stack, layer;
  };
  std::vector<Stack> stacks_;
  std::unordered_map<ShapeId, Place> places_;
};

// Whether the shapes are one surface, as far as the scalar type can tell: no landmarks differ by
// more than 16 ulp of the largest of them, nor by much beside the shape itself, as those of
// neighbours in a mesh far away do.
template <class Real>
bool are_twins(const Landmarks<Real>& a, const Landmarks<Real>& b);

// The time is that of sorting the shapes.
template <class Real>
Twins find_twins(ShapeId shapes, const std::function<Landmarks<Real>(ShapeId)>& landmarks_of,
                 const std::function<int(ShapeId)>& rank);

}  // namespace alhazen::render

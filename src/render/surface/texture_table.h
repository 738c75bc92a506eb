// render/surface: all textures of a scene, made ready for evaluation at millions of points.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/math/transform.h"
#include "core/scene/texture.h"
#include "render/simd/records.h"
#include "render/surface/gradient.h"
#include "render/surface/texture_image.h"
#include "render/surface/texture_pattern.h"
#include "render/surface/texture_point.h"

namespace alhazen::render {

enum class PatternKind : unsigned char { solid, checker, stripes, brick, gradient, image };

template <class Real>
class TextureTable {
 public:
  TextureTable() = default;
  // `images` by ImageId; their pixels must outlive the table. `world_offset` is the world position
  // of the origin of rebased points: world = rebased + world_offset. It is folded into the map of
  // world-mapped textures with the error of one rounding, so a pattern that was moved with the
  // scene keeps its bits. Textures that show one colour everywhere become solid: an image or a
  // gradient of one colour, a checker of two equal ones.
  TextureTable(std::span<const Texture> textures, std::span<const ImageView> images,
               Vec3d world_offset);

  // The colours at points, each of the texture `id` of its lane; of the lanes outside of the mask
  // they are black and their ids are not looked at. `with_images`: some may be images.
  template <class L = Real, bool with_images = true>
  Rgb<L> color(IntOf<L> id, const TexturePoint<L>& point, MaskOf<L> active = true) const;

  // The same where all these textures are solid: no point is needed.
  template <class L>
  Rgb<L> plain_color(const IntOf<L>& id, MaskOf<L> active) const {
    return gathered<L, Rgb>(colors_.data(), id, active);
  }

  // The colour of a texture that is the same everywhere: no point is needed for it.
  std::optional<Rgb<Real>> solid_color(TextureId id) const;

 private:
  struct Node {
    PatternKind kind = PatternKind::solid;
    Mapping mapping = Mapping::object;
    ImageWrap wrap = ImageWrap::repeat;
    ImageFilter filter = ImageFilter::bilinear;
    TextureId first = 0, second = 0;  // of a choice; for a gradient the range of its stops
    Affine<Real> pattern_from_mapped;
    Rgb<Real> color;  // solid
    Vec3<Real> size;  // brick
    Real mortar = 0;  // brick
    ImageView image;

    bool chooses() const {
      return kind == PatternKind::checker || kind == PatternKind::stripes ||
             kind == PatternKind::brick;
    }
  };

  Node make_node(const Texture& texture, std::span<const ImageView> images, Vec3d world_offset);
  Node choice(Node node, PatternKind kind, TextureId first, TextureId second) const;
  Node gradient(Node node, const GradientPattern& pattern);
  template <class L>
  static Vec3<L> pattern_point(const Node& node, const TexturePoint<L>& point);
  template <class L>
  static MaskOf<L> takes_second(const Node& node, Vec3<L> p);
  template <class L, bool with_images>
  Rgb<L> own_color(const Node& node, const TexturePoint<L>& point) const;

  std::vector<Node> nodes_;
  std::vector<Rgb<Real>> colors_;  // of the solid ones
  std::vector<ColorStop<Real>> stops_;
};

// No surface reflects more than it receives, whatever a picture of floats holds; a NaN reflects
// nothing (docs/physics.md).
template <class Real>
inline Rgb<Real> within_unit(Rgb<Real> color) {
  const auto channel = [](Real x) { return select(x > Real(0), smaller(x, Real(1)), Real(0)); };
  return {channel(color.r), channel(color.g), channel(color.b)};
}

template <class Real>
template <class L>
Vec3<L> TextureTable<Real>::pattern_point(const Node& node, const TexturePoint<L>& point) {
  const Affine<L> pattern_from_mapped(node.pattern_from_mapped);
  switch (node.mapping) {
    case Mapping::object:
      return pattern_from_mapped.point(point.object);
    case Mapping::world:
      return pattern_from_mapped.point(point.rebased);
    case Mapping::uv:
      break;
  }
  return pattern_from_mapped.point({point.u, point.v, L(0)});
}

// Of a texture that chooses among two others.
template <class Real>
template <class L>
MaskOf<L> TextureTable<Real>::takes_second(const Node& node, Vec3<L> p) {
  switch (node.kind) {
    case PatternKind::checker:
      return in_odd_cube(p);
    case PatternKind::stripes:
      return in_odd_cell(p.x);
    default:
      return in_mortar(p, Vec3<L>(node.size), L(node.mortar));
  }
}

// Of a texture that does not.
template <class Real>
template <class L, bool with_images>
Rgb<L> TextureTable<Real>::own_color(const Node& node, const TexturePoint<L>& point) const {
  if (node.kind == PatternKind::solid) return Rgb<L>(node.color);
  const Vec3<L> p = pattern_point(node, point);
  if constexpr (with_images) {
    if (node.kind == PatternKind::image)
      return within_unit(image_color(node.image, p.x, p.y, node.wrap, node.filter));
  }
  return gradient_color<L>({stops_.data() + node.first, stops_.data() + node.second}, p.x);
}

// A texture that chooses hands its lanes on to others, in a loop: lanes that come to the same
// texture go on together, and no depth of nesting needs a stack.
template <class Real>
template <class L, bool with_images>
Rgb<L> TextureTable<Real>::color(IntOf<L> id, const TexturePoint<L>& point,
                                 MaskOf<L> active) const {
  Rgb<L> result;
  while (any(active)) {
    const auto shared = first_of(id, active);
    const MaskOf<L> here = active && id == IntOf<L>(shared);
    const Node& node = nodes_[static_cast<std::size_t>(shared)];
    if (node.chooses()) {
      const MaskOf<L> second = takes_second(node, pattern_point(node, point));
      const IntOf<L> next = select(second, IntOf<L>(node.second), IntOf<L>(node.first));
      id = select(here, next, id);
    } else {
      result = select(here, own_color<L, with_images>(node, point), result);
      active = active && !here;
    }
  }
  return result;
}

extern template class TextureTable<float>;
extern template class TextureTable<double>;
#if ALHAZEN_HAS_QUAD
extern template class TextureTable<Quad>;
#endif

}  // namespace alhazen::render

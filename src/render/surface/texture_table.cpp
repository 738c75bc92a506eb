// render/surface: building the table of textures.
#include "render/surface/texture_table.h"

#include <algorithm>

#include "core/base/overloaded.h"
#include "core/math/error_free.h"

namespace alhazen::render {
namespace {

// pattern_from_rebased: M (p + offset) + t = M p + (M offset + t), the bracket in two words.
Affined folded_offset(Affined pattern_from_world, Vec3d offset) {
  for (auto& row : pattern_from_world.rows) {
    DoubleWord<double> sum{row[3], 0};
    for (int axis = 0; axis < 3; ++axis)
      sum = sum + two_product(row[static_cast<std::size_t>(axis)], offset[axis]);
    row[3] = sum.hi;
  }
  return pattern_from_world;
}

bool is_one_color(const ImageView& image) {
  const std::size_t floats =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3;
  for (std::size_t i = 3; i < floats; ++i) {
    if (image.rgb[i] != image.rgb[i % 3]) return false;
  }
  return true;
}

}  // namespace

template <class Real>
TextureTable<Real>::TextureTable(std::span<const Texture> textures,
                                 std::span<const ImageView> images, Vec3d world_offset) {
  nodes_.reserve(textures.size());
  for (const Texture& texture : textures) {
    nodes_.push_back(make_node(texture, images, world_offset));
    colors_.push_back(nodes_.back().color);
  }
}

template <class Real>
auto TextureTable<Real>::make_node(const Texture& texture, std::span<const ImageView> images,
                                   Vec3d world_offset) -> Node {
  Node node;
  node.mapping = texture.mapping;
  node.pattern_from_mapped = Affine<Real>(
      texture.mapping == Mapping::world ? folded_offset(texture.pattern_from_mapped, world_offset)
                                        : texture.pattern_from_mapped);
  const auto solid = [&node](Rgb<Real> color) {
    node.kind = PatternKind::solid;
    node.color = color;
    return node;
  };
  return std::visit(Overloaded{[&](const SolidPattern& p) { return solid(Rgb<Real>(p.color)); },
                               [&](const CheckerPattern& p) {
                                 return choice(node, PatternKind::checker, p.even, p.odd);
                               },
                               [&](const StripesPattern& p) {
                                 return choice(node, PatternKind::stripes, p.even, p.odd);
                               },
                               [&](const BrickPattern& p) {
                                 if (p.mortar_width == 0) return nodes_[p.brick];
                                 node.size = Vec3<Real>(p.size);
                                 node.mortar = static_cast<Real>(p.mortar_width);
                                 return choice(node, PatternKind::brick, p.brick, p.mortar);
                               },
                               [&](const GradientPattern& p) { return gradient(node, p); },
                               [&](const ImagePattern& p) {
                                 node.image = images[p.image];
                                 if (is_one_color(node.image))
                                   return solid(within_unit(image_pixel<Real>(node.image, 0, 0)));
                                 node.kind = PatternKind::image;
                                 node.wrap = p.wrap;
                                 node.filter = p.filter;
                                 return node;
                               }},
                    texture.pattern);
}

template <class Real>
auto TextureTable<Real>::choice(Node node, PatternKind kind, TextureId first,
                                TextureId second) const -> Node {
  const Node& a = nodes_[first];
  const Node& b = nodes_[second];
  const bool equal_solids =
      a.kind == PatternKind::solid && b.kind == PatternKind::solid && a.color == b.color;
  if (first == second || equal_solids) return a;  // whatever is chosen, it is this
  node.kind = kind;
  node.first = first;
  node.second = second;
  return node;
}

template <class Real>
auto TextureTable<Real>::gradient(Node node, const GradientPattern& pattern) -> Node {
  const auto& stops = pattern.stops;
  if (is_one_color(stops)) {
    node.kind = PatternKind::solid;
    node.color = Rgb<Real>(stops.front().color);
    return node;
  }
  node.kind = PatternKind::gradient;
  node.first = static_cast<TextureId>(stops_.size());
  for (const GradientStop& stop : stops)
    stops_.push_back({static_cast<Real>(stop.position), Rgb<Real>(stop.color)});
  node.second = static_cast<TextureId>(stops_.size());
  return node;
}

template <class Real>
std::optional<Rgb<Real>> TextureTable<Real>::solid_color(TextureId id) const {
  if (nodes_[id].kind != PatternKind::solid) return std::nullopt;
  return nodes_[id].color;
}

template class TextureTable<float>;
template class TextureTable<double>;
#if ALHAZEN_HAS_QUAD
template class TextureTable<Quad>;
#endif

}  // namespace alhazen::render

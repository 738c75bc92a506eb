// render/surface: all textures of a scene, made ready for evaluation at millions of points.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/math/transform.h"
#include "core/scene/texture.h"
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

  // The colour at a point. A texture that chooses among others hands the point on, in a loop.
  Rgb<Real> color(TextureId id, const TexturePoint<Real>& point) const;

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
  };

  Node make_node(const Texture& texture, std::span<const ImageView> images, Vec3d world_offset);
  Node choice(Node node, PatternKind kind, TextureId first, TextureId second) const;
  Node gradient(Node node, const GradientPattern& pattern);
  static Vec3<Real> pattern_point(const Node& node, const TexturePoint<Real>& point);

  std::vector<Node> nodes_;
  std::vector<ColorStop<Real>> stops_;
};

}  // namespace alhazen::render

// app/povray: patterns. POV-Ray evaluates a nested pattern in the frame of the one around it, after
// that one's transforms; ours all start from the point itself. So each gets the matrix from its own
// frame to that of the block it stands in.
#include <algorithm>

#include "app/povray/exporter.h"
#include "app/povray/uv_frame.h"
#include "core/base/overloaded.h"

namespace alhazen {
namespace {

// The frame of the block that a pattern stands in.
struct Place {
  const SurfaceFrame& surface;
  Affined block_from_frame;
};

// A pattern's coordinates as POV-Ray knows them: by a matrix, or as functions of the object point.
struct Coordinates {
  Affined block_from_pattern;  // the matrix to write
  Affined pattern_from_frame;  // for what stands inside
  // Of curved shapes: px, py, pz as functions of x, y, z.
  std::optional<std::array<std::string, 3>> functions;
  std::string warp;  // of pictures on curved shapes, a whole line; else empty
};

Affined inverse_of(const Affined& map) {
  return inverse(map).value_or(Affined{});  // the evaluator lets no singular map through
}

Coordinates linear(const Place& place, const Affined& pattern_from_frame) {
  return {place.block_from_frame * inverse_of(pattern_from_frame), pattern_from_frame, {}, ""};
}

std::string component(const std::array<double, 4>& row, const UvFrame& uv) {
  return fmt::format("({}*{} + {}*{} + {})", pov_number(row[0]), uv.u, pov_number(row[1]), uv.v,
                     pov_number(row[3]));
}

Coordinates coordinates(const Texture& texture, const Place& place) {
  const Affined& object_from_frame = inverse_of(place.surface.frame_from_object);
  const Affined& map = texture.pattern_from_mapped;
  if (texture.mapping == Mapping::object) return linear(place, map * object_from_frame);
  if (texture.mapping == Mapping::world) {
    return linear(place, map * inverse_of(place.surface.frame_from_world));
  }
  const UvFrame uv = uv_frame(place.surface.shape->geometry);
  if (uv.uv_from_object) return linear(place, map * *uv.uv_from_object * object_from_frame);
  Coordinates curved{place.block_from_frame * place.surface.frame_from_object, object_from_frame,
                     std::array<std::string, 3>{}, ""};
  for (std::size_t i = 0; i < 3; ++i)
    (*curved.functions)[i] = component(map.rows[i], uv);
  const bool is_image = std::holds_alternative<ImagePattern>(texture.pattern);
  if (is_image && uv.warp != nullptr) {
    // Modifiers work from the last to the first: the point is wrapped, then turned into the
    // pattern's coordinates. Its third coordinate is the distance from the axis or
    // middle, ours is 0: it is made too small to be seen when `map` turns it into the others.
    constexpr double kFlat = 1e-9;
    curved.warp = fmt::format("{} warp {{ {} orientation z dist_exp 0 }}",
                              pov_matrix(inverse_of(map * scaling({1, 1, kFlat}))), uv.warp);
    curved.block_from_pattern = curved.block_from_pattern * uv.object_from_warped;
  }
  return curved;
}

// 0 where the cell is even, 1/2 where it is odd: between the steps of kHalves.
std::string parity(const std::string& cells) {
  return fmt::format("function {{ 0.5*({0} - 2*floor(({0})/2)) }}", cells);
}

class TextureExport {
 public:
  TextureExport(Exporter& exporter, const LeafWriter& leaf) : exporter_(exporter), leaf_(leaf) {}

  // What stands between the braces of one block.
  void body(TextureId id, const Place& place) {
    const Texture& texture = exporter_.scene.textures[id];
    if (exporter_.solid[id]) return leaf_.color(exporter_, *exporter_.solid[id]);
    const Coordinates at = coordinates(texture, place);
    const Place inside{place.surface, at.pattern_from_frame};
    std::visit(Overloaded{[](const SolidPattern&) {},
                          [&](const CheckerPattern& p) { checker(p, at, inside); },
                          [&](const StripesPattern& p) { stripes(p, at, inside); },
                          [&](const BrickPattern& p) { brick(p, at, inside); },
                          [&](const GradientPattern& p) { gradient(p, at); },
                          [&](const ImagePattern& p) { image(texture, p, at); }},
               texture.pattern);
  }

 private:
  PovWriter& out() { return exporter_.out; }

  void place(const Coordinates& at) {
    if (!(at.block_from_pattern == Affined{})) out().line(pov_matrix(at.block_from_pattern));
  }

  // Two blocks one after the other, as POV-Ray's checker and brick take them.
  void pair(TextureId first, TextureId second, const Place& inside) {
    for (const TextureId id : {first, second}) {
      out().open(leaf_.block());
      body(id, inside);
      out().close();
    }
  }

  // A map with a step from `first` to `second`.
  void step(TextureId first, TextureId second, const Place& inside) {
    out().open(fmt::format("{}_map", leaf_.block()));
    for (const TextureId id : {first, second}) {
      out().line("[0.25");
      body(id, inside);
      out().line("]");
    }
    out().close();
  }

  void checker(const CheckerPattern& p, const Coordinates& at, const Place& inside) {
    if (at.functions) {
      const auto& [x, y, z] = *at.functions;
      out().line(parity(fmt::format("(floor({}) + floor({}) + floor({}))", x, y, z)));
      step(p.even, p.odd, inside);
    } else {
      out().line("checker");
      pair(p.even, p.odd, inside);
    }
    place(at);
  }

  void stripes(const StripesPattern& p, const Coordinates& at, const Place& inside) {
    out().line(parity(fmt::format("floor({})", at.functions ? (*at.functions)[0] : "x")));
    step(p.even, p.odd, inside);
    place(at);
  }

  void brick(const BrickPattern& p, const Coordinates& at, const Place& inside) {
    const std::string size =
        fmt::format("brick_size {} mortar {}", pov_vector(p.size), pov_number(p.mortar_width));
    if (at.functions) {
      const auto& [x, y, z] = *at.functions;
      // A function cannot be declared twice, but forgotten.
      out().line(fmt::format("#declare wall = function {{ pattern {{ brick {} }} }}", size));
      out().line(fmt::format("function {{ 0.5*wall({}, {}, {}) }}", x, y, z));
      out().line("#undef wall");  // POV-Ray declares no function twice
      out().line("#undef wall");
      step(p.mortar, p.brick, inside);
    } else {
      out().line("brick");
      pair(p.mortar, p.brick, inside);
      out().line(size);
    }
    place(at);
  }

  void gradient(const GradientPattern& p, const Coordinates& at) {
    const GradientScale scale(p.stops);
    out().line(scale.function(at.functions ? (*at.functions)[0] : "x"));
    out().open(fmt::format("{}_map", leaf_.block()));
    for (const GradientStop& stop : p.stops) {
      out().line("[" + scale.place(stop));
      leaf_.color(exporter_, stop.color);
      out().line("]");
    }
    out().close();
    place(at);
  }

  void image(const Texture& texture, const ImagePattern& p, const Coordinates& at) {
    if (p.wrap != ImageWrap::repeat) {
      exporter_.deviate(DeviationKind::mirrored_image, texture.span);
    }
    if (at.functions && at.warp.empty()) {
      exporter_.deviate(DeviationKind::uv_image, texture.span);
    }
    leaf_.image(exporter_, texture, at.warp);
    place(at);
  }

  Exporter& exporter_;
  const LeafWriter& leaf_;
};

}  // namespace

GradientScale::GradientScale(const std::vector<GradientStop>& stops) {
  const double first = stops.front().position, last = stops.back().position;
  const double span = last > first ? last - first : 1;
  low_ = first - span / 2;
  width_ = 2 * span;
}

std::string GradientScale::place(const GradientStop& stop) const {
  return pov_number((stop.position - low_) / width_);
}

std::string GradientScale::function(const std::string& x) const {
  return fmt::format("function {{ min(1, max(0, ({} - {})/{})) }}", x, pov_number(low_),
                     pov_number(width_));
}

void export_texture(Exporter& exporter, TextureId id, const SurfaceFrame& frame,
                    const LeafWriter& leaf) {
  TextureExport(exporter, leaf).body(id, {frame, Affined{}});
}

}  // namespace alhazen

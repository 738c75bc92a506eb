// app/povray: what the parts of the exporter share: the scene, the text so far, the report so far.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "app/povray/export_pov.h"
#include "app/povray/pov_writer.h"
#include "core/scene/effect.h"
#include "core/scene/live.h"

namespace alhazen {

struct Exporter {
  const Scene& scene;
  const SourceManager& sources;
  const std::vector<render::ImagePixels>& images;
  std::string stem;
  EffectSet effects;
  SolidColors solid;
  Rgbd ambient;  // of all ambient lights that shine
  PovWriter out;
  std::vector<Deviation> deviations;
  std::set<std::tuple<DeviationKind, FileId, std::uint32_t>> known_deviations;

  // Each kind is reported once for a line.
  void deviate(DeviationKind kind, SourceSpan span);
  std::string image_name(ImageId id) const;
  std::string sky_name() const;  // of the background's picture
};

// "scene.scn:12 sphere `ball`": what stands above an object.
std::string origin_of(const Exporter& exporter, SourceSpan span, std::string_view what);

void export_settings(Exporter& exporter);
void export_camera(Exporter& exporter);
void export_background(Exporter& exporter);
void export_lights(Exporter& exporter);
void export_shapes(Exporter& exporter);

// Where a surface's patterns live.
struct SurfaceFrame {
  // The frame in which the texture is written, as seen from the shape's object frame and from the
  // world.
  Affined frame_from_object, frame_from_world;
  const Shape* shape;  // for its own coordinates
};

// texture { ... } and interior { ... } of a material.
void export_material(Exporter& exporter, const Material& material, const SurfaceFrame& frame);
// Whether the material looks the same in the object frame of every shape.
bool is_shareable(const Exporter& exporter, const Material& material);

// POV-Ray's maps go from 0 to 1. The stops of a gradient go into the middle half of it: several may
// stand at its first or last place, and POV-Ray sees only what lies beyond them as beyond.
class GradientScale {
 public:
  explicit GradientScale(const std::vector<GradientStop>& stops);
  // The place of a stop, as a number.
  std::string place(const GradientStop& stop) const;
  // That of the expression `x`, as a pattern.
  std::string function(const std::string& x) const;

 private:
  double low_, width_;
};

// What a pattern is made of where it is a single colour: writes whole blocks.
class LeafWriter {
 public:
  virtual ~LeafWriter() = default;
  // "pigment" or "texture": what nests and what maps are of.
  virtual const char* block() const = 0;
  virtual void color(Exporter& exporter, Rgbd color) const = 0;
  virtual void image(Exporter& exporter, const Texture& texture,
                     const std::string& placed) const = 0;
};
// Writes the blocks of a texture's tree.
void export_texture(Exporter& exporter, TextureId id, const SurfaceFrame& frame,
                    const LeafWriter& leaf);

}  // namespace alhazen

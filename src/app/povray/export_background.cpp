// app/povray: what is seen where nothing is.
#include "app/povray/exporter.h"
#include "core/base/overloaded.h"

namespace alhazen {
namespace {

void gradient(PovWriter& out, const GradientBackground& background) {
  const GradientScale scale(background.stops);
  out.open("sky_sphere");
  out.open("pigment");
  // y of a unit direction is the sine of its elevation.
  out.line(scale.function("y"));
  out.open("color_map");
  for (const GradientStop& stop : background.stops) {
    out.line(fmt::format("[{} color {}]", scale.place(stop), pov_color(stop.color)));
  }
  out.close();
  out.close();
  out.close();
}

// POV-Ray's u grows from +x through +z; ours has its middle in +z and grows towards +x, and all of
// that turned by `rotation_deg`. The file has the intensity in it: a sky_sphere has none of its
// own.
void environment(Exporter& exporter, const EnvironmentBackground& background) {
  PovWriter& out = exporter.out;
  out.open("sky_sphere");
  out.open("pigment");
  out.line(fmt::format("image_map {{ exr \"{}\" gamma 1 map_type 1 interpolate 2 }}",
                       exporter.sky_name()));
  out.line(pov_matrix(Affined({{{0, 0, -1, 0}, {0, 1, 0, 0}, {-1, 0, 0, 0}}})));
  out.line(fmt::format("rotate y*{}", pov_number(background.rotation_deg)));
  out.close();
  out.close();
}

}  // namespace

void export_background(Exporter& exporter) {
  const Background& background = exporter.scene.background;
  if (!exporter.effects.has(Effect::background)) return;
  exporter.out.comment(origin_of(exporter, background.span, "background"));
  std::visit(Overloaded{[&](const SolidBackground& b) {
                          exporter.out.line(fmt::format("background {{ {} }}", pov_color(b.color)));
                        },
                        [&](const GradientBackground& b) { gradient(exporter.out, b); },
                        [&](const EnvironmentBackground& b) { environment(exporter, b); }},
             background.source);
  exporter.out.blank();
}

}  // namespace alhazen

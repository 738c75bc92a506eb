// app/povray: lights.
#include <algorithm>

#include "app/povray/exporter.h"
#include "app/povray/reach.h"
#include "core/base/overloaded.h"

namespace alhazen {
namespace {

// POV-Ray's fade is 2 / (1 + (d / distance)^2). With a distance far below every d that is seen it
// is the inverse square to (distance / d)^2, relative.
constexpr double kFadeDistance = 1e-4;
constexpr double kWidestSpotDeg = 89.9;
// A power of two, for which POV-Ray weighs all points of the grid alike.
constexpr int kGrid = 16;

std::string faded(Rgbd intensity) {
  return fmt::format("{} fade_power 2 fade_distance {}",
                     pov_color(intensity / (2 * kFadeDistance * kFadeDistance)),
                     pov_number(kFadeDistance));
}
std::string fading(Rgbd intensity, Falloff falloff) {
  return falloff == Falloff::none ? pov_color(intensity) : faded(intensity);
}

class LightExport {
 public:
  LightExport(Exporter& exporter, const Light& light) : exporter_(exporter), light_(light) {}

  void write(const PointLight& l) {
    begin(l.position, fading(l.intensity, l.falloff));
    end();
  }
  void write(const DirectionalLight& l) {
    const Vec3d eye = exporter_.scene.camera.frame.position;
    begin(eye - kFarAway * l.direction, pov_color(l.irradiance));
    out().line("parallel point_at " + pov_vector(eye));
    end();
  }
  // Between the two angles both fade by a smoothstep in the cosine; tightness 0 adds nothing to it.
  void write(const SpotLight& l) {
    if (l.outer_angle_deg > kWidestSpotDeg) {
      exporter_.deviate(DeviationKind::wide_spot, light_.span);
    }
    begin(l.position, fading(l.intensity, l.falloff));
    out().line(fmt::format("spotlight point_at {} radius {} falloff {} tightness 0",
                           pov_vector(l.position + l.axis),
                           pov_number(std::min(l.inner_angle_deg, kWidestSpotDeg)),
                           pov_number(std::min(l.outer_angle_deg, kWidestSpotDeg))));
    end();
  }
  // From afar a sphere gives as much light as a point of intensity radiance * pi * radius^2.
  void write(const SphereLight& l) {
    exporter_.deviate(DeviationKind::sphere_light, light_.span);
    begin(l.center, faded(pi<double>() * l.radius * l.radius * l.radiance));
    out().line(fmt::format("area_light {}, {}, {}, {} circular orient area_illumination on",
                           pov_vector({2 * l.radius, 0, 0}), pov_vector({0, 2 * l.radius, 0}),
                           kGrid, kGrid));
    end();
  }
  void write(const RectangleLight& l) {
    exporter_.deviate(DeviationKind::rectangle_light, light_.span);
    begin(l.corner + 0.5 * (l.edge_u + l.edge_v),
          faded(length(cross(l.edge_u, l.edge_v)) * l.radiance));
    out().line(fmt::format("area_light {}, {}, {}, {} area_illumination on", pov_vector(l.edge_u),
                           pov_vector(l.edge_v), kGrid, kGrid));
    end();
  }
  // In the finish of every surface that answers to it.
  void write(const AmbientLight&) {}

 private:
  PovWriter& out() { return exporter_.out; }

  void begin(Vec3d position, const std::string& color) {
    exporter_.out.comment(origin_of(exporter_, light_.span, "light"));
    out().open("light_source");
    out().line(pov_vector(position) + ", " + color);
  }
  void end() {
    if (std::holds_alternative<SpotLight>(light_.source) && !light_.casts_shadows) {
      exporter_.deviate(DeviationKind::shadowless_spot, light_.span);
    } else if (!light_.casts_shadows) {
      out().line("shadowless");
      if (exporter_.effects.has(Effect::highlights)) {
        exporter_.deviate(DeviationKind::shadowless_highlight, light_.span);
      }
    }
    out().close();
  }

  Exporter& exporter_;
  const Light& light_;
};

}  // namespace

void export_lights(Exporter& exporter) {
  for (const Light& light : exporter.scene.lights) {
    if (!shines(light)) continue;
    std::visit([&](const auto& l) { LightExport(exporter, light).write(l); }, light.source);
  }
  if (!exporter.scene.lights.empty()) exporter.out.blank();
}

}  // namespace alhazen

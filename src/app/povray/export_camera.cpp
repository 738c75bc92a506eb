// app/povray: the camera. All four vectors are given, so that nothing is left to POV-Ray's order of
// statements: a ray goes along direction + x right + y up, x and y in [-1/2, 1/2].
#include <algorithm>

#include "app/povray/exporter.h"
#include "core/base/overloaded.h"
#include "core/math/elementary.h"

namespace alhazen {
namespace {

void export_lens(Exporter& exporter, const CameraFrame& frame, const ThinLens& lens) {
  exporter.deviate(DeviationKind::lens, exporter.scene.camera.span);
  exporter.out.line(fmt::format("aperture {}", pov_number(2 * lens.aperture_radius)));
  exporter.out.line("focal_point " +
                    pov_vector(frame.position + lens.focus_distance * frame.forward));
  exporter.out.line(
      fmt::format("blur_samples {}  variance 0", std::max(4, exporter.scene.settings.samples)));
}

}  // namespace

void export_camera(Exporter& exporter) {
  const Camera& camera = exporter.scene.camera;
  const CameraFrame& frame = camera.frame;
  const RenderSettings& settings = exporter.scene.settings;
  const double height_per_width = static_cast<double>(settings.height) / settings.width;
  PovWriter& out = exporter.out;
  out.comment(origin_of(exporter, camera.span, "camera"));
  out.open("camera");
  const auto* perspective = std::get_if<PerspectiveCamera>(&camera.projection);
  double width = 1;
  if (const auto* parallel = std::get_if<OrthographicCamera>(&camera.projection)) {
    width = parallel->width;
  }
  out.line(perspective != nullptr ? "perspective" : "orthographic");
  out.line("location " + pov_vector(frame.position));
  out.line("right " + pov_vector(width * frame.right));
  out.line("up " + pov_vector(width * height_per_width * frame.up));
  if (perspective == nullptr) {
    out.line("direction " + pov_vector(frame.forward));
  } else {
    const SinCos<double> half_angle = sin_cos_of_turns(perspective->fov_deg / 720);
    const double distance = 0.5 * half_angle.cos / half_angle.sin;
    out.line(fmt::format("direction {}  // {} degrees across", pov_vector(distance * frame.forward),
                         pov_number(perspective->fov_deg)));
    if (perspective->lens && perspective->lens->aperture_radius > 0) {
      export_lens(exporter, frame, *perspective->lens);
    }
  }
  out.close();
}

}  // namespace alhazen

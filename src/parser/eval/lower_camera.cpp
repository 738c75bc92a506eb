// parser/eval: the camera.
#include "parser/eval/direction.h"
#include "parser/eval/lower.h"

namespace alhazen::parser {
namespace {

std::optional<CameraFrame> lower_frame(Context& context, const Properties& p) {
  const Vec3d position = p.vec3("position"), up = p.vec3("up");
  const Vec3d target = p.has("look_at") ? p.vec3("look_at") : position + Vec3d{0, 0, 1};
  const Vec3d view = target - position;
  if (is_zero(view)) {
    context.report<DiagnosticKind::same_point>(p.span("look_at"), "camera", "look_at", "position")
        .label(p.span("position"), "`position` is here");
    return std::nullopt;
  }
  if (is_parallel(up, view)) {
    Diagnostic& d = context.report<DiagnosticKind::up_along_view>(p.span("up"));
    if (p.has("look_at")) d.label(p.span("look_at"), "it looks towards this");
    d.hint("looking straight up or down needs another `up`, for instance `up z`");
    return std::nullopt;
  }
  // Left-handed: x = cross(y, z), so right = cross(up, forward).
  CameraFrame frame;
  frame.position = position;
  frame.forward = unit_direction(view);
  frame.right = unit_direction(cross(unit_direction(up), frame.forward));
  frame.up = cross(frame.forward, frame.right);
  return frame;
}

std::optional<ThinLens> lower_lens(Context& context, const Properties& p,
                                   const CameraFrame& frame) {
  if (p.has("focus") && p.has("focus_on")) {
    context
        .report<DiagnosticKind::one_or_the_other>(p.find("focus_on")->name_span, "lens", "focus",
                                                  "focus_on")
        .label(p.find("focus")->name_span, "`focus` is here");
    return std::nullopt;
  }
  if (!p.has("focus") && !p.has("focus_on")) {
    context.report<DiagnosticKind::lens_without_focus>(p.head()).hint(
        "write `focus`, a distance, or `focus_on`, a point");
    return std::nullopt;
  }
  if (p.has("focus")) return ThinLens{p.number("aperture"), p.number("focus")};
  const double distance = dot(p.vec3("focus_on") - frame.position, frame.forward);
  if (!(distance > 0)) {
    context.report<DiagnosticKind::focus_behind>(p.span("focus_on"));
    return std::nullopt;
  }
  return ThinLens{p.number("aperture"), distance};
}

}  // namespace

std::optional<Camera> lower_camera(Context& context, const Properties& properties) {
  auto frame = lower_frame(context, properties);
  if (!frame) return std::nullopt;
  Camera out;
  out.span = properties.head();
  if (properties.schema().name == "orthographic") {
    out.projection = OrthographicCamera{properties.number("width")};
  } else {
    PerspectiveCamera perspective{properties.angle_deg("fov"), std::nullopt};
    if (const Property* lens = properties.find("lens")) {
      perspective.lens = lower_lens(context, *lens->block, *frame);
      if (!perspective.lens) return std::nullopt;
    }
    out.projection = perspective;
  }
  // Only moves and turns: the frame stays orthonormal to rounding.
  const auto map = lower_transform(context, properties);
  if (!map) return std::nullopt;
  if (!(*map == Affined())) {
    frame->position = map->point(frame->position);
    frame->right = unit_direction(map->vector(frame->right));
    frame->up = unit_direction(map->vector(frame->up));
    frame->forward = unit_direction(map->vector(frame->forward));
  }
  out.frame = *frame;
  return out;
}

}  // namespace alhazen::parser

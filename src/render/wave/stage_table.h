// render/wave: from the names of stages to the functions that are the stages.
#pragma once

#include <vector>

#include "render/wave/stage_camera.h"
#include "render/wave/stage_decisions.h"
#include "render/wave/stage_glass.h"
#include "render/wave/stage_hits.h"
#include "render/wave/stage_light.h"
#include "render/wave/stage_pov.h"
#include "render/wave/stage_reflect.h"
#include "render/wave/stage_shadow.h"

namespace alhazen::render {

template <class Real>
struct StageCall {
  using Function = void (*)(Wave<Real>&);
  StageId id;
  Function function;
};

template <class Real>
typename StageCall<Real>::Function stage_function(StageId id) {
  switch (id) {
    case StageId::pinhole_rays:
    case StageId::parallel_rays:
      return start_camera_rays<Real>;
    case StageId::lens_rays:
      return start_lens_rays<Real>;
    case StageId::camera_media:
      return find_camera_media<Real>;
    case StageId::closest_hits:
      return find_closest_hits<Real>;
    case StageId::interfaces:
      return find_interfaces<Real>;
    case StageId::absorb:
      return absorb<Real>;
    case StageId::escape:
      return add_background<Real>;
    case StageId::surfaces:
      return find_surfaces<Real, false>;
    case StageId::textured_surfaces:
      return find_surfaces<Real, true>;
    case StageId::plain_colors:
      return find_plain_colors<Real>;
    case StageId::textured_colors:
      return find_textured_colors<Real>;
    case StageId::sign_hits:
      return sign_hits<Real>;
    case StageId::sign_lights:
      return sign_lights<Real>;
    case StageId::weigh_hits:
      return weigh_hits<Real>;
    case StageId::weigh_lights:
      return weigh_lights<Real>;
    case StageId::emission:
      return add_emission<Real>;
    case StageId::ambient_on_matte:
      return add_ambient<Real, MatteResponse>;
    case StageId::ambient_on_glossy:
      return add_ambient<Real, GlossyResponse>;
    case StageId::ambient_on_coat:
      return add_ambient<Real, CoatResponse>;
    case StageId::ambient_on_pov:
      return add_ambient<Real, PovResponse>;
    case StageId::point_on_matte:
      return shine_points<Real, MatteResponse>;
    case StageId::point_on_glossy:
      return shine_points<Real, GlossyResponse>;
    case StageId::point_on_coat:
      return shine_points<Real, CoatResponse>;
    case StageId::point_on_pov:
      return shine_points<Real, PovResponse>;
    case StageId::directional_on_matte:
      return shine_directionals<Real, MatteResponse>;
    case StageId::directional_on_glossy:
      return shine_directionals<Real, GlossyResponse>;
    case StageId::directional_on_coat:
      return shine_directionals<Real, CoatResponse>;
    case StageId::directional_on_pov:
      return shine_directionals<Real, PovResponse>;
    case StageId::spot_on_matte:
      return shine_spots<Real, MatteResponse>;
    case StageId::spot_on_glossy:
      return shine_spots<Real, GlossyResponse>;
    case StageId::spot_on_coat:
      return shine_spots<Real, CoatResponse>;
    case StageId::spot_on_pov:
      return shine_spots<Real, PovResponse>;
    case StageId::sphere_on_matte:
      return shine_spheres<Real, MatteResponse>;
    case StageId::sphere_on_glossy:
      return shine_spheres<Real, GlossyResponse>;
    case StageId::sphere_on_coat:
      return shine_spheres<Real, CoatResponse>;
    case StageId::sphere_on_pov:
      return shine_spheres<Real, PovResponse>;
    case StageId::rectangle_on_matte:
      return shine_rectangles<Real, MatteResponse>;
    case StageId::rectangle_on_glossy:
      return shine_rectangles<Real, GlossyResponse>;
    case StageId::rectangle_on_coat:
      return shine_rectangles<Real, CoatResponse>;
    case StageId::rectangle_on_pov:
      return shine_rectangles<Real, PovResponse>;
    case StageId::unshadowed:
      return add_unshadowed<Real>;
    case StageId::opaque_shadows:
      return add_past_opaque<Real>;
    case StageId::tinted_shadows:
      return add_through_glass<Real>;
    case StageId::mirror:
      return reflect_in_mirrors<Real>;
    case StageId::metal:
      return reflect_in_metals<Real>;
    case StageId::coat:
      return reflect_in_coats<Real>;
    case StageId::glass:
      return refract_in_glass<Real>;
    case StageId::pov_glow:
      return add_pov_glow<Real>;
    case StageId::pov_reflection:
      return reflect_as_pov<Real>;
    case StageId::pov_transmission:
      return transmit_as_pov<Real>;
  }
  return nullptr;
}

template <class Real>
std::vector<StageCall<Real>> stage_functions(const std::vector<PlannedStage>& planned) {
  std::vector<StageCall<Real>> calls;
  for (const PlannedStage& stage : planned) {
    calls.push_back({stage.id, stage_function<Real>(stage.id)});
  }
  return calls;
}

}  // namespace alhazen::render

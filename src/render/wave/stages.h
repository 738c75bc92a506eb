// render/wave: every stage as a function: declared here for the table, defined in the file that
// stage.def names.
#pragma once

#include "core/math/scalar.h"
#include "render/wave/plan.h"

namespace alhazen::render {

template <class Real>
struct Wave;

template <class Real>
using StageFunction = void (*)(Wave<Real>&);

// The files stage_*.cpp. Each is compiled by itself, so that the code of a stage does not depend on
// what other files a build has: what a compiler inlines goes by all that it sees (bench/effects).
enum class StageHome {
  camera,
  lens,
  hits,
  interfaces,
  escape,
  surfaces,
  textures,
  decisions,
  ambient,
  point,
  directional,
  spot,
  sphere,
  rectangle,
  unshadowed,
  shadows,
  tinted,
  reflect,
  glass,
  pov,
  none  // of what is no loop over rays; the last, for stage_table.h counts by it
};

// What each of those files has: the function of a stage, or null for one that stands elsewhere or
// that this build leaves out, whose code is not even instantiated.
template <StageHome home>
struct StagesOf {
  static StageFunction<float> function(StageId id, float);
  static StageFunction<double> function(StageId id, double);
#if ALHAZEN_HAS_QUAD
  static StageFunction<Quad> function(StageId id, Quad);
#endif
};

// How surfaces answer to light (lit_surfaces.h).
template <class L>
struct MatteResponse;
template <class L>
struct GlossyResponse;
template <class L>
struct CoatResponse;
template <class L>
struct PovResponse;

template <class Real>
void place_by_filter(Wave<Real>& wave);
template <class Real>
void start_camera_rays(Wave<Real>& wave);
template <class Real>
void start_lens_rays(Wave<Real>& wave);
template <class Real>
void find_camera_media(Wave<Real>& wave);

template <class Real>
void find_closest_hits(Wave<Real>& wave);
template <class Real>
void find_interfaces(Wave<Real>& wave);
template <class Real>
void absorb(Wave<Real>& wave);
template <class Real>
void add_background(Wave<Real>& wave);
template <class Real>
void add_environment(Wave<Real>& wave);

template <class Real, bool with_coordinates>
void find_surfaces(Wave<Real>& wave);
template <class Real>
void find_plain_colors(Wave<Real>& wave);
template <class Real>
void find_textured_colors(Wave<Real>& wave);

template <class Real>
void sign_hits(Wave<Real>& wave);
template <class Real>
void sign_lights(Wave<Real>& wave);
template <class Real>
void weigh_hits(Wave<Real>& wave);
template <class Real>
void weigh_lights(Wave<Real>& wave);

template <class Real>
void add_emission(Wave<Real>& wave);
template <class Real>
void add_pov_glow(Wave<Real>& wave);
template <class Real, template <class> class Response>
void add_ambient(Wave<Real>& wave);
template <class Real, template <class> class Response>
void shine_points(Wave<Real>& wave);
template <class Real, template <class> class Response>
void shine_directionals(Wave<Real>& wave);
template <class Real, template <class> class Response>
void shine_spots(Wave<Real>& wave);
template <class Real, template <class> class Response>
void shine_spheres(Wave<Real>& wave);
template <class Real, template <class> class Response>
void shine_rectangles(Wave<Real>& wave);

template <class Real>
void add_unshadowed(Wave<Real>& wave);
template <class Real>
void add_past_opaque(Wave<Real>& wave);
template <class Real>
void add_through_glass(Wave<Real>& wave);

template <class Real>
void reflect_in_mirrors(Wave<Real>& wave);
template <class Real>
void reflect_in_metals(Wave<Real>& wave);
template <class Real>
void reflect_in_coats(Wave<Real>& wave);
template <class Real>
void refract_in_glass(Wave<Real>& wave);
template <class Real>
void reflect_as_pov(Wave<Real>& wave);
template <class Real>
void transmit_as_pov(Wave<Real>& wave);

}  // namespace alhazen::render

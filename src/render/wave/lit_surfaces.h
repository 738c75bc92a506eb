// render/wave: light that shines on surfaces that scatter it: how each kind of surface answers.
// Nothing is traced here; what would arrive goes to the queue that the shadow stages work off.
#pragma once

#include "render/wave/meeting.h"

namespace alhazen::render {

// One light seen from points of surfaces that face it.
template <class L>
struct Illumination {
  Vec3<L> normal, to_view;
  LightSample<L> light;
  L cosine;  // of the light with the normal, > 0
  bool casts_shadows;
};

// The surfaces at several hits, where `active`.
template <class L>
struct LitSurfaces {
  LitSurfaces(const Wave<ScalarOf<L>>& wave, const Entries<L>& hits, MaskOf<L> which)
      : materials(wave.world.materials),
        material(hits.of(wave.hits.material)),
        active(which),
        color(hits.of(wave.hits.color)) {}

  template <class Member>
  auto records(Member member) const {
    return materials.template records_of<L>(member, material, active);
  }

  const MaterialTable<ScalarOf<L>>& materials;
  IntOf<L> material;
  MaskOf<L> active;
  Rgb<L> color;
};

// How a kind of surface answers to light: scattered() is the radiance that it adds; even_sky() what
// radiance 1 from everywhere adds.
template <class L>
struct MatteResponse {
  static constexpr SurfaceKind kKind = SurfaceKind::matte;
  static Rgb<L> scattered(const LitSurfaces<L>& surface, const Illumination<L>& at) {
    return at.cosine * at.light.weight * (surface.color / pi<L>());
  }
  static Rgb<L> even_sky(const LitSurfaces<L>& surface, const L&) { return surface.color; }
};

template <class L>
struct GlossyResponse {
  static constexpr SurfaceKind kKind = SurfaceKind::glossy;
  static Rgb<L> scattered(const LitSurfaces<L>& surface, const Illumination<L>& at) {
    const HighlightLobe<L> lobe = surface.records(&MaterialRecord<ScalarOf<L>>::lobe);
    const Rgb<L> value =
        surface.color / pi<L>() + highlight_value(lobe, at.normal, at.to_view, at.light.direction);
    return at.cosine * at.light.weight * value;
  }
  // Highlights answer to lights that have a place; an even sky would only make the surface
  // brighter.
  static Rgb<L> even_sky(const LitSurfaces<L>& surface, const L&) { return surface.color; }
};

template <class L>
struct CoatResponse {
  static constexpr SurfaceKind kKind = SurfaceKind::coat;
  static Rgb<L> scattered(const LitSurfaces<L>& surface, const Illumination<L>& at) {
    return at.cosine * at.light.weight *
           coat_diffuse_value(layer(surface), surface.color, dot(at.normal, at.to_view), at.cosine);
  }
  static Rgb<L> even_sky(const LitSurfaces<L>& surface, const L& cos_view) {
    return coat_diffuse_albedo(layer(surface), surface.color, cos_view);
  }
  static CoatLayer<L> layer(const LitSurfaces<L>& surface) {
    return surface.records(&MaterialRecord<ScalarOf<L>>::coat);
  }
};

// A light without shadows is POV-Ray's fill light, which makes no highlight.
template <class L>
struct PovResponse {
  static constexpr SurfaceKind kKind = SurfaceKind::pov;
  static Rgb<L> scattered(const LitSurfaces<L>& surface, const Illumination<L>& at) {
    const PovShading<L> shading = surface.records(&MaterialRecord<ScalarOf<L>>::pov_shading);
    Rgb<L> answer = pov_diffuse(shading, surface.color, at.cosine);
    if (at.casts_shadows) {
      answer += pov_highlights(shading, surface.color, at.normal, at.to_view, at.light.direction);
    }
    return at.light.weight * answer;
  }
  static Rgb<L> even_sky(const LitSurfaces<L>& surface, const L&) {
    return surface.records(&MaterialRecord<ScalarOf<L>>::pov_shading).diffuse * surface.color;
  }
};

// Queues what samples of a light add at several hits, where both the surface and its shading normal
// face it.
template <class Real, template <class> class Response, class L, class Placed>
void queue_light(Wave<Real>& wave, const Entries<L>& hits, const LightSample<L>& sample,
                 const Placed& light) {
  const MaskOf<L> lit = hits.active() && !is_black(sample.weight);
  if (!any(lit)) return;
  const Meeting met(wave, hits);
  const Vec3<L> view = -met.incident;
  const L cosine = dot(met.shading_normal, sample.direction);
  const L above = dot(met.geometric_normal, sample.direction);
  const MaskOf<L> same_side = (met.enters && above > L(0)) || (!met.enters && above < L(0));
  const MaskOf<L> faces = lit && cosine > L(0) && same_side && dot(met.shading_normal, view) > L(0);
  if (!any(faces)) return;
  const Rgb<L> scattered =
      Response<L>::scattered(LitSurfaces<L>(wave, hits, faces),
                             {met.shading_normal, view, sample, cosine, light.casts_shadows});
  auto& queue = light.casts_shadows ? wave.light_paths : wave.unshadowed;
  const IntOf<L> lamp(static_cast<std::int32_t>(light.visible_shape));
  queue.append(faces && !is_black(scattered), hits.index(), sample.direction, sample.distance, lamp,
               met.weight * scattered);
}

// Calls sample(hits) for the hits of the kind, and queues what it gives.
template <class Real, template <class> class Response, class Placed, class Sample>
void shine(Wave<Real>& wave, const Placed& light, const Sample& sample) {
  using L = Wide<Real>;
  for_lanes<L>(wave.of(Response<L>::kKind), [&](const Entries<L>& hits) {
    queue_light<Real, Response>(wave, hits, sample(hits), light);
  });
}

}  // namespace alhazen::render

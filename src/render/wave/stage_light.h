// render/wave: light that shines on surfaces that scatter it: each kind of light on each kind of
// surface. Nothing is traced here; what would arrive goes to the queue that the shadow stages work
// off.
#pragma once

#include "core/math/random.h"
#include "render/wave/wave.h"

namespace alhazen::render {

// One light seen from one point of a surface that faces it.
template <class Real>
struct Illumination {
  Vec3<Real> normal, to_view;
  LightSample<Real> light;
  Real cosine;  // of the light with the normal, > 0
  bool casts_shadows;
};

// How a kind of surface answers to light: scattered() is the radiance that it adds; even_sky() what
// radiance 1 from everywhere adds.
template <class Real>
struct MatteResponse {
  static const typename Wave<Real>::List& hits(const Wave<Real>& wave) {
    return wave.of(SurfaceKind::matte);
  }
  static Rgb<Real> scattered(const MaterialRecord<Real>&, Rgb<Real> color,
                             const Illumination<Real>& at) {
    return at.cosine * at.light.weight * (color / pi<Real>());
  }
  static Rgb<Real> even_sky(const MaterialRecord<Real>&, Rgb<Real> color, Real) { return color; }
};

template <class Real>
struct GlossyResponse {
  static const typename Wave<Real>::List& hits(const Wave<Real>& wave) {
    return wave.of(SurfaceKind::glossy);
  }
  static Rgb<Real> scattered(const MaterialRecord<Real>& material, Rgb<Real> color,
                             const Illumination<Real>& at) {
    const Rgb<Real> value = color / pi<Real>() + highlight_value(material.lobe, at.normal,
                                                                 at.to_view, at.light.direction);
    return at.cosine * at.light.weight * value;
  }
  // Highlights answer to lights that have a place; an even sky would only make the surface
  // brighter.
  static Rgb<Real> even_sky(const MaterialRecord<Real>&, Rgb<Real> color, Real) { return color; }
};

template <class Real>
struct CoatResponse {
  static const typename Wave<Real>::List& hits(const Wave<Real>& wave) {
    return wave.of(SurfaceKind::coat);
  }
  static Rgb<Real> scattered(const MaterialRecord<Real>& material, Rgb<Real> color,
                             const Illumination<Real>& at) {
    return at.cosine * at.light.weight *
           coat_diffuse_value(material.coat, color, dot(at.normal, at.to_view), at.cosine);
  }
  static Rgb<Real> even_sky(const MaterialRecord<Real>& material, Rgb<Real> color, Real cos_view) {
    return coat_diffuse_albedo(material.coat, color, cos_view);
  }
};

// A light without shadows is POV-Ray's fill light, which makes no highlight.
template <class Real>
struct PovResponse {
  static const typename Wave<Real>::List& hits(const Wave<Real>& wave) {
    return wave.of(SurfaceKind::pov);
  }
  static Rgb<Real> scattered(const MaterialRecord<Real>& material, Rgb<Real> color,
                             const Illumination<Real>& at) {
    Rgb<Real> answer = pov_diffuse(material.pov, color, at.cosine);
    if (at.casts_shadows) {
      answer += pov_highlights(material.pov, color, at.normal, at.to_view, at.light.direction);
    }
    return at.light.weight * answer;
  }
  static Rgb<Real> even_sky(const MaterialRecord<Real>& material, Rgb<Real> color, Real) {
    return material.pov.diffuse * color;
  }
};

template <class Real, template <class> class Response>
void add_ambient(Wave<Real>& wave) {
  for (const std::size_t h : Response<Real>::hits(wave)) {
    const std::size_t i = wave.hits.ray_of(h);
    const Real cos_view = -dot(wave.rays.direction[i], wave.hits.shading_normal[h]);
    if (!(cos_view > Real(0))) continue;
    const MaterialRecord<Real>& material = wave.world.materials[wave.hits.material_of(h)];
    wave.add(i, wave.world.lights.ambient *
                    Response<Real>::even_sky(material, wave.hits.color[h], cos_view));
  }
}

// Queues what one sample of a light adds at hit `h`, if both the surface and its shading normal
// face it.
template <class Real, template <class> class Response, class Placed>
void queue_light(Wave<Real>& wave, std::size_t h, const LightSample<Real>& sample,
                 const Placed& light) {
  if (is_black(sample.weight)) return;
  const std::size_t i = wave.hits.ray_of(h);
  const Vec3<Real> view = -wave.rays.direction[i];
  const Vec3<Real> normal = wave.hits.shading_normal[h];
  const Real cosine = dot(normal, sample.direction);
  const Real above = dot(wave.hits.geometric_normal[h], sample.direction);
  const bool same_side = wave.hits.hit[h].enters ? above > Real(0) : above < Real(0);
  if (!(cosine > Real(0)) || !same_side || !(dot(normal, view) > Real(0))) return;
  const MaterialRecord<Real>& material = wave.world.materials[wave.hits.material_of(h)];
  const Rgb<Real> scattered = Response<Real>::scattered(
      material, wave.hits.color[h], {normal, view, sample, cosine, light.casts_shadows});
  if (is_black(scattered)) return;
  auto& queue = light.casts_shadows ? wave.light_paths : wave.unshadowed;
  queue.push({wave.hits.position[h], sample.direction}, wave.source_at(h, false), sample.distance,
             light.visible_shape, wave.rays.weight[i] * scattered, wave.rays.slot[i],
             wave.rays.medium[i]);
}

template <class Real, template <class> class Response>
void shine_points(Wave<Real>& wave) {
  for (const auto& light : wave.world.lights.points) {
    for (const std::size_t h : Response<Real>::hits(wave)) {
      queue_light<Real, Response>(wave, h, light.kernel.sample(wave.hits.position[h]), light);
    }
  }
}

template <class Real, template <class> class Response>
void shine_directionals(Wave<Real>& wave) {
  for (const auto& light : wave.world.lights.directionals) {
    for (const std::size_t h : Response<Real>::hits(wave)) {
      queue_light<Real, Response>(wave, h, light.kernel.sample(), light);
    }
  }
}

template <class Real, template <class> class Response>
void shine_spots(Wave<Real>& wave) {
  for (const auto& light : wave.world.lights.spots) {
    for (const std::size_t h : Response<Real>::hits(wave)) {
      queue_light<Real, Response>(wave, h, light.kernel.sample(wave.hits.position[h]), light);
    }
  }
}

// Calls `visit(h, sample, k)` with sample k of an area light at each of the hits. The samples of
// one light at one branch of a pixel's ray trees are one sequence, through all camera samples of
// the pixel: together they are spread over the light as evenly as the samples of one.
template <class View, class Real, class Placed, class Visitor>
void visit_area(const Wave<Real>& wave, const typename Wave<Real>::List& hits, const Placed& light,
                const Visitor& visit) {
  for (const std::size_t h : hits) {
    const std::size_t i = wave.hits.ray_of(h);
    const View view(light.kernel, wave.hits.position[h]);
    const std::uint64_t seed = mix_64(wave.rays.path[i], kFirstLightDimension + light.id);
    const auto count = static_cast<std::uint32_t>(light.kernel.samples);
    const std::uint32_t first = wave.slots.sample[wave.rays.slot[i]] * count;
    for (std::uint32_t k = 0; k < count; ++k) {
      const Sample2d bits = sample_2d(seed, first + k);
      visit(h, view.sample(unit_real<Real>(bits.x), unit_real<Real>(bits.y)), k);
    }
  }
}

template <class Real, template <class> class Response, class View, class Placed>
void shine_area(Wave<Real>& wave, const std::vector<Placed>& lights) {
  for (const Placed& light : lights) {
    visit_area<View>(wave, Response<Real>::hits(wave), light,
                     [&](std::size_t h, const LightSample<Real>& sample, std::uint32_t) {
                       queue_light<Real, Response>(wave, h, sample, light);
                     });
  }
}

template <class Real, template <class> class Response>
void shine_spheres(Wave<Real>& wave) {
  shine_area<Real, Response, SphereLightView<Real>>(wave, wave.world.lights.spheres);
}

template <class Real, template <class> class Response>
void shine_rectangles(Wave<Real>& wave) {
  shine_area<Real, Response, RectangleLightView<Real>>(wave, wave.world.lights.rectangles);
}

}  // namespace alhazen::render

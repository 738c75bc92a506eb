// render/wave: the stages that find what rays meet and where, and what they lose on the way.
#pragma once

#include "render/surface/absorption.h"
#include "render/wave/passage.h"
#include "render/wave/wave.h"

namespace alhazen::render {

template <class Real>
void keep_hit(Wave<Real>& wave, std::size_t ray, const std::optional<Hit<Real>>& hit) {
  if (hit) {
    wave.hits.push(ray, *hit, wave.world.material_of[hit->shape]);
  } else {
    wave.escaped.push(ray);
  }
}

// Splits the generation into hits, sorted into the lists of their surface's kind, and escaped rays.
template <class Real>
void find_closest_hits(Wave<Real>& wave) {
  for (std::size_t i = 0; i < wave.rays.size(); ++i) {
    keep_hit(wave, i,
             closest_hit(wave.world.tree, wave.rays.ray(i), wave.rays.source[i], infinity<Real>()));
  }
  wave.sort_hits();
}

// The same where there is glass: a surface with the same medium on both sides is no interface, so
// the ray goes on along its line, and only its list of media changes. Each crossing of the line is
// visited once, in order, so this ends however many solids share a face.
template <class Real>
void find_interfaces(Wave<Real>& wave) {
  const World<Real>& world = wave.world;
  for (std::size_t i = 0; i < wave.rays.size(); ++i) {
    const Ray<Real> ray = wave.rays.ray(i);
    const Source source = wave.rays.source[i];
    MediumId& medium = wave.rays.medium[i];
    Source passed;  // remembers the faces passed at one point
    Real passed_at = -1;
    auto hit = closest_hit(world.tree, ray, source, infinity<Real>());
    while (hit) {
      const MaterialId material = world.material_of[hit->shape];
      const MaterialRecord<Real>& record = world.materials[material];
      const bool is_glass = record.kind == SurfaceKind::glass;
      if (!is_glass && !(record.pov_clear && !world.thin[hit->shape])) break;
      medium = before_surface(wave.media, medium, material, hit->enters);
      if (!is_glass) break;  // its colour counts, whatever the media
      const Passage<Real> passage = cross_surface(world, wave.media, medium, material, hit->enters);
      if (passage.is_interface) break;
      medium = passage.behind;
      if (hit->t != passed_at) passed = {};
      passed_at = hit->t;
      passed.remember({hit->shape, hit->face, hit->enters ? Side::kBelow : Side::kAbove});
      hit = next_hit(world.tree, ray, source, *hit, infinity<Real>());
    }
    if (hit && hit->t == passed_at) {
      wave.hits.passed.push_back({static_cast<std::uint32_t>(wave.hits.size()), passed.earlier});
    }
    keep_hit(wave, i, hit);
  }
  wave.sort_hits();
}

// Beer and Lambert's law over the segment just travelled, in the medium that it lay in.
template <class Real>
void absorb(Wave<Real>& wave) {
  const auto lose = [&](std::size_t i, Real distance) {
    const MaterialId inside =
        wave.media.current(wave.rays.medium[i], wave.world.materials.priorities());
    if (inside == kNoId) return;
    const Rgb<Real> absorption = wave.world.materials[inside].absorption;
    wave.rays.weight.set(i, wave.rays.weight[i] * transmitted_share(absorption, distance));
  };
  for (std::size_t h = 0; h < wave.hits.size(); ++h)
    lose(wave.hits.ray_of(h), wave.hits.hit[h].t);
  for (const std::size_t i : wave.escaped)
    lose(i, infinity<Real>());
}

template <class Real, class Radiance>
void add_where_nothing_is(Wave<Real>& wave, const Radiance& radiance) {
  for (const std::size_t i : wave.escaped) {
    if (wave.world.transparent_background && wave.rays.source.shape[i] < 0) continue;
    wave.add(i, radiance(wave.rays.direction[i]));
  }
}

template <class Real>
void add_background(Wave<Real>& wave) {
  const auto& background = wave.world.background;
  add_where_nothing_is(wave, [&](Vec3<Real> d) { return background.plain(d); });
}

template <class Real>
void add_environment(Wave<Real>& wave) {
  const auto& background = wave.world.background;
  add_where_nothing_is(wave, [&](Vec3<Real> d) { return background.picture(d); });
}

// Position and normals, and where the colour is a texture the coordinates that it asks for. The
// shading normal is turned to the side that the ray came from.
template <class Real, bool with_coordinates>
void find_surfaces(Wave<Real>& wave) {
  auto& hits = wave.hits;
  if constexpr (with_coordinates) hits.texture_point.make_room(hits.size());
  const ShapeTable<Real>& shapes = wave.world.shapes;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    const Hit<Real> hit = hits.hit[h];
    const Ray<Real> ray = wave.rays.ray(hits.ray_of(h));
    const bool textured = with_coordinates && wave.world.materials[hits.material_of(h)].textured;
    const SurfacePoint<Real> point = textured
                                         ? shapes.surface(hit.shape, ray, hit.crossing())
                                         : shapes.plain_surface(hit.shape, ray, hit.crossing());
    hits.position.set(h, point.position);
    hits.geometric_normal.set(h, point.normal);
    hits.shading_normal.set(h, hit.enters ? point.shading_normal : -point.shading_normal);
    if (textured) {
      hits.texture_point[h] = {point.object_position, point.position, point.u, point.v};
    }
  }
}

template <class Real>
void find_plain_colors(Wave<Real>& wave) {
  auto& hits = wave.hits;
  // A pattern is met here only where nobody asks for its colour.
  for (std::size_t h = 0; h < hits.size(); ++h)
    hits.color.set(h, wave.world.materials[hits.material_of(h)].solid_color);
}

template <class Real>
void find_textured_colors(Wave<Real>& wave) {
  auto& hits = wave.hits;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    const MaterialRecord<Real>& material = wave.world.materials[hits.material_of(h)];
    hits.color.set(h, material.textured
                          ? wave.world.textures.color(material.color, hits.texture_point[h])
                          : material.solid_color);
  }
}

template <class Real>
void add_emission(Wave<Real>& wave) {
  for (const std::size_t h : wave.glowing) {
    wave.add(wave.hits.ray_of(h), wave.world.materials[wave.hits.material_of(h)].emission);
  }
}

}  // namespace alhazen::render

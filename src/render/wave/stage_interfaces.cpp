// render/wave: the stages that find what rays meet and where, and what they lose on the way.
#pragma once

#include "render/accel/shape_tree_lanes.h"
#include "render/wave/passage.h"
#include "render/wave/surface_color.h"
#include "render/wave/wave.h"

namespace alhazen::render {

// What several rays of the generation meet first.
template <class L>
HitLanes<L> first_hits(const Wave<ScalarOf<L>>& wave, const Entries<L>& at) {
  const auto& rays = wave.rays;
  return closest_hits(
      wave.world.tree, Ray<L>{at.of(rays.origin), at.of(rays.direction)},
      rays.source.departures(at), [&](int lane) { return rays.source[at[lane]]; }, L(infinity<L>()),
      IntOf<L>(-1), at.active());
}

// Hits of several lanes in memory, to be looked at one by one.
template <class L>
class HitNumbers {
 public:
  using Real = ScalarOf<L>;

  explicit HitNumbers(const HitLanes<L>& hits)
      : t_(hits.t),
        shape_(hits.shape),
        face_(hits.face),
        enters_(hits.enters.bits()),
        found_(hits.found.bits()) {}

  std::optional<Hit<Real>> operator[](int lane) const {
    if ((found_ >> lane & 1U) == 0) return std::nullopt;
    return Hit<Real>{t_[lane], static_cast<ShapeId>(shape_[lane]), static_cast<int>(face_[lane]),
                     (enters_ >> lane & 1U) != 0};
  }

 private:
  Numbers<L> t_;
  Numbers<IntOf<L>> shape_, face_;
  std::uint32_t enters_, found_;
};

// Splits the generation into hits, sorted into the lists of their surface's kind, and escaped rays.
template <class Real>
void find_closest_hits(Wave<Real>& wave) {
  using L = Wide<Real>;
  for_lanes<L>(wave.rays.size(), [&](const Entries<L>& at) {
    const HitLanes<L> hits = first_hits(wave, at);
    wave.hits.append(at.index(), hits, at.active() && hits.found);
    wave.escaped.append(at.index(), at.active() && !hits.found);
  });
  wave.sort_hits();
}

// Goes on from `hit`, past what is no interface, and keeps what the ray meets then. Each crossing
// of the line is visited once, in order, so this ends however many solids share a face.
template <class Real>
void keep_interface(Wave<Real>& wave, std::size_t i, std::optional<Hit<Real>> hit) {
  if (!hit) {
    wave.escaped.push(i);
    return;
  }
  const World<Real>& world = wave.world;
  auto medium = static_cast<MediumId>(wave.rays.medium[i]);
  Source passed;  // remembers the faces passed at one point
  Real passed_at = -1;
  while (hit) {
    const MaterialId material = world.material_of[hit->shape];
    const MaterialRoute& route = world.materials.route(material);
    const bool is_glass = route.kind == SurfaceKind::glass;
    if (!is_glass && !(route.pov_clear && !world.thin[hit->shape])) break;
    medium = before_surface(wave.media, medium, material, hit->enters);
    if (!is_glass) break;  // its colour counts, whatever the media
    const Passage<Real> passage = cross_surface(world, wave.media, medium, material, hit->enters);
    if (passage.is_interface) break;
    medium = passage.behind;
    if (hit->t != passed_at) passed = {};
    passed_at = hit->t;
    passed.remember({hit->shape, hit->face, hit->enters ? Side::kBelow : Side::kAbove});
    hit = next_hit(world.tree, wave.rays.ray(i), wave.rays.source[i], *hit, infinity<Real>());
  }
  wave.rays.medium[i] = medium;
  if (!hit) {
    wave.escaped.push(i);
    return;
  }
  if (hit->t == passed_at) {
    wave.hits.passed.push_back({static_cast<std::uint32_t>(wave.hits.size()), passed.earlier});
  }
  wave.hits.push(i, *hit);
}

// The same where there is glass: a surface with the same medium on both sides is no interface, so
// the ray goes on along its line, and only its list of media changes.
template <class Real>
void find_interfaces(Wave<Real>& wave) {
  using L = Wide<Real>;
  const World<Real>& world = wave.world;
  for_lanes<L>(wave.rays.size(), [&](const Entries<L>& at) {
    const HitLanes<L> first = first_hits(wave, at);
    const MaskOf<L> met = at.active() && first.found;
    const IntOf<L> material = world.template materials_at<L>(first.shape, met);
    const IntOf<L> way = world.materials.template ways_of<L>(material, met);
    const MaskOf<L> is_glass = way == IntOf<L>(static_cast<int>(Way::through_glass));
    const MaskOf<L> plain =
        is_plain_passage<L>(at.of(wave.rays.medium), material, first.enters, met && is_glass);
    if (any(met && !plain && way != IntOf<L>(static_cast<int>(Way::ends)))) {
      const HitNumbers<L> numbers(first);
      for_each_lane(at.active(), [&](int k) { keep_interface(wave, at[k], numbers[k]); });
    } else {
      wave.hits.append(at.index(), first, met);
      wave.escaped.append(at.index(), at.active() && !first.found);
    }
  });
  wave.sort_hits();
}

// Beer and Lambert's law over the segment just travelled, in the medium that it lay in.
template <class Real>
void absorb(Wave<Real>& wave) {
  using L = Wide<Real>;
  const auto lose = [&](const Entries<L>& rays, const L& distance) {
    const IntOf<L> medium = rays.of(wave.rays.medium);
    if (!any(rays.active() && medium != IntOf<L>(kVacuum))) return;
    rays.put(rays.of(wave.rays.weight) * share_left(wave, medium, distance, rays.active()),
             wave.rays.weight);
  };
  for_lanes<L>(wave.hits.size(), [&](const Entries<L>& at) {
    lose(Entries<L>(at.of(wave.hits.ray), at.active()), at.of(wave.hits.hit.t));
  });
  for_lanes<L>(wave.escaped, [&](const Entries<L>& rays) { lose(rays, L(infinity<L>())); });
}

// Sums into samples stay in the order of the queue: lanes may belong to one sample.
template <class Real, class Radiance>
void add_where_nothing_is(Wave<Real>& wave, const Radiance& radiance) {
  using L = Wide<Real>;
  for_lanes<L>(wave.escaped, [&](const Entries<L>& rays) {
    MaskOf<L> seen = rays.active();
    if (wave.world.transparent_background) {
      seen = seen && rays.of(wave.rays.source.shape) != IntOf<L>(-1);
    }
    wave.add(rays, seen, radiance(rays.of(wave.rays.direction)));
  });
}

template <class Real>
void add_background(Wave<Real>& wave) {
  const auto& background = wave.world.background;
  add_where_nothing_is(
      wave, [&](const Vec3<Wide<Real>>& d) { return background.template plain<Wide<Real>>(d); });
}

template <class Real>
void add_environment(Wave<Real>& wave) {
  const auto& background = wave.world.background;
  add_where_nothing_is(
      wave, [&](const Vec3<Wide<Real>>& d) { return background.template picture<Wide<Real>>(d); });
}

// Position and normals, and where the colour is a texture the coordinates that it asks for. The
// shading normal is turned to the side that the ray came from.
template <class Real, bool with_coordinates>
void find_surfaces(Wave<Real>& wave) {
  using L = Wide<Real>;
  auto& hits = wave.hits;
  if constexpr (with_coordinates) hits.make_room_for_coordinates();
  for_lanes<L>(hits.size(), [&](const Entries<L>& at) {
    const Entries<L> rays(at.of(hits.ray), at.active());
    const Ray<L> ray{rays.of(wave.rays.origin), rays.of(wave.rays.direction)};
    const IntOf<L> shape = at.of(hits.hit.shape);
    const MaskOf<L> enters = at.of(hits.hit.enters) != IntOf<L>(0);
    const Crossing<L> crossing{at.of(hits.hit.t), at.of(hits.hit.face), enters};
    SurfacePoint<L> point;
    if constexpr (with_coordinates) {
      const MaskOf<L> asks = are_textured<L>(wave.world, at.of(hits.material), at.active());
      const MaskOf<L> others = at.active() && !asks;
      if (any(asks)) point = wave.world.shapes.template surface<L>(shape, ray, crossing, asks);
      if (any(others)) {
        point = select(asks, point,
                       wave.world.shapes.template plain_surface<L>(shape, ray, crossing, others));
      }
      at.store(point.object_position, hits.object_position);
      at.store(point.u, hits.u);
      at.store(point.v, hits.v);
    } else {
      point = wave.world.shapes.template plain_surface<L>(shape, ray, crossing, at.active());
    }
    at.store(point.position, hits.position);
    at.store(point.normal, hits.geometric_normal);
    at.store(select(enters, point.shading_normal, -point.shading_normal), hits.shading_normal);
  });
}

// A pattern is met by the first of these stages only where nobody asks for its colour.
template <class Real>
void find_plain_colors(Wave<Real>& wave) {
  using L = Wide<Real>;
  for_lanes<L>(wave.hits.size(), [&](const Entries<L>& at) {
    at.store(wave.world.materials.template records_of<L>(&MaterialRecord<Real>::solid_color,
                                                         at.of(wave.hits.material), at.active()),
             wave.hits.color);
  });
}

template <class Real>
void find_textured_colors(Wave<Real>& wave) {
  using L = Wide<Real>;
  auto& hits = wave.hits;
  for_lanes<L>(hits.size(), [&](const Entries<L>& at) {
    const auto texture_points = [&](MaskOf<L>) {
      return TexturePoint<L>{at.of(hits.object_position), at.of(hits.position), at.of(hits.u),
                             at.of(hits.v)};
    };
    at.store(surface_colors<L>(wave.world, at.of(hits.material), at.active(), texture_points),
             hits.color);
  });
}

template <class Real>
void add_emission(Wave<Real>& wave) {
  for (const std::size_t h : wave.glowing) {
    wave.add(wave.hits.ray_of(h), wave.world.materials[wave.hits.material_of(h)].emission);
  }
}

}  // namespace alhazen::render

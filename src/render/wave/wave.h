// render/wave: one worker's rays in flight: the queues of a batch, what the stages read and write.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "render/wave/entries.h"
#include "render/wave/hit_queue.h"
#include "render/wave/media.h"
#include "render/wave/render.h"
#include "render/wave/shadow_queue.h"
#include "render/wave/slots.h"
#include "render/wave/world.h"

namespace alhazen::render {

struct WaveCounters {
  std::uint64_t camera_rays = 0, reflection_rays = 0, refraction_rays = 0, shadow_rays = 0;
  std::uint64_t cut_by_depth = 0, cut_by_weight = 0;
  std::array<std::uint64_t, kStageCount> stage_items{};
  std::array<double, kStageCount> stage_seconds{};

  void add(StageId stage, std::size_t items, double seconds) {
    stage_items[static_cast<std::size_t>(stage)] += items;
    stage_seconds[static_cast<std::size_t>(stage)] += seconds;
  }
};

template <class Real>
struct Wave {
  using List = IndexList<LaneInt<Real>>;  // indices in order

  explicit Wave(const World<Real>& w) : world(w), media(w.materials.size()) {}

  const World<Real>& world;
  Slots<Real> slots;
  RayQueue<Real> rays, next;  // this generation and the one it gives rise to
  HitQueue<Real> hits;
  List escaped;  // rays that met nothing
  // Hits by what their surface does.
  std::array<List, kSurfaceKinds> of_kind;
  List glowing, pov_glowing, pov_mirror, pov_clear;
  ShadowQueue<Real> light_paths, unshadowed;
  MediumPool media;
  WaveCounters counters;

  // Adds what comes along ray `i` to its sample.
  void add(std::size_t i, Rgb<Real> radiance) {
    slots.radiance[rays.slot[i]] += rays.weight[i] * radiance;
  }

  // The same of several rays, in the order of the lanes: some may belong to one
  // sample.
  template <class L>
  void add(const Entries<L>& at, MaskOf<L> which, const Rgb<L>& radiance) {
    const Colors<L> weighted(at.of(rays.weight) * radiance);
    const Numbers<IntOf<L>> slot(at.of(rays.slot));
    for_each_lane(which, [&](int k) { slots.radiance[slot[k]] += weighted[k]; });
  }

  // Whether anything asks for the name of a ray's branch.
  bool names_paths() const {
    return !world.lights.spheres.empty() || !world.lights.rectangles.empty() ||
           !slots.signature.empty() || !slots.margin.empty();
  }

  const List& of(SurfaceKind kind) const { return of_kind[static_cast<std::size_t>(kind)]; }

  // Keeps the smallest margin of the slot's decisions.
  void weigh(SlotId slot, Real margin) { slots.margin[slot] = smaller(slots.margin[slot], margin); }

  // Where a ray starts that goes on from hit `h`: on the side that it came from, or across.
  Source source_at(std::size_t h, bool across) const {
    const std::size_t i = hits.ray_of(h);
    const Hit<Real> hit = hits.hit[h];
    // What came before matters only if the ray has not moved.
    const Source before = hit.t == Real(0) ? rays.source[i] : Source();
    Source source = source_after(before, rays.direction[i], hit, across);
    if (hits.passed.empty()) return source;
    const auto place = std::lower_bound(
        hits.passed.begin(), hits.passed.end(), h,
        [](const PassedFaces& passed, std::size_t hit_index) { return passed.hit < hit_index; });
    if (place == hits.passed.end() || place->hit != h) return source;
    for (auto face = place->faces.rbegin(); face != place->faces.rend(); ++face) {
      if (face->shape != kNoId) source.remember(*face);
    }
    return source;
  }

  Real ior_in(MediumId medium) const {
    return world.ior_of(media.current(medium, world.materials.priorities()));
  }

  SlotId slot_of_hit(std::size_t h) const { return static_cast<SlotId>(rays.slot[hits.ray_of(h)]); }

  // Where there is nothing to meet.
  void escape_all() {
    for (std::size_t i = 0; i < rays.size(); ++i)
      escaped.push(i);
  }

  // What camera rays met: for ids, coverage and albedo.
  void keep_first_surfaces(bool colored) {
    for (std::size_t h = 0; h < hits.size(); ++h) {
      const std::size_t i = hits.ray_of(h);
      if (rays.depth[i] != 0 || rays.passed[i] != 0) continue;
      const SlotId slot = rays.slot[i];
      slots.met_something[slot] = 1;
      slots.first_shape[slot] = hits.hit[h].shape;
      const bool has_color = world.materials[hits.material_of(h)].color != kNoId;
      if (colored && has_color) slots.first_color[slot] = hits.color[h];
    }
  }

  void start_generation() {
    hits.clear();
    hits.make_room(rays.size());
    light_paths.clear();
    unshadowed.clear();
    for (List* list : {&escaped, &glowing, &pov_glowing, &pov_mirror, &pov_clear})
      start_list(*list);
    for (List& list : of_kind)
      start_list(list);
  }

  // Finds the material of each hit, and puts it on the lists of what its surface does.
  void sort_hits() {
    for (std::size_t h = 0; h < hits.size(); ++h) {
      const MaterialId material = world.material_of[static_cast<ShapeId>(hits.hit.shape[h])];
      hits.material[h] = static_cast<LaneInt<Real>>(material);
      const MaterialRoute& route = world.materials.route(material);
      of_kind[static_cast<std::size_t>(route.kind)].push(h);
      if (!route.more) continue;
      if (route.emits && (!route.one_sided || hits.hit.enters[h] != 0)) glowing.push(h);
      if (route.pov_glows) pov_glowing.push(h);
      if (route.pov_reflects) pov_mirror.push(h);
      if (route.pov_clear) pov_clear.push(h);
    }
  }

 private:
  void start_list(List& list) {
    list.clear();
    list.make_room(rays.size());
  }
};

}  // namespace alhazen::render

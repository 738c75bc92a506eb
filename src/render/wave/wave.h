// render/wave: one worker's rays in flight: the queues of a batch, what the stages read and write.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/wave/media.h"
#include "render/wave/queue.h"
#include "render/wave/render.h"
#include "render/wave/world.h"

namespace alhazen::render {

// One camera sample of a batch: which it is, and what its rays have added up to.
template <class Real>
struct Slots {
  std::vector<std::int32_t> x, y;        // the pixel, in the frame
  std::vector<std::uint32_t> sample;     // its number within the pixel
  std::vector<Real> offset_x, offset_y;  // of its ray from the pixel's centre, in pixels
  std::vector<std::uint8_t> negative;    // whether the reconstruction filter is, at that place
  std::vector<Rgb<Real>> radiance;
  std::vector<std::uint8_t> met_something;  // by the camera ray
  std::vector<std::uint32_t> rays;          // traced for it, of all kinds
  std::vector<Rgb<Real>> dropped;           // weight of children that were cut
  std::vector<ShapeId> first_shape;         // that the camera ray met; kNoId: none
  std::vector<Rgb<Real>> first_color;       // its albedo
  std::vector<std::uint64_t> signature;     // only if it was asked for
  std::vector<Real> margin;                 // likewise

  std::size_t size() const { return x.size(); }
  FilmPoint<Real> film_point(std::size_t s) const { return {x[s], y[s], offset_x[s], offset_y[s]}; }
  void resize(std::size_t count, bool with_signature, bool with_margin) {
    signature.assign(with_signature ? count : 0, 0);
    margin.assign(with_margin ? count : 0, Real(1));
    x.resize(count);
    y.resize(count);
    sample.resize(count);
    offset_x.assign(count, Real(0));
    offset_y.assign(count, Real(0));
    negative.assign(count, 0);
    radiance.assign(count, {});
    met_something.assign(count, 0);
    rays.assign(count, 0);
    dropped.assign(count, {});
    first_shape.assign(count, kNoId);
    first_color.assign(count, {});
  }
};

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
  explicit Wave(const World<Real>& w) : world(w) {}

  const World<Real>& world;
  Slots<Real> slots;
  RayQueue<Real> rays, next;  // this generation and the one it gives rise to
  HitQueue<Real> hits;
  std::vector<std::uint32_t> escaped;  // rays that met nothing
  // Hits by what their surface does, each a list of indices in order.
  std::vector<std::uint32_t> matte, glossy, coat, mirror, metal, glass, glowing;
  std::vector<std::uint32_t> pov, pov_glowing, pov_mirror, pov_clear;
  ShadowQueue<Real> light_paths, unshadowed;
  MediumPool media;
  WaveCounters counters;

  // Adds what comes along ray `i` to its sample.
  void add(std::size_t i, Rgb<Real> radiance) {
    slots.radiance[rays.slot[i]] += rays.weight[i] * radiance;
  }

  // Keeps the smallest margin of the slot's decisions.
  void weigh(SlotId slot, Real margin) { slots.margin[slot] = smaller(slots.margin[slot], margin); }

  // Where a ray starts that goes on from hit `h`: on the side that it came from, or across.
  Source source_at(std::size_t h, bool across) const {
    const std::size_t i = hits.ray[h];
    Source source = source_after(rays.source[i], rays.direction[i], hits.hit[h], across);
    if (hits.passed.empty()) return source;
    for (auto face = hits.passed[h].rbegin(); face != hits.passed[h].rend(); ++face) {
      if (face->shape != kNoId) source.remember(*face);
    }
    return source;
  }

  Real ior_in(MediumId medium) const {
    return world.ior_of(media.current(medium, world.materials.priorities()));
  }

  // Where there is nothing to meet.
  void escape_all() {
    for (std::size_t i = 0; i < rays.size(); ++i)
      escaped.push_back(static_cast<std::uint32_t>(i));
  }

  // What the camera rays met: for ids and albedo. Called at the end of the first generation, in
  // which ray i is that of slot i.
  void keep_first_surfaces() {
    for (std::size_t h = 0; h < hits.size(); ++h) {
      const SlotId slot = rays.slot[hits.ray[h]];
      slots.met_something[slot] = 1;
      slots.first_shape[slot] = hits.hit[h].shape;
      const bool colored = world.materials[hits.material[h]].color != kNoId;
      if (colored && !hits.color.empty()) slots.first_color[slot] = hits.color[h];
    }
  }

  void start_generation() {
    hits.clear();
    escaped.clear();
    for (auto* list : {&matte, &glossy, &coat, &mirror, &metal, &glass, &glowing, &pov,
                       &pov_glowing, &pov_mirror, &pov_clear})
      list->clear();
    light_paths.clear();
    unshadowed.clear();
  }

  // Puts each hit on the list of its surface's kind.
  void sort_hits() {
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const auto h = static_cast<std::uint32_t>(i);
      const MaterialRecord<Real>& material = world.materials[hits.material[h]];
      if (material.emits && (!material.one_sided || hits.hit[i].enters)) glowing.push_back(h);
      if (material.pov_glows) pov_glowing.push_back(h);
      if (material.pov_reflects) pov_mirror.push_back(h);
      if (material.pov_clear) pov_clear.push_back(h);
      if (auto* list = list_of(material.kind)) list->push_back(h);
    }
  }

  // Sends a ray on one deeper, or counts why not. `reflection` tells the two kinds apart in the
  // figures.
  void spawn(bool reflection, std::size_t parent, const Ray<Real>& ray, const Source& source,
             Rgb<Real> weight, MediumId medium) {
    if (!may_go_deeper(parent, weight)) return;
    send(reflection, parent, ray, source, weight, medium, rays.depth[parent] + 1, 0);
  }

  // The same for a ray that goes on along its parent's line: it may go on only where a deeper one
  // might, but is none. A line meets each shape twice at most; what would pass more surfaces than
  // that is thrown to and fro between faces that rounding cannot tell apart, and gets deeper.
  void spawn_straight(std::size_t parent, const Ray<Real>& ray, const Source& source,
                      Rgb<Real> weight, MediumId medium) {
    if (!may_go_deeper(parent, weight)) return;
    const std::uint32_t passed = rays.passed[parent];
    const bool is_real = passed < 2 * world.material_of.size();
    send(false, parent, ray, source, weight, medium, rays.depth[parent] + (is_real ? 0 : 1),
         is_real ? passed + 1 : passed);
  }

 private:
  bool may_go_deeper(std::size_t parent, Rgb<Real> weight) {
    if (is_black(weight)) return false;
    const SlotId slot = rays.slot[parent];
    if (rays.depth[parent] + 1 > world.max_depth) {
      ++counters.cut_by_depth;
      slots.dropped[slot] += weight;
      return false;
    }
    const Real largest = largest_channel(weight);
    if (!slots.margin.empty()) weigh(slot, relative_gap(largest, world.cutoff));
    if (largest < world.cutoff) {
      ++counters.cut_by_weight;
      slots.dropped[slot] += weight;
      return false;
    }
    return true;
  }

  void send(bool reflection, std::size_t parent, const Ray<Real>& ray, const Source& source,
            Rgb<Real> weight, MediumId medium, std::uint32_t depth, std::uint32_t passed) {
    ++(reflection ? counters.reflection_rays : counters.refraction_rays);
    ++slots.rays[rays.slot[parent]];
    const std::uint64_t branch = reflection ? 1 : 2;
    next.push(ray, source, weight, rays.slot[parent], medium, mix_64(rays.path[parent], branch),
              depth, passed);
  }

  std::vector<std::uint32_t>* list_of(SurfaceKind kind) {
    switch (kind) {
      case SurfaceKind::matte:
        return &matte;
      case SurfaceKind::glossy:
        return &glossy;
      case SurfaceKind::coat:
        return &coat;
      case SurfaceKind::mirror:
        return &mirror;
      case SurfaceKind::metal:
        return &metal;
      case SurfaceKind::glass:
        return &glass;
      case SurfaceKind::pov:
        return &pov;
      case SurfaceKind::black:
        break;
    }
    return nullptr;
  }
};

}  // namespace alhazen::render

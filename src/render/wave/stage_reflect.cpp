// render/wave: the stages of reflection in mirrors, metals and clear coats.
#include "render/wave/onward.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

// Sends on the reflections at the hits of a list; reflectance_at(met) is of each hit.
template <class Real, class ReflectanceAt>
void reflect_hits(Wave<Real>& wave, const IndexList<LaneInt<Real>>& list,
                  const ReflectanceAt& reflectance_at) {
  using L = Wide<Real>;
  Spawner<Real, 1> spawner(wave, list.size());
  for_lanes<L>(list, [&](const Entries<L>& hits) {
    const Meeting<L> met(wave, hits);
    spawner.add(met, {reflection(wave, met, hits.active(), reflectance_at(met))});
  });
}

template <class Real>
void reflect_in_mirrors(Wave<Real>& wave) {
  reflect_hits(wave, wave.of(SurfaceKind::mirror),
               [&](const auto& met) { return met.hits.of(wave.hits.color); });
}

template <class Real>
void reflect_in_metals(Wave<Real>& wave) {
  using L = Wide<Real>;
  reflect_hits(wave, wave.of(SurfaceKind::metal), [&](const Meeting<L>& met) {
    const auto of_metal = [&, id = met.hits.of(wave.hits.material)](auto member) {
      return wave.world.materials.template records_of<L>(member, id, met.hits.active());
    };
    const IntOf<L> medium = met.rays.of(wave.rays.medium);
    L ior(1);
    if (any(met.hits.active() && medium != IntOf<L>(kVacuum))) {
      ior = per_lane<L>(met.hits.active(), Real(1),
                        [&](int k) { return wave.ior_in(static_cast<MediumId>(medium[k])); });
    }
    return conductor_reflectance(incident_cosine(met), of_metal(&MaterialRecord<Real>::conductor_n),
                                 of_metal(&MaterialRecord<Real>::conductor_k), ior);
  });
}

template <class Real>
void reflect_in_coats(Wave<Real>& wave) {
  using L = Wide<Real>;
  reflect_hits(wave, wave.of(SurfaceKind::coat), [&](const Meeting<L>& met) {
    const CoatLayer<L> layer = wave.world.materials.template records_of<L>(
        &MaterialRecord<Real>::coat, met.hits.of(wave.hits.material), met.hits.active());
    return Rgb<L>(coat_mirror_reflectance(layer, incident_cosine(met)));
  });
}

template struct StagesOf<StageHome::reflect>;

}  // namespace alhazen::render

// render/wave: the geometry of several hits at once, as the stages that send rays on from them ask
// for it.
#pragma once

#include "render/wave/entries.h"
#include "render/wave/wave.h"

namespace alhazen::render {

template <class L>
struct Meeting {
  Meeting(const Wave<ScalarOf<L>>& wave, const Entries<L>& at)
      : hits(at),
        rays(at.of(wave.hits.ray), at.active()),
        incident(rays.of(wave.rays.direction)),
        position(at.of(wave.hits.position)),
        geometric_normal(at.of(wave.hits.geometric_normal)),
        shading_normal(at.of(wave.hits.shading_normal)),
        weight(rays.of(wave.rays.weight)),
        enters(at.of(wave.hits.hit.enters) != IntOf<L>(0)) {}

  Entries<L> hits, rays;  // what the rays met, and the rays
  Vec3<L> incident;       // the direction of each
  Vec3<L> position, geometric_normal, shading_normal;
  Rgb<L> weight;  // of the rays
  MaskOf<L> enters;
};

template <class L>
Meeting(const Wave<ScalarOf<L>>&, const Entries<L>&) -> Meeting<L>;

}  // namespace alhazen::render

// render/wave: the stage of reflection and refraction at the interfaces of dielectrics. Surfaces
// that are no interface have been passed already, when hits were found (stage_interfaces.cpp).
#include "render/wave/onward.h"
#include "render/wave/passage.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

template <class Real>
void refract_in_glass(Wave<Real>& wave) {
  using L = Wide<Real>;
  Spawner<Real, 2> spawner(wave, wave.of(SurfaceKind::glass).size());
  for_lanes<L>(wave.of(SurfaceKind::glass), [&](const Entries<L>& hits) {
    const Meeting<L> met(wave, hits);
    const PassageLanes<L> passage =
        cross_shapes<L>(wave, met.rays.of(wave.rays.medium), hits.of(wave.hits.hit.shape),
                        hits.of(wave.hits.material), met.enters, hits.active());
    const L eta = passage.ior_here / passage.ior_behind;
    const DielectricInterface<L> interface = dielectric_interface(incident_cosine(met), eta);
    const Offspring<L> passing{false, hits.active() && !interface.total_reflection,
                               crossing_direction(met, eta, interface),
                               interface.transmittance * met.weight, passage.behind};
    spawner.add(met,
                {reflection(wave, met, hits.active(), Rgb<L>(interface.reflectance)), passing});
  });
}

template struct StagesOf<StageHome::glass>;

}  // namespace alhazen::render

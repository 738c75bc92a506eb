// What signatures and margins are for: where the oracle's margin is above a bound, another
// precision decides everything as it does.
#include <fmt/format.h>

#include "hard/relations/pictures.h"
#include "hard/relations/scenes.h"

namespace alhazen::hard {
namespace {

#if ALHAZEN_HAS_QUAD
TEST(Hard, Oracle_CertifiedDecisions) {
  for (const NamedScene& named : kScenes) {
    const Scene scene = named.at({});
    const Picture quad = decisions_of(scene, Precision::quad);
    const double pixels = static_cast<double>(quad.margin.size());
    const Certified in_double = compare_certified(quad, decisions_of(scene), 1e-9);
    figure("Oracle", "double", fmt::format("{}: pixels not certified at 1e-9", named.name),
           pixels - in_double.pixels, 0.1 * pixels);
    figure("Oracle", "double", fmt::format("{}: flips in certified pixels", named.name),
           in_double.flips, 0);
    figure("Oracle", "double", fmt::format("{}: largest difference", named.name),
           in_double.largest_error, 1e-9);
    const Certified in_float =
        compare_certified(quad, decisions_of(scene, Precision::float32), 1e-3);
    figure("Oracle", "float",
           fmt::format("{}: flips in {} of {} pixels certified at 1e-3", named.name,
                       in_float.pixels, pixels),
           in_float.flips, 0);
  }
}
#endif

}  // namespace
}  // namespace alhazen::hard

// render/surface: colours that pass into each other between stops.
#pragma once

#include <span>

#include "core/math/vec.h"
#include "render/simd/records.h"

namespace alhazen::render {

template <class Real>
struct ColorStop {
  Real position{};
  Rgb<Real> color;
};

// Linear between stops, constant beyond the first and the last; at two stops of one position the
// colour jumps to the later one. Precondition: at least one stop, positions not decreasing.
template <class Real>
inline Rgb<Real> gradient_color(std::span<const ColorStop<ScalarOf<Real>>> stops, Real x) {
  using Int = IntOf<Real>;
  const int count = static_cast<int>(stops.size());
  Int next = 0;  // the first stop beyond x
  for (int i = 0; i < count; ++i) {
    const MaskOf<Real> passed = Real(stops[i].position) <= x;
    if (!any(passed)) break;
    next = select(passed, Int(i + 1), next);
  }
  const auto low = gathered<Real, ColorStop>(stops.data(), larger(next - 1, Int(0)));
  const auto high = gathered<Real, ColorStop>(stops.data(), smaller(next, Int(count - 1)));
  const Real weight = (x - low.position) / (high.position - low.position);
  const MaskOf<Real> is_between = next > Int(0) && next < Int(count);
  return select(is_between, (1 - weight) * low.color + weight * high.color, low.color);
}

}  // namespace alhazen::render

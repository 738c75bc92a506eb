// render/surface: colours that pass into each other between stops.
#pragma once

#include <cstddef>
#include <span>

#include "core/math/vec.h"

namespace alhazen::render {

template <class Real>
struct ColorStop {
  Real position;
  Rgb<Real> color;
};

// Linear between stops, constant beyond the first and the last; at two stops of one position the
// colour jumps to the later one. Precondition: at least one stop, positions not decreasing.
template <class Real>
inline Rgb<Real> gradient_color(std::span<const ColorStop<Real>> stops, Real x) {
  std::size_t next = 0;
  while (next < stops.size() && stops[next].position <= x)
    ++next;
  if (next == 0) return stops.front().color;
  if (next == stops.size()) return stops.back().color;
  const ColorStop<Real>&low = stops[next - 1], &high = stops[next];
  const Real weight = (x - low.position) / (high.position - low.position);
  return (1 - weight) * low.color + weight * high.color;
}

}  // namespace alhazen::render

// render/surface: the patterns, as functions of a point in the pattern's own coordinates.
//
// Cells are closed below and open above: a point exactly on the plane x = k belongs to the cell
// [k, k+1). A flat surface that lies on such a plane is coloured evenly as long as its points come
// out exactly on it, which shape kernels promise for planes of the axes; a surface that has been
// rotated there is speckled by rounding, and its pattern should be moved by half a cell.
#pragma once

#include "core/math/scalar.h"
#include "core/math/vec.h"

namespace alhazen::render {

// Whether floor(x) is odd. Exact for every finite x.
template <class Real>
inline MaskOf<Real> in_odd_cell(Real x) {
  const Real cell = round_down(x);
  return cell - 2 * round_down(cell / 2) != Real(0);
}

// Unit cubes, the one at [0, 1)^3 even.
template <class Real>
inline MaskOf<Real> in_odd_cube(Vec3<Real> p) {
  return (in_odd_cell(p.x) != in_odd_cell(p.y)) != in_odd_cell(p.z);
}

// x modulo `period` > 0 in [0, period].
template <class Real>
inline Real wrapped(Real x, Real period) {
  return x - period * round_down(x / period);
}

// POV-Ray's brick: `size` is the period, joint included; joints fill the last `mortar` of each
// period. Courses are stacked along y; in odd courses the joints across x are shifted by half a
// brick, in even ones, among them [0, size.y), those across z (measured in POV-Ray 3.7, see the
// test).
template <class Real>
inline MaskOf<Real> in_mortar(Vec3<Real> p, Vec3<Real> size, Real mortar) {
  const auto in_joint = [mortar](Real x, Real period) {
    return wrapped(x, period) >= period - mortar;
  };
  const MaskOf<Real> odd = in_odd_cell(p.y / size.y);
  const Real x = select(odd, p.x + size.x / 2, p.x);
  const Real z = select(odd, p.z, p.z + size.z / 2);
  return in_joint(p.y, size.y) || in_joint(x, size.x) || in_joint(z, size.z);
}

}  // namespace alhazen::render

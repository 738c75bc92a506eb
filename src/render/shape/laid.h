// render/shape: flat things that were written in the very plane of something else.
//
// A rug on a floor, a label on a box, a lamp in a ceiling: which of two faces in one plane a ray
// meets first is beyond the digits of any point on them. So it is a rule. A quad or a disc in the
// plane of a solid's face lies on that face, on its outside; of two that lie on one face and
// overlap, the later in the scene lies on the earlier. A rectangle light lies on quads and discs
// too, on the side that it shines to. What lies on another is moved out by kLift roundings of its
// distance from the origin: more than the kernels' errors (bounds.h) for every ray from no farther
// than about ten times that. In double nobody can see it; in float it is 3e-5 of that distance.
#pragma once

#include <array>
#include <vector>

#include "core/math/transform.h"
#include "core/scene/shape.h"
#include "render/shape/crossing.h"

namespace alhazen::render {

// A flat piece of a surface, in the world frame of a shape table: a parallelogram, the square
// around a disc or a cap, or a whole plane.
template <class Real>
struct FlatFace {
  ShapeId shape = kNoId;
  Vec3<Real> normal;                  // unit, outward
  std::array<Vec3<Real>, 4> corners;  // of a plane, all are the point nearest to the origin
  bool endless = false;
  Real extent = 0;  // the largest coordinate of the corners
};

template <class Real>
FlatFace<Real> flat_face(ShapeId shape, Vec3<Real> unit_normal,
                         const std::array<Vec3<Real>, 4>& corners);
template <class Real>
FlatFace<Real> endless_face(ShapeId shape, Vec3<Real> unit_normal, Real offset);

// Whether both lie in one plane, to 16 ulp of their coordinates, and over each other: neighbours in
// a floor of tiles have no more than an edge in common.
template <class Real>
bool share_a_place(const FlatFace<Real>& a, const FlatFace<Real>& b);

// A quad or a disc.
template <class Real>
struct Sheet {
  FlatFace<Real> face;
  bool is_lamp = false;
};

template <class Real>
struct Laid {
  ShapeId shape;
  Vec3<Real> shift;  // world frame
};

// Those of the sheets that lie on another, and by what they are moved. `faces` are those of solids;
// both stand in the order of their ids. The lift is of no less than `reach`, how far away rays may
// start where the origin is not the camera.
template <class Real>
std::vector<Laid<Real>> find_laid(const std::vector<FlatFace<Real>>& faces,
                                  const std::vector<Sheet<Real>>& sheets, Real reach);

}  // namespace alhazen::render

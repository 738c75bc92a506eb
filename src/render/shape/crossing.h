// render/shape: what every kernel takes and gives: rays, where they set out from, the points where
// they cross a surface.
//
// There is no smallest distance and no epsilon. A ray that sets out from a surface says so by
// identity, and the kernel leaves out the root that it knows to be zero (docs/numerics.md, 5.3).
// Any other surface counts over the closed interval t >= 0.
//
// Real is a number or lanes of them (docs/lanes.md).
#pragma once

#include <array>
#include <cstdint>

#include "core/math/vec.h"
#include "render/simd/lanes.h"

namespace alhazen::render {

// Of answers, as of numbers.
template <int bytes, int width>
inline LaneMask<bytes, width> select(LaneMask<bytes, width> which, LaneMask<bytes, width> yes,
                                     LaneMask<bytes, width> no) {
  return (which && yes) || (!which && no);
}

// The points origin + t direction, t >= 0. The direction may have any length but zero; t is in
// units of it.
template <class Real>
struct Ray {
  Vec3<Real> origin, direction;

  Vec3<Real> at(Real t) const { return multiply_add(t, direction, origin); }
};

template <class Real>
requires(!std::same_as<MaskOf<Real>, bool>) inline Ray<Real> select(MaskOf<Real> which,
                                                                    const Ray<Real>& yes,
                                                                    const Ray<Real>& no) {
  return {select(which, yes.origin, no.origin), select(which, yes.direction, no.direction)};
}

// A shape's faces are numbered from 0; what the numbers mean stands at the head of its kernel.
inline constexpr int kNoFace = -1;

// On which side of the surface a ray sets out: the side to which the outward normal points is
// above. A caller that knows (it reflected, or it transmitted) says so, and then rounding in the
// direction cannot let a ray out of a closed shape.
enum class Side : std::uint8_t { kByDirection, kAbove, kBelow };

// How a ray leaves the shape it is tested against: from one of its faces, or not from it at all.
struct Departure {
  int face = kNoFace;
  Side side = Side::kByDirection;

  bool from_surface() const { return face != kNoFace; }
};

// The departures of rays that do leave the shape they are tested against; `side` is a Side.
template <class Real>
struct OwnDeparture {
  IntOf<Real> face, side;
};

// Whether a departing ray goes below the surface; `along_normal` has the sign of dot(n, direction).
template <class Real>
inline MaskOf<Real> goes_below(const OwnDeparture<Real>& from, Real along_normal) {
  using Int = IntOf<Real>;
  return from.side == Int(static_cast<int>(Side::kBelow)) ||
         (from.side == Int(static_cast<int>(Side::kByDirection)) && along_normal < Real(0));
}
template <class Real>
inline bool goes_below(Departure from, Real along_normal) {
  return goes_below(OwnDeparture<Real>{from.face, static_cast<int>(from.side)}, along_normal);
}

template <class Real>
struct Crossing {
  Real t{};
  IntOf<Real> face{};
  MaskOf<Real> enters{};  // against the outward normal
};

template <class Real>
requires(!std::same_as<MaskOf<Real>, bool>) inline Crossing<Real> select(MaskOf<Real> which,
                                                                         const Crossing<Real>& yes,
                                                                         const Crossing<Real>& no) {
  return {select(which, yes.t, no.t), select(which, yes.face, no.face),
          select(which, yes.enters, no.enters)};
}

// Whether a parameter is one of the ray's; a NaN is not.
template <class Real>
inline MaskOf<Real> is_on_ray(Real t) {
  return t >= Real(0) && t < infinity<Real>();
}

// The crossings of one ray with one shape in order of t, all with 0 <= t < infinity. Every shape
// is convex or flat, so there are at most two. What is not there has no meaning.
template <class Real>
struct CrossingPair {
  Crossing<Real> near, far;
  MaskOf<Real> has_near = false, has_far = false;

  // The sums make a -0 a +0.
  void set_near(MaskOf<Real> exists, Real t, IntOf<Real> face, MaskOf<Real> enters) {
    near = {t + Real(0), face, enters};
    has_near = exists && is_on_ray(t);
  }
  void set_far(MaskOf<Real> exists, Real t, IntOf<Real> face, MaskOf<Real> enters) {
    far = {t + Real(0), face, enters};
    has_far = exists && is_on_ray(t);
  }
};

template <class Real>
requires(!std::same_as<MaskOf<Real>, bool>) inline CrossingPair<Real> select(
    MaskOf<Real> which, const CrossingPair<Real>& yes, const CrossingPair<Real>& no) {
  return {select(which, yes.near, no.near), select(which, yes.far, no.far),
          select(which, yes.has_near, no.has_near), select(which, yes.has_far, no.has_far)};
}

// The crossings of a single ray as a list.
template <class Real>
class Crossings {
 public:
  Crossings() = default;
  Crossings(const CrossingPair<Real>& pair) {
    if (pair.has_near) items_[count_++] = pair.near;
    if (pair.has_far) items_[count_++] = pair.far;
  }
  int size() const { return count_; }
  const Crossing<Real>& operator[](int i) const { return items_[i]; }
  const Crossing<Real>* begin() const { return items_.data(); }
  const Crossing<Real>* end() const { return items_.data() + count_; }

 private:
  std::array<Crossing<Real>, 2> items_{};
  int count_ = 0;
};

// Of a single ray with a kernel, which has the two cases as functions of their own.
template <template <class> class Kernel, class Real>
inline Crossings<Real> crossings(const Kernel<Real>& kernel, const Ray<Real>& ray, Departure from) {
  if (!from.from_surface()) return crossings(kernel, ray);
  return own_crossings(kernel, ray, OwnDeparture<Real>{from.face, static_cast<int>(from.side)});
}

// What shading needs to know of a point on a surface, in the frame of the ray.
template <class Real>
struct Surface {
  Vec3<Real> position;        // projected onto the surface: independent of the error in t
  Vec3<Real> normal;          // geometric, outward, unit length
  Vec3<Real> shading_normal;  // unit length, never below the surface
  Real u{}, v{};              // the shape's own parametrisation; 0 where they were not asked for
};

template <class Real>
requires(!std::same_as<MaskOf<Real>, bool>) inline Surface<Real> select(MaskOf<Real> which,
                                                                        const Surface<Real>& yes,
                                                                        const Surface<Real>& no) {
  return {select(which, yes.position, no.position), select(which, yes.normal, no.normal),
          select(which, yes.shading_normal, no.shading_normal), select(which, yes.u, no.u),
          select(which, yes.v, no.v)};
}

}  // namespace alhazen::render

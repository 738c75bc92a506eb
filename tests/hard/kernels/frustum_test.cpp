// A9 and A10: cylinders along and across, cones through the tip and along the side.
//
// A frame that is not the world's is a rotation, and rotating a ray rounds it: by one eps of its
// length, which moves t by `condition` times as much. So t is judged against its condition; along
// the axes, where the frame rounds nothing, against t itself. Near the tip of a cone the condition
// of first order says too little: there a ray that is moved says how much (support.h).
#include "render/shape/frustum.h"

#include <cmath>
#include <gtest/gtest.h>

#include "hard/kernels/support.h"
#include "render/shape/convert.h"
#include "render/shape/from_scene.h"

namespace alhazen::hard {
namespace {

#if ALHAZEN_HAS_QUAD
using render::convert;
using render::from_scene;
using render::Frustum;

constexpr double kBound = kRoundings;  // the catalogue's

// Whether frusta that are wider and narrower by 4 roundings of the numbers in play are crossed
// equally often.
template <class Real>
bool is_decided(const Frustum<Quad>& shape, const Ray<Real>& ray, double extent) {
  const Quad rounding = static_cast<Quad>(4 * kEps<Real> * extent);
  const auto count = [&](Quad by) {
    Frustum<Quad> other = shape;
    other.small_radius = larger(Quad(0), shape.small_radius + by);
    other.large_radius = larger(Quad(0), shape.large_radius + by);
    other.height += 2 * by;
    other.frame.origin = shape.frame.origin - by * shape.frame.z;
    return crossings(other, exact(ray), Departure()).size();
  };
  return count(rounding) == count(-rounding);
}

template <class Real>
void compare(Verdict<Real>& verdict, const Geometry& geometry, const Ray<Real>& ray) {
  const Frustum<double> source = std::holds_alternative<Cylinder>(geometry)
                                     ? from_scene(std::get<Cylinder>(geometry), Vec3d{})
                                     : from_scene(std::get<Cone>(geometry), Vec3d{});
  const Frustum<Real> shape = convert<Real>(source);
  // The numbers that the kernel has, not those it was made of.
  Frustum<Quad> oracle{{Vec3<Quad>(shape.frame.origin), Vec3<Quad>(shape.frame.x),
                        Vec3<Quad>(shape.frame.y), Vec3<Quad>(shape.frame.z)},
                       static_cast<Quad>(shape.height),
                       static_cast<Quad>(shape.small_radius),
                       static_cast<Quad>(shape.large_radius),
                       static_cast<Quad>(shape.slope),
                       shape.capped,
                       shape.base_is_small};
  const double extent = static_cast<double>(length(shape.frame.origin) + shape.height +
                                            shape.large_radius + length(ray.origin));
  verdict.compare(
      shape, oracle, ray, [&] { return is_decided(oracle, ray, extent); }, extent);
}

template <class Real>
void report(const char* id, const std::string& what, const Verdict<Real>& verdict,
            bool is_exact = false) {
  figure_in<Real>(id, what + ": wrong counts", static_cast<double>(verdict.miscounted), 0);
  if (is_exact) {
    figure_in<Real>(id, what + ": relative error of t", verdict.worst, kBound, "eps");
  } else {
    figure_in<Real>(id, what + ": error of t over its condition", verdict.worst_conditioned, kBound,
                    "eps");
  }
}

// A cylinder of length 1e8 r (1e4 in float, whose 24 bits are no more than 1e7), along y and
// slanted; rays across it, almost along it, and on its side.
template <class Real>
void cylinders(bool slanted) {
  Verdict<Real> across, along, inside;
  Dice dice(90);
  const double reach = sizeof(Real) == sizeof(float) ? 1e4 : 1e8;
  for (std::size_t i = 0; i < rays(1000); ++i) {
    const Vec3d axis = slanted ? dice.direction() : Vec3d{0, 1, 0};
    const Vec3d out = aside_of(axis, dice), around = cross(axis, out);
    const Cylinder tube{-0.5 * reach * axis, 0.5 * reach * axis, 1, i % 2 == 0};
    const Vec3d d = dice.direction();
    compare(across, tube, ray_of<Real>(dice.uniform(0, 1.2) * aside_of(d, dice) - 3.0 * d, d));
    // Towards the inside by 2^-k of its length.
    const double slope = std::ldexp(1.0, -dice.below(25));
    compare(along, tube,
            ray_of<Real>(2.0 * out - reach * dice.uniform(-0.4, 0.6) * axis,
                         axis - slope * out + 0.1 * slope * around));
    compare(
        inside, tube,
        ray_of<Real>(dice.uniform(-1, 1) * out + dice.uniform(-1, 1) * axis, axis + slope * out));
  }
  const std::string how = slanted ? "slanted cylinder " : "cylinder along y ";
  report("A9", how + "from outside", across, !slanted);
  report("A9", how + "almost along", along, !slanted);
  report("A9", how + "from inside", inside, !slanted);
}

// Parallel to the axis: inside, in the surface itself, outside. All exact.
template <class Real>
void parallel_to_axis() {
  double wrong = 0;
  const Frustum<Real> tube = convert<Real>(from_scene(Cylinder{{}, {0, 4, 0}, 2, true}, Vec3d{}));
  const Real step = Real(2) + 4 * Real(kEps<Real>);
  const struct {
    Real x;
    int crossings;
  } cases[] = {{Real(0), 2}, {Real(1), 2}, {Real(2), 2}, {-Real(2), 2}, {step, 0}, {-step, 0}};
  for (const auto& c : cases) {
    for (const Real length : {Real(1), Real(3), Real(0.125)}) {
      const Ray<Real> ray{{c.x, Real(-3), Real(0)}, {Real(0), length, Real(0)}};
      const auto hits = crossings(tube, ray, Departure());
      const bool right = hits.size() == c.crossings &&
                         (hits.size() == 0 || (hits[0].t == 3 / length && hits[1].t == 7 / length));
      if (!right) ++wrong;
    }
  }
  figure_in<Real>("A9", "wrong answers parallel to the axis and in the side", wrong, 0);
}

// Over the rim, step by step of one ulp: from the cap to the side, t goes on without a jump. The
// ray comes from above at 45 degrees, so a step of s moves t by at most s.
template <class Real>
void rim() {
  double jump = 0, faces = 0;
  const Frustum<Real> tube = convert<Real>(from_scene(Cylinder{{}, {0, 1, 0}, 1, true}, Vec3d{}));
  const Real step = 4 * Real(kEps<Real>);  // an ulp of the start
  Real before = -1;
  int face_before = render::kNoFace;
  for (int i = -1000; i <= 1000; ++i) {
    // Aimed at (1, 1, 0) give or take i steps.
    const Ray<Real> ray{{Real(3) + Real(i) * step, Real(3), Real(0)},
                        {Real(-1), Real(-1), Real(0)}};
    const auto hits = crossings(tube, ray, Departure());
    if (hits.size() != 2) {
      jump = infinity<double>();
      break;
    }
    if (before >= 0)
      jump = larger(jump, static_cast<double>(absolute(hits[0].t - before)) / kEps<Real>);
    if (hits[0].face != face_before) ++faces;
    before = hits[0].t;
    face_before = hits[0].face;
  }
  EXPECT_EQ(faces, 2);  // the cap and the side
  // The step itself, and on either side of it the error that t may have: 2 eps of 2 each.
  figure_in<Real>("A9", "largest jump of t over the rim by steps of an ulp", jump, 4 + 2 * 2 * 2,
                  "eps");
}

TEST(Hard, A9_Cylinder) {
  for (const bool slanted : {false, true}) {
    cylinders<double>(slanted);
    cylinders<float>(slanted);
  }
  parallel_to_axis<double>();
  parallel_to_axis<float>();
  rim<double>();
  rim<float>();
}

template <class Real>
void cones(bool slanted) {
  Verdict<Real> tip, generator, anywhere;
  Dice dice(100);
  for (std::size_t i = 0; i < rays(1000); ++i) {
    const Vec3d axis = slanted ? dice.direction() : Vec3d{0, 1, 0};
    const Vec3d out = aside_of(axis, dice);
    const double wide = dice.uniform(0.2, 2), high = dice.uniform(0.3, 3);
    const Cone cone{{}, high * axis, wide, 0, true};
    // At the tip, give or take 2^-k.
    const Vec3d d = dice.direction();
    const double away = std::ldexp(1.0, -dice.below(50));
    compare(tip, cone, ray_of<Real>(high * axis + away * aside_of(d, dice) - 2.0 * d, d));
    // Along the line from rim to tip, in the side's own direction to 2^-k.
    const Vec3d side = normalized(high * axis - wide * out);
    compare(generator, cone,
            ray_of<Real>(wide * out - side + dice.uniform(-0.5, 0.5) * cross(axis, out) - 0.3 * out,
                         side + away * out));
    compare(anywhere, cone,
            ray_of<Real>(0.5 * high * axis + dice.uniform(0, 2) * aside_of(d, dice) - 4.0 * d, d));
  }
  const std::string how = slanted ? "slanted cone " : "cone along y ";
  report("A10", how + "anywhere", anywhere);
  report("A10", how + "at the tip", tip);
  report("A10", how + "along the side", generator);
}

// Radii that differ by one rounding: the same t as the cylinder between them.
template <class Real>
void cylinder_in_the_limit() {
  double worst = 0, miscounted = 0;
  Dice dice(101);
  const Frustum<Real> tube = convert<Real>(from_scene(Cylinder{{}, {0, 4, 0}, 1, true}, Vec3d{}));
  Frustum<Real> cone = tube;
  cone.small_radius = Real(1) - Real(kEps<Real>);
  cone.slope = (cone.large_radius - cone.small_radius) / cone.height;
  for (std::size_t i = 0; i < rays(5000); ++i) {
    const Vec3d d = dice.direction(), middle{0, 2, 0};
    const Ray<Real> ray =
        ray_of<Real>(middle + dice.uniform(0, 0.99) * aside_of(d, dice) - 5.0 * d, d);
    const auto a = crossings(tube, ray, Departure()), b = crossings(cone, ray, Departure());
    if (a.size() != b.size()) {
      ++miscounted;
      continue;
    }
    for (int k = 0; k < a.size(); ++k) {
      const Quad truth = static_cast<Quad>(a[k].t);
      const double kappa =
          condition(convert<Quad>(from_scene(Cylinder{{}, {0, 4, 0}, 1, true}, {})), exact(ray),
                    {truth, a[k].face, a[k].enters}, 5);
      worst = larger(worst, relative_error(b[k].t, truth) / kappa);
    }
  }
  figure_in<Real>("A10", "counts that differ from the cylinder's in the limit", miscounted, 0);
  figure_in<Real>("A10", "distance of t from the cylinder's over its condition", worst, kBound,
                  "eps");
}

TEST(Hard, A10_Cone) {
  for (const bool slanted : {false, true}) {
    cones<double>(slanted);
    cones<float>(slanted);
  }
  cylinder_in_the_limit<double>();
  cylinder_in_the_limit<float>();
}
#endif

}  // namespace
}  // namespace alhazen::hard

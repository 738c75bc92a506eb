#include "render/shape/laid.h"

#include <algorithm>
#include <numeric>

#include "render/shape/bounds.h"

namespace alhazen::render {
namespace {

constexpr int kUlps = 16;
constexpr int kLift = 512;  // roundings

template <class Real>
constexpr Real kU = ScalarTraits<Real>::unit_roundoff();

// How far apart faces of one plane may seem to be.
template <class Real>
Real tolerance(const FlatFace<Real>& a, const FlatFace<Real>& b) {
  return Real(2 * kUlps) * kU<Real> * (a.extent + b.extent);
}

template <class Real>
Real size_of(const FlatFace<Real>& face) {
  return larger(largest_coordinate(face.corners[2] - face.corners[0]),
                largest_coordinate(face.corners[3] - face.corners[1]));
}

// How far the plane of the face is from the origin, and to what.
template <class Real>
Real height_of(const FlatFace<Real>& face) {
  return absolute(dot(face.normal, face.corners[0]));
}
template <class Real>
Real rounding_of_height(const FlatFace<Real>& face) {
  // A normal is as good as its corners beside its edges.
  const Real angle = face.endless ? Real(0) : face.extent / size_of(face);
  return Real(kUlps) * kU<Real> * face.extent * (Real(1) + angle);
}

// Faces in the order of how far away their planes are: those of one plane are neighbours.
template <class Real>
class ByHeight {
 public:
  explicit ByHeight(const std::vector<FlatFace<Real>>& faces) : faces_(faces) {
    order_.resize(faces.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return height_of(faces[a]) < height_of(faces[b]);
    });
    for (const FlatFace<Real>& face : faces)
      rounding_ = larger(rounding_, rounding_of_height(face));
  }

  // Calls visit(index) for those that may share a plane with it.
  template <class Visitor>
  void visit_near(const FlatFace<Real>& face, const Visitor& visit) const {
    const Real height = height_of(face);
    const Real reach = Real(4) * (rounding_of_height(face) + rounding_);
    const auto first =
        std::lower_bound(order_.begin(), order_.end(), height - reach,
                         [&](std::size_t i, Real least) { return height_of(faces_[i]) < least; });
    for (auto i = first; i != order_.end() && height_of(faces_[*i]) <= height + reach; ++i)
      visit(*i);
  }

 private:
  const std::vector<FlatFace<Real>>& faces_;
  std::vector<std::size_t> order_;
  Real rounding_ = 0;
};

// The least and the greatest coordinate of a face along an axis.
template <class Real>
std::pair<Real, Real> range_along(const Vec3<Real>& axis, const FlatFace<Real>& face) {
  Real low = infinity<Real>(), high = -low;
  for (const Vec3<Real>& corner : face.corners) {
    low = smaller(low, dot(axis, corner));
    high = larger(high, dot(axis, corner));
  }
  return {low, high};
}

// Whether an edge of `a` is a line that parts the faces, both in one plane.
template <class Real>
bool is_parted_by_edge(const FlatFace<Real>& a, const FlatFace<Real>& b, Real rounding) {
  for (const int k : {1, 3}) {
    const Vec3<Real> edge = a.corners[k] - a.corners[0];
    if (largest_coordinate(edge) == Real(0)) continue;
    const Vec3<Real> across = normalized(cross(a.normal, edge / largest_coordinate(edge)));
    const auto [low_a, high_a] = range_along(across, a);
    const auto [low_b, high_b] = range_along(across, b);
    if (smaller(high_a, high_b) - larger(low_a, low_b) <= rounding) return true;
  }
  return false;
}

}  // namespace

template <class Real>
FlatFace<Real> flat_face(ShapeId shape, Vec3<Real> unit_normal,
                         const std::array<Vec3<Real>, 4>& corners) {
  FlatFace<Real> face{shape, unit_normal, corners, false, Real(0)};
  for (const Vec3<Real>& corner : corners)
    face.extent = larger(face.extent, largest_coordinate(corner));
  return face;
}

template <class Real>
FlatFace<Real> endless_face(ShapeId shape, Vec3<Real> unit_normal, Real offset) {
  const Vec3<Real> point = offset * unit_normal;
  return {shape, unit_normal, {point, point, point, point}, true, absolute(offset)};
}

template <class Real>
bool share_a_place(const FlatFace<Real>& a, const FlatFace<Real>& b) {
  const Real rounding = tolerance(a, b);
  const bool a_is_larger = a.endless || (!b.endless && size_of(a) > size_of(b));
  const FlatFace<Real>&large = a_is_larger ? a : b, &small = a_is_larger ? b : a;
  // The normal of the larger face is the better one.
  for (const Vec3<Real>& corner : small.corners) {
    if (absolute(dot(large.normal, corner - large.corners[0])) > rounding) return false;
  }
  if (large.endless) return !small.endless;
  return !is_parted_by_edge(a, b, rounding) && !is_parted_by_edge(b, a, rounding);
}

template <class Real>
std::vector<Laid<Real>> find_laid(const std::vector<FlatFace<Real>>& faces,
                                  const std::vector<Sheet<Real>>& sheets, Real reach) {
  std::vector<FlatFace<Real>> flats;
  for (const Sheet<Real>& sheet : sheets)
    flats.push_back(sheet.face);
  const ByHeight<Real> solids(faces), others(flats);
  std::vector<Vec3<Real>> shifts(sheets.size());
  std::vector<Real> lift(sheets.size(), Real(0));  // 0: lies on nothing
  const auto lay = [&](std::size_t s) {
    const FlatFace<Real>& face = flats[s];
    const bool is_lamp = sheets[s].is_lamp;
    std::size_t ground = faces.size();
    solids.visit_near(face, [&](std::size_t f) {
      if (f < ground && share_a_place(face, faces[f])) ground = f;
    });
    const bool is_grounded = ground < faces.size();
    if (!is_grounded && !is_lamp) return;
    const Real own = Real(kLift) * kU<Real> * larger(face.extent, reach);
    Real highest = is_grounded ? larger(own, Real(2) * tolerance(face, faces[ground])) : Real(0);
    others.visit_near(face, [&](std::size_t other) {
      const bool is_below = is_lamp ? !sheets[other].is_lamp || other < s
                                    : other < s && !sheets[other].is_lamp && lift[other] > Real(0);
      if (!is_below || other == s || !share_a_place(face, flats[other])) return;
      const Real step = larger(own, Real(2) * tolerance(face, flats[other]));
      highest = larger(highest, lift[other] + step);
    });
    lift[s] = highest;
    shifts[s] = highest * (is_grounded && !is_lamp ? faces[ground].normal : face.normal);
  };
  // Lamps lie on all the others.
  for (const bool lamps : {false, true}) {
    for (std::size_t s = 0; s < sheets.size(); ++s) {
      if (sheets[s].is_lamp == lamps) lay(s);
    }
  }
  std::vector<Laid<Real>> laid;
  for (std::size_t s = 0; s < sheets.size(); ++s) {
    if (lift[s] > Real(0)) laid.push_back({flats[s].shape, shifts[s]});
  }
  return laid;
}

template FlatFace<float> flat_face(ShapeId, Vec3<float>, const std::array<Vec3<float>, 4>&);
template FlatFace<float> endless_face(ShapeId, Vec3<float>, float);
template bool share_a_place(const FlatFace<float>&, const FlatFace<float>&);
template std::vector<Laid<float>> find_laid(const std::vector<FlatFace<float>>&,
                                            const std::vector<Sheet<float>>&, float);
template FlatFace<double> flat_face(ShapeId, Vec3<double>, const std::array<Vec3<double>, 4>&);
template FlatFace<double> endless_face(ShapeId, Vec3<double>, double);
template bool share_a_place(const FlatFace<double>&, const FlatFace<double>&);
template std::vector<Laid<double>> find_laid(const std::vector<FlatFace<double>>&,
                                             const std::vector<Sheet<double>>&, double);
#if ALHAZEN_HAS_QUAD
template FlatFace<Quad> flat_face(ShapeId, Vec3<Quad>, const std::array<Vec3<Quad>, 4>&);
template FlatFace<Quad> endless_face(ShapeId, Vec3<Quad>, Quad);
template bool share_a_place(const FlatFace<Quad>&, const FlatFace<Quad>&);
template std::vector<Laid<Quad>> find_laid(const std::vector<FlatFace<Quad>>&,
                                           const std::vector<Sheet<Quad>>&, Quad);
#endif

}  // namespace alhazen::render

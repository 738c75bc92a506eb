#include "render/shape/laid.h"

#include <algorithm>
#include <numeric>

#include "render/shape/bounds.h"

namespace alhazen::render {
namespace {

constexpr int kUlps = 16;
constexpr int kLift = 512;  // roundings

template <class Real>
Real tolerance(const FlatFace<Real>& a, const FlatFace<Real>& b) {
  return Real(2 * kUlps) * ScalarTraits<Real>::unit_roundoff() * (a.extent + b.extent);
}

// How far the plane of the face is from the origin, and to what.
template <class Real>
Real height_of(const FlatFace<Real>& face) {
  return absolute(dot(face.normal, face.point));
}

template <class Real>
Real size_of(const FlatFace<Real>& face) {
  return largest_coordinate(face.max - face.min);
}
template <class Real>
Real rounding_of_height(const FlatFace<Real>& face) {
  // A normal is as good as its corners beside its edges.
  const Real angle = is_finite(size_of(face)) ? face.extent / size_of(face) : Real(0);
  return Real(kUlps) * ScalarTraits<Real>::unit_roundoff() * face.extent * (Real(1) + angle);
}

// A group of faces in the order of how far away their planes are: those of one plane are
// neighbours.
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

}  // namespace

template <class Real>
FlatFace<Real> flat_face(ShapeId shape, Vec3<Real> normal, std::array<Vec3<Real>, 4> corners) {
  FlatFace<Real> face{shape, normalized(normal), corners[0], corners[0], corners[0], Real(0)};
  for (const Vec3<Real>& corner : corners) {
    for (int axis = 0; axis < 3; ++axis) {
      face.min[axis] = smaller(face.min[axis], corner[axis]);
      face.max[axis] = larger(face.max[axis], corner[axis]);
    }
    face.extent = larger(face.extent, largest_coordinate(corner));
  }
  return face;
}

template <class Real>
FlatFace<Real> endless_face(ShapeId shape, Vec3<Real> unit_normal, Real offset) {
  const Real end = infinity<Real>();
  return {shape,
          unit_normal,
          offset * unit_normal,
          Vec3<Real>{-end, -end, -end},
          Vec3<Real>{end, end, end},
          absolute(offset)};
}

template <class Real>
bool share_a_place(const FlatFace<Real>& a, const FlatFace<Real>& b) {
  const Real rounding = tolerance(a, b);
  int wide = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Real overlap = smaller(a.max[axis], b.max[axis]) - larger(a.min[axis], b.min[axis]);
    if (overlap < -rounding) return false;
    wide += overlap > rounding ? 1 : 0;
  }
  // Neighbours in a floor of tiles have no more than an edge in common.
  if (wide < 2) return false;
  // The normal of the larger face is the better one.
  const Real size_a = size_of(a), size_b = size_of(b);
  const FlatFace<Real>& larger_face = size_a > size_b ? a : b;
  if (absolute(dot(larger_face.normal, a.point - b.point)) > rounding) return false;
  // All of the smaller one has to be in that plane.
  const Real sine = length(cross(a.normal, b.normal));
  return sine * smaller(size_a, size_b) <= Real(2) * rounding;
}

template <class Real>
std::vector<Laid<Real>> find_laid(const std::vector<FlatFace<Real>>& faces,
                                  const std::vector<Sheet<Real>>& sheets, Real reach) {
  std::vector<FlatFace<Real>> flats;
  for (const Sheet<Real>& sheet : sheets)
    flats.push_back(sheet.face);
  const ByHeight<Real> solids(faces), others(flats);
  std::vector<Laid<Real>> laid;
  std::vector<int> level(sheets.size(), 0);  // 0: lies on nothing
  for (std::size_t s = 0; s < sheets.size(); ++s) {
    const FlatFace<Real>& face = flats[s];
    std::size_t ground = faces.size();
    solids.visit_near(face, [&](std::size_t f) {
      if (f < ground && share_a_place(face, faces[f])) ground = f;
    });
    const bool is_grounded = ground < faces.size();
    int below = is_grounded ? 0 : -1;
    others.visit_near(face, [&](std::size_t other) {
      if (other == s || !share_a_place(face, flats[other])) return;
      if (is_grounded ? other < s : sheets[s].is_lamp && !(sheets[other].is_lamp && s < other))
        below = std::max(below, level[other]);
    });
    if (below < 0) continue;
    level[s] = below + 1;
    const Vec3<Real> out =
        is_grounded && !sheets[s].is_lamp ? faces[ground].normal : flats[s].normal;
    const Real lift = Real(kLift) * ScalarTraits<Real>::unit_roundoff() *
                      larger(face.extent, reach) * Real(level[s]);
    laid.push_back({face.shape, lift * out});
  }
  return laid;
}

template FlatFace<float> flat_face(ShapeId, Vec3<float>, std::array<Vec3<float>, 4>);
template FlatFace<float> endless_face(ShapeId, Vec3<float>, float);
template bool share_a_place(const FlatFace<float>&, const FlatFace<float>&);
template std::vector<Laid<float>> find_laid(const std::vector<FlatFace<float>>&,
                                            const std::vector<Sheet<float>>&, float);
template FlatFace<double> flat_face(ShapeId, Vec3<double>, std::array<Vec3<double>, 4>);
template FlatFace<double> endless_face(ShapeId, Vec3<double>, double);
template bool share_a_place(const FlatFace<double>&, const FlatFace<double>&);
template std::vector<Laid<double>> find_laid(const std::vector<FlatFace<double>>&,
                                             const std::vector<Sheet<double>>&, double);
#if ALHAZEN_HAS_QUAD
template FlatFace<Quad> flat_face(ShapeId, Vec3<Quad>, std::array<Vec3<Quad>, 4>);
template FlatFace<Quad> endless_face(ShapeId, Vec3<Quad>, Quad);
template bool share_a_place(const FlatFace<Quad>&, const FlatFace<Quad>&);
template std::vector<Laid<Quad>> find_laid(const std::vector<FlatFace<Quad>>&,
                                           const std::vector<Sheet<Quad>>&, Quad);
#endif

}  // namespace alhazen::render

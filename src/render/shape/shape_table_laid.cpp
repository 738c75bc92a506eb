// render/shape: lays the quads and discs of a table onto what they were written in the plane of.
#include "core/base/overloaded.h"
#include "render/shape/shape_table.h"

namespace alhazen::render {
namespace {

// The corners of the square around a circle.
template <class Real>
std::array<Vec3<Real>, 4> around(const Frame<Real>& frame, Real z, Real radius) {
  return {frame.point({-radius, -radius, z}), frame.point({radius, -radius, z}),
          frame.point({radius, radius, z}), frame.point({-radius, radius, z})};
}

}  // namespace

// The flat faces of a table's shapes, in the world frame.
template <class Real>
class ShapeTable<Real>::Flats {
 public:
  explicit Flats(const ShapeTable& table) : table_(table) {}

  std::vector<FlatFace<Real>> faces;  // of solids
  std::vector<Sheet<Real>> sheets;

  // If it is a quad or a disc. It is where it was written, also if it has been laid.
  void add_sheet(ShapeId id, bool is_lamp) {
    const Entry& entry = table_.entries_[id];
    const auto kind = static_cast<Kind>(entry.kind);
    if (table_.twins_.is_hidden(id)) return;
    if (kind == Kind::parallelogram) {
      const Parallelogram<Real>& quad = table_.kernels_.parallelograms[entry.index];
      const auto& c = quad.corners;
      const Vec3<Real> n = normal_of_edges(c[1] - c[0], c[3] - c[0], quad.reversed);
      add(flat_face(id, n, c), is_lamp);
    } else if (kind == Kind::disc) {
      const Disc<Real>& disc = table_.kernels_.discs[entry.index];
      add(placed_face(id, disc.frame.z, around(disc.frame, Real(0), disc.radius)), is_lamp);
    }
  }
  void add(FlatFace<Real> face, bool is_lamp) {
    const Vec3<Real> lift = table_.lift(face.shape);
    for (Vec3<Real>& corner : face.corners)
      corner = corner - lift;
    face = flat_face(face.shape, face.normal, face.corners);
    add_to(hull_, face);
    sheets.push_back({face, is_lamp});
  }
  // The faces of solids near the sheets, which have been added.
  void add_solids() {
    for (ShapeId id = 0; id < table_.size(); ++id)
      add_solid(id);
  }

 private:
  // Twice what share_a_place allows.
  static constexpr int kRoundings = 64;
  static constexpr Real kMargin = Real(kRoundings) * ScalarTraits<Real>::unit_roundoff();

  void add_solid(ShapeId id) {
    const Entry& entry = table_.entries_[id];
    table_.kernels_.visit(
        entry, Overloaded{[&](const Plane<Real>& plane) {
                            faces.push_back(endless_face(id, plane.normal, plane.offset));
                          },
                          [&](const Box<Real>& box) { add_sides(id, box); },
                          [&](const Frustum<Real>& frustum) {
                            if (frustum.capped) add_caps(id, frustum);
                          },
                          [](const auto&) {}});
  }

  void add_sides(ShapeId id, const Box<Real>& box) {
    for (int axis = 0; axis < 3; ++axis) {
      const int next = (axis + 1) % 3, last = (axis + 2) % 3;
      for (const bool above : {false, true}) {
        std::array<Vec3<Real>, 4> corners;
        corners.fill(box.min);
        for (int k = 0; k < 4; ++k) {
          if (above) corners[k][axis] = box.max[axis];
          if (k == 1 || k == 2) corners[k][next] = box.max[next];
          if (k >= 2) corners[k][last] = box.max[last];
        }
        Vec3<Real> normal;
        normal[axis] = above ? Real(1) : Real(-1);
        add_near(placed_face(id, normal, corners));
      }
    }
  }
  void add_caps(ShapeId id, const Frustum<Real>& f) {
    if (f.small_radius > Real(0)) {
      add_near(placed_face(id, -f.frame.z, around(f.frame, Real(0), f.small_radius)));
    }
    add_near(placed_face(id, f.frame.z, around(f.frame, f.height, f.large_radius)));
  }
  static void add_to(bounds::Hull<Real>& hull, const FlatFace<Real>& face) {
    const Real margin = kMargin * face.extent;
    for (const Vec3<Real>& corner : face.corners)
      hull.add(corner, {margin, margin, margin});
  }
  // A city has more faces than lie anywhere near its rugs.
  void add_near(const FlatFace<Real>& face) {
    bounds::Hull<Real> own;
    add_to(own, face);
    for (int axis = 0; axis < 3; ++axis) {
      if (own.min[axis] > hull_.max[axis] || own.max[axis] < hull_.min[axis]) return;
    }
    faces.push_back(face);
  }
  FlatFace<Real> placed_face(ShapeId id, Vec3<Real> normal, std::array<Vec3<Real>, 4> corners) {
    const Entry& entry = table_.entries_[id];
    if (!entry.in_object_frame) return flat_face(id, normal, corners);
    const Placement<Real>& place = table_.placements_[entry.placement];
    for (Vec3<Real>& corner : corners)
      corner = place.world_from_object.point(corner);
    return flat_face(id, normal_in_world(place.world_from_object, place.object_from_world, normal),
                     corners);
  }

  const ShapeTable& table_;
  bounds::Hull<Real> hull_;  // of the sheets
};

template <class Real>
void ShapeTable<Real>::lay_sheets(const ShapeList& shapes, Real reach) {
  if (kernels_.parallelograms.empty() && kernels_.discs.empty()) return;
  Flats flats(*this);
  ShapeId next = 0;
  for (const Shape& shape : shapes)
    flats.add_sheet(next++, shape.light != kNoId);
  flats.add_solids();
  for (const Laid<Real>& laid : find_laid(flats.faces, flats.sheets, reach)) {
    // All layers of a stack stay one surface.
    ShapeId layer = twins_.first(laid.shape, true);
    for (; layer != kNoId; layer = twins_.after(layer, true)) {
      move(layer, laid.shift);
      laid_.emplace(layer, laid.shift);
    }
  }
}

template <class Real>
Vec3<Real> ShapeTable<Real>::lift_of_lamp(const std::array<Vec3<Real>, 4>& corners) const {
  Flats flats(*this);
  for (ShapeId id = 0; id < size(); ++id)
    flats.add_sheet(id, false);
  const Vec3<Real> normal =
      normal_of_edges(corners[1] - corners[0], corners[3] - corners[0], MaskOf<Real>(false));
  flats.add(flat_face(size(), normal, corners), true);
  flats.add_solids();
  const auto laid = find_laid(flats.faces, flats.sheets, Real(0));
  return !laid.empty() && laid.back().shape == size() ? laid.back().shift : Vec3<Real>();
}

template <class Real>
void ShapeTable<Real>::move(ShapeId sheet, Vec3<Real> shift) {
  const Entry& entry = entries_[sheet];
  if (static_cast<Kind>(entry.kind) == Kind::parallelogram) {
    for (Vec3<Real>& corner : kernels_.parallelograms[entry.index].corners)
      corner = corner + shift;
    return;
  }
  if (entry.in_object_frame) shift = placements_[entry.placement].object_from_world.vector(shift);
  Vec3<Real>& center = kernels_.discs[entry.index].frame.origin;
  center = center + shift;
}

template Vec3<float> ShapeTable<float>::lift_of_lamp(const std::array<Vec3<float>, 4>&) const;
template void ShapeTable<float>::move(ShapeId, Vec3<float>);
template void ShapeTable<float>::lay_sheets(const ShapeList&, float);
template Vec3<double> ShapeTable<double>::lift_of_lamp(const std::array<Vec3<double>, 4>&) const;
template void ShapeTable<double>::move(ShapeId, Vec3<double>);
template void ShapeTable<double>::lay_sheets(const ShapeList&, double);
#if ALHAZEN_HAS_QUAD
template Vec3<Quad> ShapeTable<Quad>::lift_of_lamp(const std::array<Vec3<Quad>, 4>&) const;
template void ShapeTable<Quad>::move(ShapeId, Vec3<Quad>);
template void ShapeTable<Quad>::lay_sheets(const ShapeList&, Quad);
#endif

}  // namespace alhazen::render

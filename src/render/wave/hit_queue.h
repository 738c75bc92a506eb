// render/wave: what the rays of one generation met, in their order; a ray that met nothing has no
// entry.
#pragma once

#include "core/scene/material.h"
#include "render/accel/hit_lanes.h"
#include "render/wave/column.h"

namespace alhazen::render {

template <class Real>
struct HitColumn {
  Column<Real> t;
  Column<LaneInt<Real>> shape, face, enters;

  Hit<Real> operator[](std::size_t h) const {
    return {t[h], static_cast<ShapeId>(shape[h]), static_cast<int>(face[h]), enters[h] != 0};
  }
  void set(std::size_t h, const Hit<Real>& hit) {
    t[h] = hit.t;
    shape[h] = static_cast<LaneInt<Real>>(hit.shape);
    face[h] = hit.face;
    enters[h] = hit.enters ? 1 : 0;
  }
  void make_room(std::size_t count) {
    t.make_room(count);
    shape.make_room(count);
    face.make_room(count);
    enters.make_room(count);
  }
};

// Faces that a ray passed at the very point of its hit because they are no interface.
struct PassedFaces {
  std::uint32_t hit;
  std::array<Touched, 4> faces;
};

template <class Real>
class HitQueue {
 public:
  Column<LaneInt<Real>> ray;  // index into the generation's RayQueue
  HitColumn<Real> hit;
  Column<LaneInt<Real>> material;
  std::vector<PassedFaces> passed;  // by hit; few have any, and only where rays pass through things
  Vec3Column<Real> position;        // on the surface, world frame of the renderer
  Vec3Column<Real> geometric_normal;  // outward, unit
  Vec3Column<Real> shading_normal;    // unit, on the side that the ray came from
  // Only where the plan has textures.
  Vec3Column<Real> object_position;  // in the shape's object frame
  Column<Real> u, v;                 // of its parametrisation
  RgbColumn<Real> color;             // albedo or reflectance, of materials that have one

  std::size_t size() const { return size_; }
  void clear() {
    size_ = 0;
    passed.clear();
  }
  // For a generation of `count` rays.
  void make_room(std::size_t count) {
    ray.make_room(count);
    hit.make_room(count);
    material.make_room(count);
    position.make_room(count);
    geometric_normal.make_room(count);
    shading_normal.make_room(count);
    color.make_room(count);
  }
  void make_room_for_coordinates() {
    object_position.make_room(size_);
    u.make_room(size_);
    v.make_room(size_);
  }
  // What ray r met; its material is for the caller to set. Precondition: there is room.
  void push(std::size_t r, const Hit<Real>& what) {
    ray[size_] = static_cast<LaneInt<Real>>(r);
    hit.set(size_++, what);
  }
  // The same of the lanes of the mask, in their order.
  template <class L>
  void append(const IntOf<L>& rays, const HitLanes<L>& what, MaskOf<L> which) {
    rays.store_compressed(which, ray.data() + size_);
    what.t.store_compressed(which, hit.t.data() + size_);
    what.shape.store_compressed(which, hit.shape.data() + size_);
    what.face.store_compressed(which, hit.face.data() + size_);
    select(what.enters, IntOf<L>(1), IntOf<L>(0))
        .store_compressed(which, hit.enters.data() + size_);
    size_ += static_cast<std::size_t>(count(which));
  }
  std::size_t ray_of(std::size_t h) const { return static_cast<std::size_t>(ray[h]); }
  MaterialId material_of(std::size_t h) const { return static_cast<MaterialId>(material[h]); }

 private:
  std::size_t size_ = 0;
};

}  // namespace alhazen::render

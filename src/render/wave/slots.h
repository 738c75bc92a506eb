// render/wave: the camera samples of a batch: which they are, and what their rays have added up to.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "render/camera/camera_kernel.h"
#include "render/wave/ray_queue.h"

namespace alhazen::render {

// What is kept of each sample only where something asks for it.
struct SlotWants {
  bool first_surface = false;  // met_something, first_shape, first_color
  bool signature = false, margin = false, rays = false;
};

template <class Real>
struct Slots {
  Column<LaneInt<Real>> x, y;          // the pixel, in the frame
  Column<std::uint32_t> sample;        // its number within the pixel
  Column<Real> offset_x, offset_y;     // of its ray from the pixel's centre, in pixels
  std::vector<std::uint8_t> negative;  // whether the reconstruction filter is, at that place
  std::vector<Rgb<Real>> radiance;
  std::vector<std::uint32_t> rays;          // traced for it, of all kinds, or empty
  std::vector<Rgb<Real>> dropped;           // weight of children that were cut
  std::vector<std::uint8_t> met_something;  // by the camera ray
  std::vector<ShapeId> first_shape;         // that the camera ray met; kNoId: none
  std::vector<Rgb<Real>> first_color;       // its albedo
  std::vector<std::uint64_t> signature;
  std::vector<Real> margin;

  std::size_t size() const { return size_; }
  void resize(std::size_t count, const SlotWants& wants) {
    x.make_room(count);
    y.make_room(count);
    sample.make_room(count);
    size_ = count;
    offset_x.make_room(count);
    offset_y.make_room(count);
    std::fill_n(offset_x.data(), count, Real(0));
    std::fill_n(offset_y.data(), count, Real(0));
    negative.assign(count, 0);
    radiance.assign(count, {});
    rays.assign(wants.rays ? count : 0, 0);
    dropped.assign(count, {});
    const std::size_t firsts = wants.first_surface ? count : 0;
    met_something.assign(firsts, 0);
    first_shape.assign(firsts, kNoId);
    first_color.assign(firsts, {});
    signature.assign(wants.signature ? count : 0, 0);
    margin.assign(wants.margin ? count : 0, Real(1));
  }

 private:
  std::size_t size_ = 0;
};

}  // namespace alhazen::render

// render/shape: the members of ShapeTable (shape_table.h, which includes this) whose lanes have a
// shape each, and what they share with those of one shape.
#pragma once

#include "render/shape/entry_lanes.h"
#include "render/shape/shape_table.h"

namespace alhazen::render {

template <class Real>
template <class L>
CrossingPair<L> ShapeTable<Real>::own_crossings(const IntOf<L>& shape, const Ray<L>& ray,
                                                const IntOf<L>& face, const IntOf<L>& side,
                                                const MaskOf<L>& active) const {
  const EntryLanes<L> entries(entries_, shape, active);
  Ray<L> own = ray;
  if (any(entries.in_object_frame)) {
    const auto place = gathered_kernel<L, Placement>(placements_.data(), entries.placement,
                                                     entries.in_object_frame);
    own = select(entries.in_object_frame, place.in_object(ray), ray);
  }
  CrossingPair<L> result;
  entries.for_each_kind(kernels_, [&](const auto& kernel, const MaskOf<L>& mask) {
    const auto found = render::own_crossings(kernel, own, OwnDeparture<L>{face, side});
    result = select(mask, found, result);
  });
  return result;
}

template <class Real>
template <bool with_coordinates, class L>
SurfacePoint<L> ShapeTable<Real>::surface_of_one(const Entry& entry, const Ray<L>& ray,
                                                 const Crossing<L>& crossing) const {
  const auto on_kernel = [&](const Ray<L>& own) {
    return kernels_.visit(entry, [&](const auto& kernel) {
      return render::surface<with_coordinates>(convert<L>(kernel), own, crossing);
    });
  };
  if (!entry.is_placed()) {
    const Surface<L> point = on_kernel(ray);
    return {point, point.position + Vec3<L>(world_origin_)};
  }
  const auto& place = convert<L>(placements_[entry.placement]);
  if (entry.in_object_frame) return out_of_object(on_kernel(place.in_object(ray)), place);
  const Surface<L> point = on_kernel(ray);
  return {point, place.object_from_world.point(point.position)};
}

template <class Real>
template <bool with_coordinates, class L>
SurfacePoint<L> ShapeTable<Real>::surface_of_each(const IntOf<L>& shape, const Ray<L>& ray,
                                                  const Crossing<L>& crossing,
                                                  const MaskOf<L>& active) const {
  if (ShapeId one; have_one_shape<L>(shape, active, one)) {
    return surface_of_one<with_coordinates>(entries_[one], ray, crossing);
  }
  const EntryLanes<L> entries(entries_, shape, active);
  const auto on_kernels = [&](const Ray<L>& own) {
    Surface<L> points;
    entries.for_each_kind(kernels_, [&](const auto& kernel, const MaskOf<L>& mask) {
      points = select(mask, render::surface<with_coordinates>(kernel, own, crossing), points);
    });
    return points;
  };
  if (!any(entries.placed)) {
    const Surface<L> points = on_kernels(ray);
    return {points, points.position + Vec3<L>(world_origin_)};
  }
  const MaskOf<L> mapped = entries.in_object_frame;
  const auto place =
      gathered_kernel<L, Placement>(placements_.data(), entries.placement, entries.placed);
  const Surface<L> points = on_kernels(select(mapped, place.in_object(ray), ray));
  const SurfacePoint<L> there{points,
                              select(entries.placed, place.object_from_world.point(points.position),
                                     points.position + Vec3<L>(world_origin_))};
  return any(mapped) ? select(mapped, out_of_object(points, place), there) : there;
}

template <class Real>
template <class L>
SurfacePoint<L> ShapeTable<Real>::surface(const IntOf<L>& shape, const Ray<L>& ray,
                                          const Crossing<L>& crossing,
                                          const MaskOf<L>& active) const {
  return surface_of_each<true>(shape, ray, crossing, active);
}

template <class Real>
template <class L>
SurfacePoint<L> ShapeTable<Real>::plain_surface(const IntOf<L>& shape, const Ray<L>& ray,
                                                const Crossing<L>& crossing,
                                                const MaskOf<L>& active) const {
  return surface_of_each<false>(shape, ray, crossing, active);
}

}  // namespace alhazen::render

// A ray of a queue, put there by hand.
#pragma once

#include "render/wave/ray_queue.h"

namespace alhazen::render {

template <class Real>
struct QueuedRay {
  Ray<Real> ray;
  Source source;
  Rgb<Real> weight;
  SlotId slot = 0;
  MediumId medium = kVacuum;
  std::uint64_t path = 0;
  int depth = 0;
  std::uint32_t passed = 0;
};

template <class Real>
void push_ray(RayQueue<Real>& rays, const QueuedRay<Real>& ray) {
  const std::size_t i = rays.size();
  rays.grow(i + 1);
  rays.origin.set(i, ray.ray.origin);
  rays.direction.set(i, ray.ray.direction);
  rays.source.set(i, ray.source);
  rays.weight.set(i, ray.weight);
  rays.slot[i] = ray.slot;
  rays.medium[i] = ray.medium;
  rays.path[i] = ray.path;
  rays.depth[i] = ray.depth;
  rays.passed[i] = ray.passed;
}

}  // namespace alhazen::render

// render/wave: the work of TileRenderer. Included where it is instantiated, once a scalar type.
#pragma once

#include <algorithm>

#include "render/wave/tile.h"

namespace alhazen::render {

template <class Real>
bool TileRenderer<Real>::render(PixelRect tile, Picture& picture) {
  start(tile);
  do {
    if (!run_wanted()) return false;
  } while (want_more());
  finish(picture);
  return true;
}

template <class Real>
void TileRenderer<Real>::start(PixelRect tile) {
  const bool adaptive = job_.plan.runs(StageId::adaptive_rounds);
  const int first = adaptive ? job_.settings.adaptive->min_samples : job_.settings.samples;
  pixels_.clear();
  for (int y = tile.y; y < tile.y + tile.height; ++y) {
    for (int x = tile.x; x < tile.x + tile.width; ++x) {
      Pixel pixel;
      pixel.x = x;
      pixel.y = y;
      pixel.wanted = static_cast<std::uint32_t>(first);
      pixels_.push_back(std::move(pixel));
    }
  }
}

// Runs batches until every pixel has the samples it wants.
template <class Real>
bool TileRenderer<Real>::run_wanted() {
  std::vector<SampleRange> spans;
  std::size_t size = 0;
  const auto flush = [&] {
    const bool done = size == 0 || run_batch(spans);
    spans.clear();
    size = 0;
    return done;
  };
  for (std::size_t p = 0; p < pixels_.size(); ++p) {
    std::uint32_t next = pixels_[p].taken;
    while (next < pixels_[p].wanted) {
      const auto room = static_cast<std::uint32_t>(batch_samples_ - size);
      const std::uint32_t count = std::min(pixels_[p].wanted - next, room);
      spans.push_back({p, next, count});
      next += count;
      size += count;
      if (size == batch_samples_ && !flush()) return false;
    }
  }
  return flush();
}

template <class Real>
bool TileRenderer<Real>::run_batch(const std::vector<SampleRange>& spans) {
  std::size_t size = 0;
  for (const SampleRange& span : spans)
    size += span.count;
  const AovRequest& aovs = job_.options.aovs;
  Slots<Real>& slots = integrator_.wave().slots;
  slots.resize(size, aovs.signature, aovs.margin);
  std::size_t slot = 0;
  for (const SampleRange& span : spans) {
    for (std::uint32_t k = 0; k < span.count; ++k) {
      slots.x[slot] = pixels_[span.pixel].x;
      slots.y[slot] = pixels_[span.pixel].y;
      slots.sample[slot++] = span.first + k;
    }
  }
  if (!integrator_.run_batch()) return false;
  collect(spans);
  samples_ += size;
  return true;
}

template <class Real>
void TileRenderer<Real>::collect(const std::vector<SampleRange>& spans) {
  const Slots<Real>& slots = integrator_.wave().slots;
  const AovRequest& aovs = job_.options.aovs;
  std::size_t slot = 0;
  for (const SampleRange& span : spans) {
    Pixel& pixel = pixels_[span.pixel];
    for (std::uint32_t k = 0; k < span.count; ++k, ++slot) {
      const Rgbd radiance(slots.radiance[slot]);
      const double met = slots.met_something[slot] ? 1 : 0;
      pixel.radiance.add({radiance.r, radiance.g, radiance.b, met}, slots.negative[slot] != 0);
      pixel.rays += slots.rays[slot];
      const Rgbd albedo(slots.first_color[slot]);
      if (aovs.albedo) pixel.albedo.add({albedo.r, albedo.g, albedo.b});
      if (aovs.signature) pixel.signature += mix_64(span.first + k, slots.signature[slot]);
      if (aovs.margin) {
        pixel.margin = std::min(pixel.margin, static_cast<float>(slots.margin[slot]));
      }
      const ShapeId first = slots.first_shape[slot];
      if (first != kNoId && aovs.object_ids) pixel.objects.add(first);
      if (first != kNoId && aovs.material_ids) pixel.materials.add(job_.world.material_of[first]);
      largest_dropped_weight_ = std::max(largest_dropped_weight_,
                                         static_cast<double>(largest_channel(slots.dropped[slot])));
    }
    pixel.taken += span.count;
  }
}

template <class Real>
bool TileRenderer<Real>::want_more() {
  if constexpr (is_built_in(StageId::adaptive_rounds)) {
    if (!job_.plan.runs(StageId::adaptive_rounds)) return false;
    const double before = thread_cpu_seconds();
    const bool more = find_wanting();
    integrator_.wave().counters.add(StageId::adaptive_rounds, pixels_.size(),
                                    thread_cpu_seconds() - before);
    return more;
  }
  return false;
}

// Adaptive sampling: another round for the pixels whose mean is not yet known well enough.
template <class Real>
bool TileRenderer<Real>::find_wanting() {
  const auto& adaptive = job_.settings.adaptive;
  const auto most = static_cast<std::uint32_t>(job_.settings.samples);
  const bool transparent = job_.settings.transparent_background;
  bool any = false;
  for (Pixel& pixel : pixels_) {
    if (pixel.taken >= most) continue;
    const double error = pixel.radiance.standard_error(job_.world.filter, transparent ? 4 : 3);
    if (error <= adaptive->threshold) continue;
    pixel.wanted = std::min(most, 2 * pixel.taken);
    any = true;
  }
  return any;
}

template <class Real>
void TileRenderer<Real>::finish(Picture& picture) {
  const AovRequest& aovs = job_.options.aovs;
  for (const Pixel& pixel : pixels_) {
    const std::size_t column = static_cast<std::size_t>(pixel.x - picture.window.x);
    const std::size_t row = static_cast<std::size_t>(pixel.y - picture.window.y);
    const std::size_t p = row * static_cast<std::size_t>(picture.window.width) + column;
    const auto mean = pixel.radiance.mean(job_.world.filter);
    std::copy(mean.begin(), mean.begin() + 3,
              picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * p));
    picture.alpha[p] = job_.settings.transparent_background ? static_cast<float>(mean[3]) : 1.0F;
    if (aovs.albedo) {
      for (std::size_t c = 0; c < 3; ++c) {
        picture.albedo[3 * p + c] = static_cast<float>(pixel.albedo.mean(c));
      }
    }
    const auto taken = static_cast<float>(pixel.taken);
    if (aovs.samples) picture.samples[p] = taken;
    if (aovs.signature) picture.signature[p] = pixel.signature;
    if (aovs.margin) picture.margin[p] = pixel.margin;
    if (aovs.cost) picture.cost[p] = static_cast<float>(pixel.rays);
    if (aovs.object_ids) picture.objects[p] = pixel.objects.shares(pixel.taken);
    if (aovs.material_ids) picture.materials[p] = pixel.materials.shares(pixel.taken);
    if (aovs.depth || aovs.position || aovs.normal || aovs.uv) {
      ++center_rays_;
      write_center_geometry(job_.world, aovs, job_.camera, pixel.x, pixel.y, p, picture);
    }
  }
}

}  // namespace alhazen::render

// render/wave: the work of TileRenderer. Included where it is instantiated, once a scalar type.
#pragma once

#include <algorithm>

#include "core/base/hash.h"
#include "render/wave/left_out_here.h"
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
  list_pixels(tile, static_cast<std::uint32_t>(adaptive ? job_.settings.adaptive->min_samples
                                                        : job_.settings.samples));
  const bool is_single = job_.settings.samples == 1;
  single_.resize(is_single ? pixels_.size() : 0);
  sums_.assign(is_single ? 0 : pixels_.size(), {});
  data_.clear();
  if (job_.options.aovs.any()) data_.resize(pixels_.size());
}

template <class Real>
void TileRenderer<Real>::list_pixels(PixelRect tile, std::uint32_t samples) {
  // In small blocks: rays that stand side by side in the queues go nearly the same way.
  constexpr int kBlock = 4;
  const int right = tile.x + tile.width, bottom = tile.y + tile.height;
  pixels_.clear();
  for (int top = tile.y; top < bottom; top += kBlock) {
    for (int left = tile.x; left < right; left += kBlock) {
      for (int y = top; y < std::min(top + kBlock, bottom); ++y) {
        for (int x = left; x < std::min(left + kBlock, right); ++x)
          pixels_.push_back({x, y, 0, samples});
      }
    }
  }
}

// Runs batches until every pixel has the samples it wants.
template <class Real>
bool TileRenderer<Real>::run_wanted() {
  spans_.clear();
  std::size_t size = 0;
  const auto flush = [&] {
    const bool done = size == 0 || (!deadline_.is_past() && run_batch(spans_));
    spans_.clear();
    size = 0;
    return done;
  };
  for (std::size_t p = 0; p < pixels_.size(); ++p) {
    std::uint32_t next = pixels_[p].taken;
    while (next < pixels_[p].wanted) {
      const auto room = static_cast<std::uint32_t>(batch_samples_ - size);
      const std::uint32_t count = std::min(pixels_[p].wanted - next, room);
      spans_.push_back({p, next, count});
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
  Slots<Real>& slots = integrator_.wave().slots;
  slots.resize(size, wants_);
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
  std::size_t slot = 0;
  for (const SampleRange& span : spans) {
    Pixel& pixel = pixels_[span.pixel];
    for (std::uint32_t k = 0; k < span.count; ++k, ++slot) {
      const Rgbd radiance(slots.radiance[slot]);
      const double met = wants_.first_surface && slots.met_something[slot] != 0 ? 1 : 0;
      const Accumulator::Value value{radiance.r, radiance.g, radiance.b, met};
      if (sums_.empty()) {
        single_[span.pixel] = value;
      } else {
        sums_[span.pixel].add(value, slots.negative[slot] != 0);
      }
      if (!data_.empty()) collect_data(slot, span.first + k, data_[span.pixel]);
      largest_dropped_weight_ = std::max(largest_dropped_weight_,
                                         static_cast<double>(largest_channel(slots.dropped[slot])));
    }
    pixel.taken += span.count;
  }
}

template <class Real>
void TileRenderer<Real>::collect_data(std::size_t slot, std::uint32_t sample, PixelData& data) {
  const Slots<Real>& slots = integrator_.wave().slots;
  const AovRequest& aovs = job_.options.aovs;
  if (aovs.cost) data.rays += slots.rays[slot];
  if (aovs.signature) data.signature += mix_64(sample, slots.signature[slot]);
  if (aovs.margin) data.margin = std::min(data.margin, static_cast<float>(slots.margin[slot]));
  if (!wants_.first_surface) return;
  const Rgbd albedo(slots.first_color[slot]);
  if (aovs.albedo) data.albedo.add({albedo.r, albedo.g, albedo.b});
  const ShapeId first = slots.first_shape[slot];
  if (first == kNoId) return;
  if (aovs.object_ids) data.objects.add(first);
  if (aovs.material_ids) data.materials.add(job_.world.material_of[first]);
}

template <class Real>
bool TileRenderer<Real>::want_more() {
  if constexpr (is_built_here(StageId::adaptive_rounds)) {
    if (!job_.plan.runs(StageId::adaptive_rounds)) return false;
    Stopwatch stopwatch;
    const bool more = find_wanting();
    integrator_.wave().counters.add(StageId::adaptive_rounds, pixels_.size(), stopwatch.lap());
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
  for (std::size_t k = 0; k < pixels_.size(); ++k) {
    Pixel& pixel = pixels_[k];
    if (pixel.taken >= most) continue;
    const double error = sums_[k].standard_error(job_.world.filter, transparent ? 4 : 3);
    if (error <= adaptive->threshold) continue;
    pixel.wanted = std::min(most, 2 * pixel.taken);
    any = true;
  }
  return any;
}

template <class Real>
void TileRenderer<Real>::finish(Picture& picture) {
  for (std::size_t k = 0; k < pixels_.size(); ++k) {
    const Pixel& pixel = pixels_[k];
    const std::size_t column = static_cast<std::size_t>(pixel.x - picture.window.x);
    const std::size_t row = static_cast<std::size_t>(pixel.y - picture.window.y);
    const std::size_t p = row * static_cast<std::size_t>(picture.window.width) + column;
    const auto mean = sums_.empty() ? single_[k] : sums_[k].mean(job_.world.filter);
    std::copy(mean.begin(), mean.begin() + 3,
              picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * p));
    picture.alpha[p] = job_.settings.transparent_background ? static_cast<float>(mean[3]) : 1.0F;
    if (!data_.empty()) finish_data(pixel, data_[k], p, picture);
  }
}

template <class Real>
void TileRenderer<Real>::finish_data(const Pixel& pixel, const PixelData& data, std::size_t p,
                                     Picture& picture) {
  const AovRequest& aovs = job_.options.aovs;
  if (aovs.albedo) {
    for (std::size_t c = 0; c < 3; ++c)
      picture.albedo[3 * p + c] = static_cast<float>(data.albedo.mean(c));
  }
  if (aovs.samples) picture.samples[p] = static_cast<float>(pixel.taken);
  if (aovs.signature) picture.signature[p] = data.signature;
  if (aovs.margin) picture.margin[p] = data.margin;
  if (aovs.cost) picture.cost[p] = static_cast<float>(data.rays);
  if (aovs.object_ids) picture.objects[p] = data.objects.shares(pixel.taken);
  if (aovs.material_ids) picture.materials[p] = data.materials.shares(pixel.taken);
  if (aovs.depth || aovs.position || aovs.normal || aovs.uv) {
    ++center_rays_;
    write_center_geometry(job_.world, aovs, job_.camera, pixel.x, pixel.y, p, picture);
  }
}

}  // namespace alhazen::render

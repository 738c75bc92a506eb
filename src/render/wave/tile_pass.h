// render/wave: the work of TileRenderer in passes over a picture. Included where it is
// instantiated, once a scalar type.
#pragma once

#include <utility>

#include "render/wave/tile_render.h"

namespace alhazen::render {

template <class Real>
void TileRenderer<Real>::swap_with(Kept& kept) {
  std::swap(pixels_, kept.pixels_);
  std::swap(sums_, kept.sums_);
  std::swap(data_, kept.data_);
}

template <class Real>
bool TileRenderer<Real>::add_samples(PixelRect tile, const Deadline& deadline, PixelRect window,
                                     ErrorControl& control, Kept& kept) {
  swap_with(kept);
  deadline_ = deadline;
  single_.clear();
  if (pixels_.empty()) {
    list_pixels(tile, 0);
    sums_.resize(pixels_.size());
    data_.resize(job_.options.aovs.any() ? pixels_.size() : 0);
  }
  const auto number_of = [&](const Pixel& pixel) {
    return static_cast<std::size_t>(pixel.y - window.y) * static_cast<std::size_t>(window.width) +
           static_cast<std::size_t>(pixel.x - window.x);
  };
  wanting_.clear();
  for (std::size_t k = 0; k < pixels_.size(); ++k) {
    Pixel& pixel = pixels_[k];
    const std::uint32_t wanted = control.wanted(number_of(pixel));
    if (wanted == pixel.taken) continue;
    const Value mean = sums_[k].mean(job_.world.filter);
    wanting_.push_back({k, wanted, mean, mean});
    pixel.wanted = pixel.taken + (wanted - pixel.taken) / 2;
  }
  bool done = run_wanted();
  for (Wanting& w : wanting_) {
    w.middle = sums_[w.pixel].mean(job_.world.filter);
    pixels_[w.pixel].wanted = w.wanted;
  }
  done = done && run_wanted();
  for (const Wanting& w : wanting_) {
    if (pixels_[w.pixel].taken < w.wanted) continue;
    const Value mean = sums_[w.pixel].mean(job_.world.filter);
    const std::size_t p = number_of(pixels_[w.pixel]);
    if (w.wanted == 1) {
      control.record_first(p, {mean[0], mean[1], mean[2]});
      continue;
    }
    PixelChange change;
    for (std::size_t c = 0; c < 3; ++c) {
      change.outer[c] = w.before[c] - mean[c];
      // Of a half in two parts B1 and B2 beside A: the means are A, (2 A + B1) / 3, (2 A + B1 + B2)
      // / 4.
      if (w.wanted >= 4) change.inner[c] = 3 * w.middle[c] - w.before[c] - 2 * mean[c];
    }
    control.record(p, change);
  }
  swap_with(kept);
  return done;
}

template <class Real>
void TileRenderer<Real>::finish(Kept& kept, Picture& picture) {
  swap_with(kept);
  finish(picture);
  swap_with(kept);
}

template <class Real>
bool TileRenderer<Real>::probe(std::span<const Place> places,
                               std::span<std::array<double, 4>> radiance) {
  pixels_.clear();
  for (const Place& place : places)
    pixels_.push_back({place.x, place.y, 0, 1});
  sums_.clear();
  data_.clear();
  single_.assign(pixels_.size(), {});
  deadline_ = {};
  const bool done = run_wanted();
  std::copy(single_.begin(), single_.end(), radiance.begin());
  pixels_.clear();
  single_.clear();
  return done;
}

}  // namespace alhazen::render

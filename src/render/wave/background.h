// render/wave: what a ray sees that meets nothing.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/math/elementary.h"
#include "core/scene/camera.h"
#include "render/wave/render.h"

namespace alhazen::render {

template <class Real>
class BackgroundRadiance {
 public:
  BackgroundRadiance(const Background& background, const std::vector<ImagePixels>& images)
      : kind_(static_cast<Kind>(background.source.index())) {
    if (const auto* solid = std::get_if<SolidBackground>(&background.source)) {
      color_ = Rgb<Real>(solid->color);
    } else if (const auto* gradient = std::get_if<GradientBackground>(&background.source)) {
      for (const GradientStop& stop : gradient->stops) {
        stops_.push_back({static_cast<Real>(stop.position), Rgb<Real>(stop.color)});
      }
    } else if (const auto* picture = std::get_if<EnvironmentBackground>(&background.source)) {
      image_ = &images[picture->image];
      turns_ = static_cast<Real>(picture->rotation_deg / 360);
      intensity_ = static_cast<Real>(picture->intensity);
    }
  }

  // The radiance from direction `d`, unit length to rounding, world frame.
  Rgb<Real> operator()(Vec3<Real> d) const {
    switch (kind_) {
      case Kind::solid:
        return color_;
      case Kind::gradient:
        return gradient(d.y);
      default:
        return picture(d);
    }
  }

 private:
  enum class Kind { solid, gradient, picture };
  struct Stop {
    Real position;
    Rgb<Real> color;
  };

  Rgb<Real> gradient(Real position) const {
    if (position <= stops_.front().position) return stops_.front().color;
    for (std::size_t i = 1; i < stops_.size(); ++i) {
      const Stop &a = stops_[i - 1], &b = stops_[i];
      if (position < b.position) {
        const Real share = (position - a.position) / (b.position - a.position);
        return (Real(1) - share) * a.color + share * b.color;
      }
    }
    return stops_.back().color;
  }

  // Bilinear between pixel centres; the picture wraps around in azimuth and ends at the poles.
  Rgb<Real> picture(Vec3<Real> d) const {
    const Real azimuth = atan2_turns(d.x, d.z) - turns_;
    const Real u = azimuth - round_down(azimuth + Real(0.5)) + Real(0.5);
    const Real v = Real(2) * acos_turns(larger(Real(-1), smaller(Real(1), d.y)));
    const Real x = u * static_cast<Real>(image_->width) - Real(0.5);
    const Real y = v * static_cast<Real>(image_->height) - Real(0.5);
    const Real x0 = round_down(x), y0 = round_down(y);
    const Real fx = x - x0, fy = y - y0;
    const auto column = static_cast<std::int64_t>(x0), row = static_cast<std::int64_t>(y0);
    const Rgb<Real> top = (Real(1) - fx) * texel(column, row) + fx * texel(column + 1, row);
    const Rgb<Real> bottom =
        (Real(1) - fx) * texel(column, row + 1) + fx * texel(column + 1, row + 1);
    return intensity_ * ((Real(1) - fy) * top + fy * bottom);
  }

  Rgb<Real> texel(std::int64_t column, std::int64_t row) const {
    const std::int64_t x = ((column % image_->width) + image_->width) % image_->width;
    const std::int64_t y = std::clamp<std::int64_t>(row, 0, image_->height - 1);
    const float* p = &image_->rgb[static_cast<std::size_t>(3 * (y * image_->width + x))];
    return {static_cast<Real>(p[0]), static_cast<Real>(p[1]), static_cast<Real>(p[2])};
  }

  Kind kind_;
  Rgb<Real> color_;
  std::vector<Stop> stops_;
  const ImagePixels* image_ = nullptr;
  Real turns_{}, intensity_{};
};

}  // namespace alhazen::render

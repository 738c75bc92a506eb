// render/wave: what a ray sees that meets nothing.
#pragma once

#include <vector>

#include "core/math/elementary.h"
#include "core/scene/camera.h"
#include "render/surface/gradient.h"
#include "render/surface/texture_image.h"
#include "render/wave/render.h"

namespace alhazen::render {

template <class Real>
class BackgroundRadiance {
 public:
  BackgroundRadiance(const Background& background, const std::vector<ImagePixels>& images) {
    if (const auto* solid = std::get_if<SolidBackground>(&background.source)) {
      color_ = Rgb<Real>(solid->color);
    } else if (const auto* gradient = std::get_if<GradientBackground>(&background.source)) {
      set_stops(gradient->stops);
    } else if (const auto* picture = std::get_if<EnvironmentBackground>(&background.source)) {
      const ImagePixels& image = images[picture->image];
      image_ = {image.rgb.data(), image.width, image.height};
      turns_ = static_cast<Real>(picture->rotation_deg / 360);
      intensity_ = static_cast<Real>(picture->intensity);
    }
  }

  // The radiance from direction `d`, unit length to rounding, world frame, of a colour or a
  // gradient.
  template <class L = Real>
  Rgb<L> plain(Vec3<L> d) const {
    return stops_.empty() ? Rgb<L>(color_) : gradient_color<L>(stops_, d.y);
  }

  // The same of a picture of the surroundings. It wraps around in azimuth and ends at the poles.
  template <class L = Real>
  Rgb<L> picture(Vec3<L> d) const {
    const L azimuth = atan2_turns(d.x, d.z) - turns_;
    const L u = folded(azimuth + Real(0.5), ImageWrap::repeat);
    const L v = 2 * acos_turns(larger(L(-1), smaller(L(1), d.y)));
    const PixelPair<L> columns = pixel_pair(u, image_.width, ImageWrap::repeat);
    const PixelPair<L> rows = pixel_pair(v, image_.height, ImageWrap::clamp);
    return L(intensity_) * bilinear(image_, columns, rows);
  }

 private:
  // A gradient between equal colours is that colour.
  void set_stops(const std::vector<GradientStop>& stops) {
    color_ = Rgb<Real>(stops.front().color);
    if (is_one_color(stops)) return;
    for (const GradientStop& stop : stops)
      stops_.push_back({static_cast<Real>(stop.position), Rgb<Real>(stop.color)});
  }

  Rgb<Real> color_;
  std::vector<ColorStop<Real>> stops_;
  ImageView image_;
  Real turns_{}, intensity_{};
};

}  // namespace alhazen::render

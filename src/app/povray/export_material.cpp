// app/povray: materials as texture and interior. POV-Ray has no 1/pi: a diffuse surface of ours is
// `diffuse 1/pi` there, so that lights keep their numbers.
#include <algorithm>
#include <limits>

#include "app/povray/exporter.h"
#include "core/base/overloaded.h"
#include "render/surface/coat.h"
#include "render/surface/fresnel.h"
#include "render/surface/highlight.h"

namespace alhazen {
namespace {

// `premultiplied off`: POV-Ray divides an EXR picture by its alpha, and takes `transmit all` for
// it.
std::string image_map(Exporter& exporter, const Texture& texture, const std::string& more) {
  const auto& pattern = std::get<ImagePattern>(texture.pattern);
  return fmt::format("image_map {{ exr \"{}\" gamma 1 premultiplied off{}{} }}",
                     exporter.image_name(pattern.image),
                     pattern.filter == ImageFilter::bilinear ? " interpolate 2" : "", more);
}

// Colours as they are.
class PigmentLeaf : public LeafWriter {
 public:
  explicit PigmentLeaf(double filter = 0, double transmit = 0)
      : filter_(filter), transmit_(transmit) {}

  const char* block() const override { return "pigment"; }
  void color(Exporter& exporter, Rgbd c) const override {
    if (filter_ == 0 && transmit_ == 0) {
      exporter.out.line("color " + pov_color(c));
    } else {
      exporter.out.line(fmt::format("color rgbft <{}, {}, {}, {}, {}>", pov_number(c.r),
                                    pov_number(c.g), pov_number(c.b), pov_number(filter_),
                                    pov_number(transmit_)));
    }
  }
  void image(Exporter& exporter, const Texture& texture, const std::string& warp) const override {
    std::string see_through;
    if (filter_ > 0) see_through += " filter all " + pov_number(filter_);
    if (transmit_ > 0) see_through += " transmit all " + pov_number(transmit_);
    exporter.out.line(image_map(exporter, texture, see_through));
    if (!warp.empty()) exporter.out.line(warp);
  }

 private:
  double filter_, transmit_;
};

// A whole texture for each colour, where the finish depends on it.
class TextureLeaf : public LeafWriter {
 public:
  const char* block() const override { return "texture"; }

 protected:
  static void write(Exporter& exporter, Rgbd pigment, const std::string& finish) {
    exporter.out.line(fmt::format("pigment {{ {} }}", pov_color(pigment)));
    exporter.out.line(fmt::format("finish {{ {} }}", finish));
  }
};

class MirrorLeaf : public TextureLeaf {
 public:
  explicit MirrorLeaf(std::string emission) : emission_(std::move(emission)) {}
  void color(Exporter& exporter, Rgbd c) const override {
    write(exporter, Rgbd(1),
          fmt::format("ambient 0 diffuse 0{} reflection {{ {} }}", emission_, pov_color(c)));
  }
  void image(Exporter& exporter, const Texture& texture, const std::string&) const override {
    exporter.deviate(DeviationKind::mirror_image, texture.span);
    const auto& pixels = exporter.images[std::get<ImagePattern>(texture.pattern).image].rgb;
    Rgbd sum;
    for (std::size_t i = 0; i + 2 < pixels.size(); i += 3)
      sum += Rgbd(pixels[i], pixels[i + 1], pixels[i + 2]);
    color(exporter, sum / std::max(1.0, static_cast<double>(pixels.size() / 3)));
  }

 private:
  std::string emission_;
};

// POV-Ray multiplies what a surface gives off by its pigment, so here it is divided by it; a black
// channel becomes one in 10^6, far below the rounding of a half float.
class GlowingLeaf : public TextureLeaf {
 public:
  GlowingLeaf(Rgbd emission, std::string finish)
      : emission_(emission), finish_(std::move(finish)) {}
  void color(Exporter& exporter, Rgbd c) const override {
    const Rgbd p(std::max(c.r, 1e-6), std::max(c.g, 1e-6), std::max(c.b, 1e-6));
    const Rgbd share(emission_.r / p.r, emission_.g / p.g, emission_.b / p.b);
    write(exporter, p, fmt::format("{} emission {}", finish_, pov_color(share)));
  }
  void image(Exporter& exporter, const Texture& texture, const std::string& warp) const override {
    exporter.deviate(DeviationKind::glowing_image, texture.span);
    exporter.out.open("pigment");
    PigmentLeaf().image(exporter, texture, warp);
    exporter.out.close();
    exporter.out.line(fmt::format("finish {{ {} }}", finish_));
  }

 private:
  Rgbd emission_;
  std::string finish_;
};

class MaterialExport {
 public:
  MaterialExport(Exporter& exporter, const Material& material, const SurfaceFrame& frame)
      : exporter_(exporter), material_(material), frame_(frame) {}

  void write() {
    std::visit([this](const auto& m) { scattering(m); }, material_.scattering);
    // A lamp that shines on one side is a rectangle, or a ball, whose inside nobody sees.
    const bool has_dark_side = material_.one_sided_emission && !is_black(material_.emission) &&
                               std::holds_alternative<Quad4>(frame_.shape->geometry);
    if (!has_dark_side) return;
    out().line("interior_texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }");
  }

 private:
  PovWriter& out() { return exporter_.out; }

  std::string emission() const {
    return is_black(material_.emission) ? "" : " emission " + pov_color(material_.emission);
  }

  void plain(const std::string& pigment, const std::string& finish) {
    out().line(fmt::format("texture {{ pigment {{ {} }} finish {{ {} }} }}", pigment, finish));
  }

  // A pattern of colours that scatter as `finish` says, and what the material gives off besides.
  void scattering_colors(TextureId color, const std::string& finish) {
    out().open("texture");
    if (is_black(material_.emission)) {
      out().open("pigment");
      export_texture(exporter_, color, frame_, PigmentLeaf());
      out().close();
      out().line(fmt::format("finish {{ {} }}", finish));
    } else {
      export_texture(exporter_, color, frame_, GlowingLeaf(material_.emission, finish));
    }
    out().close();
  }

  void scattering(const Diffuse& m) {
    std::string finish = fmt::format("ambient {} diffuse 1/pi", pov_color(exporter_.ambient));
    if (!is_black(m.highlight.strength)) {
      exporter_.deviate(DeviationKind::highlight, material_.span);
      finish += highlight(m.highlight);
    }
    scattering_colors(m.albedo, finish);
  }

  // Our lobe's scale at its peak, for light that comes along the normal.
  static std::string highlight(const Highlight& h) {
    const Rgbd scale = render::make_highlight_lobe<double>(h).scale;
    const double peak = (scale.r + scale.g + scale.b) / 3;
    if (h.model == HighlightModel::phong) {
      return fmt::format(" phong {} phong_size {}", pov_number(peak), pov_number(h.exponent));
    }
    return fmt::format(" specular {} roughness {}", pov_number(peak), pov_number(1 / h.exponent));
  }

  void scattering(const Mirror& m) {
    out().open("texture");
    export_texture(exporter_, m.reflectance, frame_, MirrorLeaf(emission()));
    out().close();
  }

  void scattering(const Metal& m) {
    exporter_.deviate(DeviationKind::metal, material_.span);
    const Rgbd facing = render::conductor_reflectance(1.0, m.n, m.k, 1.0);
    plain("rgb 1", fmt::format("ambient 0 diffuse 0{} reflection {{ {}, rgb 1 falloff 5 }}",
                               emission(), pov_color(facing)));
  }

  void scattering(const Glass& m) {
    if (m.priority != 0) exporter_.deviate(DeviationKind::priority, material_.span);
    if (exporter_.effects.has(Effect::tinted_shadows)) {
      exporter_.deviate(DeviationKind::glass_shadow, material_.span);
    }
    if (!is_black(m.absorption)) {
      exporter_.deviate(DeviationKind::internal_absorption, material_.span);
    }
    if (!is_black(material_.emission)) {
      exporter_.deviate(DeviationKind::glowing_glass, material_.span);
    }
    plain("rgbf <1, 1, 1, 1>",
          "ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel on } conserve_energy");
    // exp(-(1 - c) d / distance) with 1001 as power, in POV-Ray's way of saying it. What is too
    // little for 1 / most to be a number is nothing.
    std::string fade;
    const double most = largest_channel(m.absorption);
    if (most >= std::numeric_limits<double>::min()) {
      fade = fmt::format(" fade_power 1001 fade_distance {} fade_color {}", pov_number(1 / most),
                         pov_color(Rgbd(1) - m.absorption / most));
    }
    out().line(fmt::format("interior {{ ior {}{} }}", pov_number(m.ior), fade));
  }

  void scattering(const Coat& m) {
    exporter_.deviate(DeviationKind::coat, material_.span);
    if (!is_black(exporter_.ambient)) {
      exporter_.deviate(DeviationKind::coated_sky, material_.span);
    }
    // The base as it looks from straight above in light from straight above, for a medium grey.
    const auto layer = render::make_coat_layer<double>(m);
    const Rgbd value = render::coat_diffuse_value(layer, Rgbd(0.5), 1.0, 1.0) / 0.5;
    scattering_colors(
        m.base_albedo,
        fmt::format("ambient {} diffuse {} reflection {{ rgb 0, rgb 1 fresnel on }}",
                    pov_color(exporter_.ambient), pov_number((value.r + value.g + value.b) / 3)));
    out().line(fmt::format("interior {{ ior {} }}", pov_number(m.ior)));
  }

  void scattering(const Black&) { plain("rgb 1", "ambient 0 diffuse 0" + emission()); }

  void scattering(const PovFinish& m) {
    // An even sky adds color * diffuse * opacity * radiance: so does this much more ambient.
    std::string finish = fmt::format("ambient {} diffuse {} brilliance {}",
                                     pov_color(m.ambient + m.diffuse * exporter_.ambient),
                                     pov_number(m.diffuse), pov_number(m.brilliance));
    if (!is_black(m.emission)) finish += " emission " + pov_color(m.emission);
    if (m.phong > 0) {
      finish +=
          fmt::format(" phong {} phong_size {}", pov_number(m.phong), pov_number(m.phong_size));
    }
    if (m.specular > 0) {
      finish +=
          fmt::format(" specular {} roughness {}", pov_number(m.specular), pov_number(m.roughness));
    }
    if (m.metallic > 0) finish += " metallic " + pov_number(m.metallic);
    const PovReflection& r = m.reflection;
    if (!is_black(r.min) || !is_black(r.max)) {
      finish += fmt::format(" reflection {{ {}, {} falloff {}{}{} }}", pov_color(r.min),
                            pov_color(r.max), pov_number(r.falloff), r.fresnel ? " fresnel on" : "",
                            r.metallic > 0 ? " metallic " + pov_number(r.metallic) : "");
    }
    if (m.conserve_energy) finish += " conserve_energy";
    out().open("texture");
    out().open("pigment");
    export_texture(exporter_, m.color, frame_, PigmentLeaf(m.filter, m.transmit));
    out().close();
    out().line(fmt::format("finish {{ {} }}", finish));
    out().close();
    std::string fade;
    if (m.fade_power > 0 && m.fade_distance > 0) {
      fade = fmt::format(" fade_power {} fade_distance {} fade_color {}", pov_number(m.fade_power),
                         pov_number(m.fade_distance), pov_color(m.fade_color));
    }
    out().line(fmt::format("interior {{ ior {}{} }}", pov_number(m.ior), fade));
  }

  Exporter& exporter_;
  const Material& material_;
  const SurfaceFrame& frame_;
};

bool stays_with_object(const Exporter& exporter, TextureId id) {
  if (exporter.solid[id]) return true;
  const Texture& texture = exporter.scene.textures[id];
  if (texture.mapping != Mapping::object) return false;
  const auto both = [&](TextureId a, TextureId b) {
    return stays_with_object(exporter, a) && stays_with_object(exporter, b);
  };
  return std::visit(Overloaded{[&](const CheckerPattern& p) { return both(p.even, p.odd); },
                               [&](const StripesPattern& p) { return both(p.even, p.odd); },
                               [&](const BrickPattern& p) { return both(p.brick, p.mortar); },
                               [](const auto&) { return true; }},
                    texture.pattern);
}

}  // namespace

void export_material(Exporter& exporter, const Material& material, const SurfaceFrame& frame) {
  MaterialExport(exporter, material, frame).write();
}

bool is_shareable(const Exporter& exporter, const Material& material) {
  if (material.one_sided_emission) return false;
  return std::visit(
      Overloaded{[&](const Diffuse& m) { return stays_with_object(exporter, m.albedo); },
                 [&](const Mirror& m) { return stays_with_object(exporter, m.reflectance); },
                 [&](const Coat& m) { return stays_with_object(exporter, m.base_albedo); },
                 [&](const PovFinish& m) { return stays_with_object(exporter, m.color); },
                 [](const auto&) { return true; }},
      material.scattering);
}

}  // namespace alhazen

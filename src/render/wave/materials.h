// render/wave: the scene's materials as the stages want them: flat records, kinds that tell the
// stages apart, constants of the optics computed once.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/live.h"
#include "core/scene/scene.h"
#include "render/simd/records.h"
#include "render/surface/coat.h"
#include "render/surface/highlight.h"
#include "render/surface/pov_finish.h"
#include "render/surface/texture_table.h"

namespace alhazen::render {

// Which stages a hit goes to. `matte` is diffuse without a highlight, `glossy` diffuse with one.
enum class SurfaceKind : std::uint8_t { black, matte, glossy, coat, mirror, metal, glass, pov };
inline constexpr std::size_t kSurfaceKinds = 8;

// What a straight path finds at a surface: an end, a dielectric, or a finish of POV-Ray's that lets
// light through.
enum class Way : std::uint32_t { ends, through_glass, through_clear };

// All that sorting hits by what their surfaces do asks of a material.
struct MaterialRoute {
  SurfaceKind kind = SurfaceKind::black;
  bool emits = false;
  bool one_sided = false;  // emits where its surface is met from outside
  bool pov_glows = false, pov_reflects = false;
  bool pov_clear = false;  // lets light through
  bool more = false;       // any of these
};

template <class Real>
struct MaterialRecord : MaterialRoute {
  Rgb<Real> emission;
  TextureId color = kNoId;  // albedo or reflectance
  Rgb<Real> solid_color;    // if it is the same everywhere
  HighlightLobe<Real> lobe;
  CoatLayer<Real> coat;
  Rgb<Real> conductor_n, conductor_k;
  Real ior = 1;          // of the inside of glass and of a pov_finish
  Rgb<Real> absorption;  // of glass, per length
  // Of a pov_finish.
  Rgb<Real> pov_glow;
  PovShading<Real> pov_shading;
  PovMirror<Real> pov_mirror;
  PovPassage<Real> pov_passage;
  PovFading<Real> pov_fading;
};

template <class Real>
class MaterialTable {
 public:
  MaterialTable(const Scene& scene, const TextureTable<Real>& textures) {
    const Surroundings around = surroundings_of(scene);
    for (const Material& material : scene.materials) {
      MaterialRecord<Real> record;
      record.emission = Rgb<Real>(material.emission);
      record.emits = !is_black(material.emission);
      record.one_sided = material.one_sided_emission;
      std::visit([&](const auto& m) { fill(m, around, record); }, material.scattering);
      record.more = record.emits || record.pov_glows || record.pov_reflects || record.pov_clear;
      std::uint32_t pattern = 0;
      if (record.color != kNoId) {
        const std::optional<Rgb<Real>> everywhere = textures.solid_color(record.color);
        record.solid_color = everywhere.value_or(Rgb<Real>{});
        if (!everywhere) pattern = record.color + 1;
      }
      patterns_.push_back(pattern);
      routes_.push_back(record);
      ways_.push_back(static_cast<std::uint32_t>(way_of(record)));
      records_.push_back(record);
      const auto* glass = std::get_if<Glass>(&material.scattering);
      priorities_.push_back(glass ? glass->priority : 0);
    }
  }

  std::size_t size() const { return records_.size(); }
  const MaterialRecord<Real>& operator[](MaterialId id) const { return records_[id]; }
  // The same member of the records of several materials, which is a record of
  // numbers.
  template <class L, template <class> class Record>
  Record<L> records_of(Record<Real> MaterialRecord<Real>::*member, const IntOf<L>& id,
                       MaskOf<L> active) const {
    static_assert(sizeof(MaterialRecord<Real>) % sizeof(Real) == 0);
    constexpr auto kStride = static_cast<int>(sizeof(MaterialRecord<Real>) / sizeof(Real));
    return gathered<L, Record>(&(records_.data()->*member), id, active, kStride);
  }
  template <class L>
  L numbers_of(Real MaterialRecord<Real>::*member, const IntOf<L>& id, MaskOf<L> active) const {
    constexpr auto kStride = static_cast<int>(sizeof(MaterialRecord<Real>) / sizeof(Real));
    if (!any(active)) return L(0);
    if (all_same(id, active)) {
      return L(records_[static_cast<std::size_t>(first_of(id, active))].*member);
    }
    return L::gather(&(records_.data()->*member), id * IntOf<L>(kStride), active);
  }
  // The Way of each lane's material.
  template <class L>
  IntOf<L> ways_of(const IntOf<L>& id, MaskOf<L> active) const {
    return gathered_words<L>(ways_.data(), id, active);
  }
  // Of each lane's material 1 + the TextureId of a colour that is not the same everywhere, else 0.
  template <class L>
  IntOf<L> patterns_of(const IntOf<L>& id, MaskOf<L> active) const {
    return gathered_words<L>(patterns_.data(), id, active);
  }
  const MaterialRoute& route(MaterialId id) const { return routes_[id]; }
  const std::vector<int>& priorities() const { return priorities_; }

 private:
  static Way way_of(const MaterialRoute& route) {
    if (route.kind == SurfaceKind::glass) return Way::through_glass;
    return route.pov_clear ? Way::through_clear : Way::ends;
  }
  static void fill(const Diffuse& m, const Surroundings& around, MaterialRecord<Real>& record) {
    record.color = m.albedo;
    if (shows_highlight(m, around)) {
      record.lobe = make_highlight_lobe<Real>(m.highlight);
      record.kind = SurfaceKind::glossy;
    } else if (shows_color(m.albedo, around)) {
      record.kind = SurfaceKind::matte;
    }
  }
  static void fill(const Mirror& m, const Surroundings& around, MaterialRecord<Real>& record) {
    record.color = m.reflectance;
    if (!is_black(around.solid, m.reflectance)) record.kind = SurfaceKind::mirror;
  }
  static void fill(const Metal& m, const Surroundings& around, MaterialRecord<Real>& record) {
    if (reflects(m, around)) record.kind = SurfaceKind::metal;
    record.conductor_n = Rgb<Real>(m.n);
    record.conductor_k = Rgb<Real>(m.k);
  }
  static void fill(const Glass& m, const Surroundings&, MaterialRecord<Real>& record) {
    record.kind = SurfaceKind::glass;
    record.ior = static_cast<Real>(m.ior);
    record.absorption = Rgb<Real>(m.absorption);
  }
  static void fill(const Coat& m, const Surroundings&, MaterialRecord<Real>& record) {
    record.kind = SurfaceKind::coat;
    record.color = m.base_albedo;
    record.coat = make_coat_layer<Real>(m);
  }
  static void fill(const PovFinish& m, const Surroundings& around, MaterialRecord<Real>& record) {
    record.kind = SurfaceKind::pov;
    record.color = m.color;
    record.ior = static_cast<Real>(m.ior);
    const PovSurface<Real> surface = make_pov_surface<Real>(m);
    record.pov_glow = surface.glow;
    record.pov_shading = surface.shading;
    record.pov_mirror = surface.mirror;
    record.pov_passage = surface.passage;
    record.pov_fading = surface.fading;
    record.pov_glows = glows(m, around.solid);
    record.pov_reflects = reflects(m, around);
    record.pov_clear = lets_light_through(m, around.solid);
  }
  static void fill(const Black&, const Surroundings&, MaterialRecord<Real>&) {}

  std::vector<MaterialRecord<Real>> records_;
  std::vector<MaterialRoute> routes_;  // a few bytes a material: they stay in the cache
  std::vector<std::uint32_t> ways_, patterns_;
  std::vector<int> priorities_;
};

}  // namespace alhazen::render

// parser/eval: interning by the fields of a record.
#include "parser/eval/store.h"

#include <bit>
#include <cstdint>

#include "core/base/hash.h"
#include "core/base/overloaded.h"
#include "core/base/small_vector.h"

namespace alhazen::parser {
namespace {

// The fields of a record go to a sink, word by word. Two records are the same if and only if their
// words are; -0 and 0 are one word.
template <class Sink>
class Fields {
 public:
  explicit Fields(Sink& sink) : sink_(sink) {}

  Fields& add(double x) { return add(std::bit_cast<std::uint64_t>(x + 0.0)); }
  Fields& add(std::uint64_t word) {
    sink_.take(word);
    return *this;
  }
  Fields& add(Rgbd c) { return add(c.r).add(c.g).add(c.b); }
  Fields& add(Vec3d v) { return add(v.x).add(v.y).add(v.z); }
  Fields& add(const Affined& map) {
    for (const auto& row : map.rows) {
      for (const double entry : row)
        add(entry);
    }
    return *this;
  }
  Fields& add(std::string_view text) {
    add(std::uint64_t{text.size()});
    for (const char byte : text)
      add(static_cast<std::uint64_t>(byte));
    return *this;
  }

 private:
  Sink& sink_;
};

// A record is made for each of a million shapes: most keys need no allocation.
struct Key {
  void take(std::uint64_t word) { words.push_back(word); }
  std::uint64_t hash() const {
    std::uint64_t hash = 0;
    for (const std::uint64_t word : words) {
      hash = (hash ^ word) * 0x9e3779b97f4a7c15ULL;
      hash ^= hash >> 32;
    }
    return mix_64(hash);
  }
  SmallVector<std::uint64_t, 48> words;
};

// Whether the words are those of a key.
struct Comparison {
  void take(std::uint64_t word) {
    same = same && count < key.words.size() && key.words[count] == word;
    ++count;
  }
  bool holds() const { return same && count == key.words.size(); }
  const Key& key;
  std::size_t count = 0;
  bool same = true;
};

template <class Sink>
void add_pattern(Fields<Sink>& key, const Pattern& pattern) {
  key.add(std::uint64_t{pattern.index()});
  std::visit(Overloaded{[&](const SolidPattern& p) { key.add(p.color); },
                        [&](const CheckerPattern& p) {
                          key.add(std::uint64_t{p.even}).add(std::uint64_t{p.odd});
                        },
                        [&](const StripesPattern& p) {
                          key.add(std::uint64_t{p.even}).add(std::uint64_t{p.odd});
                        },
                        [&](const BrickPattern& p) {
                          key.add(std::uint64_t{p.brick}).add(std::uint64_t{p.mortar});
                          key.add(p.size).add(p.mortar_width);
                        },
                        [&](const GradientPattern& p) {
                          key.add(std::uint64_t{p.stops.size()});
                          for (const GradientStop& stop : p.stops)
                            key.add(stop.position).add(stop.color);
                        },
                        [&](const ImagePattern& p) {
                          key.add(std::uint64_t{p.image});
                          key.add(static_cast<std::uint64_t>(p.wrap));
                          key.add(static_cast<std::uint64_t>(p.filter));
                        }},
             pattern);
}

template <class Sink>
void add_finish(Fields<Sink>& key, const PovFinish& m) {
  key.add(std::uint64_t{m.color}).add(m.filter).add(m.transmit).add(m.ambient).add(m.emission);
  key.add(m.diffuse).add(m.brilliance).add(m.phong).add(m.phong_size);
  key.add(m.specular).add(m.roughness).add(m.metallic);
  key.add(m.reflection.min).add(m.reflection.max).add(m.reflection.falloff);
  key.add(std::uint64_t{m.reflection.fresnel}).add(m.reflection.metallic);
  key.add(std::uint64_t{m.conserve_energy}).add(m.ior);
  key.add(m.fade_distance).add(m.fade_power).add(m.fade_color);
}

template <class Sink>
void add_scattering(Fields<Sink>& key, const Scattering& scattering) {
  key.add(std::uint64_t{scattering.index()});
  std::visit(Overloaded{[&](const Diffuse& d) {
                          key.add(std::uint64_t{d.albedo}).add(d.highlight.strength);
                          // Without strength the lobe is the same whatever its shape.
                          if (is_black(d.highlight.strength)) return;
                          key.add(static_cast<std::uint64_t>(d.highlight.model));
                          key.add(d.highlight.exponent);
                        },
                        [&](const Mirror& m) { key.add(std::uint64_t{m.reflectance}); },
                        [&](const Metal& m) { key.add(m.n).add(m.k); },
                        [&](const Glass& g) {
                          key.add(g.ior).add(g.absorption);
                          key.add(static_cast<std::uint64_t>(g.priority));
                        },
                        [&](const Coat& c) {
                          key.add(c.ior).add(c.absorption).add(std::uint64_t{c.base_albedo});
                        },
                        [](const Black&) {}, [&](const PovFinish& m) { add_finish(key, m); }},
             scattering);
}

template <class Sink>
void add_record(Fields<Sink> key, const Texture& texture) {
  add_pattern(key, texture.pattern);
  // One colour everywhere looks the same however it is mapped.
  if (!std::holds_alternative<SolidPattern>(texture.pattern)) {
    key.add(static_cast<std::uint64_t>(texture.mapping)).add(texture.pattern_from_mapped);
  }
}

template <class Sink>
void add_record(Fields<Sink> key, const Material& material) {
  add_scattering(key, material.scattering);
  key.add(material.emission);
  key.add(std::uint64_t{material.one_sided_emission});
}

template <class Sink>
void add_record(Fields<Sink> key, const ImageFile& image) {
  key.add(image.path).add(image.color_space);
}

template <class Record>
bool has_key(const Record& record, const Key& key) {
  Comparison comparison{key};
  add_record(Fields(comparison), record);
  return comparison.holds();
}

}  // namespace

template <class Record>
std::uint32_t Store::Interned<Record>::add(Record&& record) {
  Key key;
  add_record(Fields(key), record);
  const std::uint64_t hash = key.hash();
  std::uint32_t& recent = recent_[hash % recent_.size()];
  if (recent < records_.size() && has_key(records_[recent], key)) return recent;
  const auto [first, last] = ids_.equal_range(hash);
  for (auto it = first; it != last; ++it) {
    if (has_key(records_[it->second], key)) return recent = it->second;
  }
  const auto id = static_cast<std::uint32_t>(records_.size());
  ids_.emplace(hash, id);
  records_.push_back(std::move(record));
  return recent = id;
}

TextureId Store::add(Texture&& texture) {
  const TextureId id = textures_.add(std::move(texture));
  if (id == largest_.size()) largest_.push_back(bound(textures_[id].pattern));
  return id;
}

MaterialId Store::add(Material&& material) {
  return materials_.add(std::move(material));
}

ImageId Store::add(ImageFile&& image) {
  return images_.add(std::move(image));
}

void Store::name_material(MaterialId id, std::string_view name) {
  if (materials_[id].name.empty()) materials_[id].name = name;
}

Rgbd Store::bound(const Pattern& pattern) const {
  const auto larger_of = [](Rgbd a, Rgbd b) {
    return Rgbd{larger(a.r, b.r), larger(a.g, b.g), larger(a.b, b.b)};
  };
  return std::visit(
      Overloaded{
          [](const SolidPattern& p) { return p.color; },
          [&](const CheckerPattern& p) { return larger_of(largest_[p.even], largest_[p.odd]); },
          [&](const StripesPattern& p) { return larger_of(largest_[p.even], largest_[p.odd]); },
          [&](const BrickPattern& p) { return larger_of(largest_[p.brick], largest_[p.mortar]); },
          [&](const GradientPattern& p) {
            Rgbd most = p.stops.front().color;
            for (const GradientStop& stop : p.stops)
              most = larger_of(most, stop.color);
            return most;
          },
          [](const ImagePattern&) { return Rgbd(1.0); }},
      pattern);
}

}  // namespace alhazen::parser

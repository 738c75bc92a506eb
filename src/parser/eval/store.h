// parser/eval: textures, materials and images that have been made, each kept once: equal in all but
// name and span means the same id.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/scene/material.h"
#include "core/scene/shape.h"
#include "core/scene/texture.h"

namespace alhazen::parser {

class Store {
 public:
  TextureId add(Texture&& texture);
  MaterialId add(Material&& material);
  ImageId add(ImageFile&& image);

  const Texture& texture(TextureId id) const { return textures_[id]; }
  const Material& material(MaterialId id) const { return materials_[id]; }
  const ImageFile& image(ImageId id) const { return images_[id]; }
  // A bound of the texture's colours, channel by channel. An image counts as 1: what it reflects is
  // limited when it is read.
  Rgbd largest(TextureId id) const { return largest_[id]; }

  // The first name that an author gives a material stays.
  void name_material(MaterialId id, std::string_view name);

 private:
  Rgbd bound(const Pattern& pattern) const;

  // Records, found by the hash of their fields.
  template <class Record>
  class Interned {
   public:
    std::uint32_t add(Record&& record);
    const Record& operator[](std::uint32_t id) const { return records_[id]; }
    Record& operator[](std::uint32_t id) { return records_[id]; }

   private:
    std::vector<Record> records_;
    std::unordered_multimap<std::uint64_t, std::uint32_t> ids_;
    // Where the few that a loop makes over and over are found without a search.
    std::array<std::uint32_t, 256> recent_{};
  };

  Interned<Texture> textures_;
  std::vector<Rgbd> largest_;
  Interned<Material> materials_;
  Interned<ImageFile> images_;
};

}  // namespace alhazen::parser

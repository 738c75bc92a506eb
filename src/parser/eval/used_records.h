// parser/eval: copies into the scene the records of the store that are used, once each.
#pragma once

#include <unordered_map>

#include "core/scene/scene.h"
#include "parser/eval/store.h"

namespace alhazen::parser {

class UsedRecords {
 public:
  UsedRecords(const Store& store, Scene& scene) : store_(store), scene_(scene) {}

  // The id in the scene of a record of the store; what it refers to comes before it.
  MaterialId material(MaterialId in_store);
  TextureId texture(TextureId in_store);
  ImageId image(ImageId in_store);

 private:
  const Store& store_;
  Scene& scene_;
  std::unordered_map<MaterialId, MaterialId> materials_;
  std::unordered_map<TextureId, TextureId> textures_;
  std::unordered_map<ImageId, ImageId> images_;
};

}  // namespace alhazen::parser

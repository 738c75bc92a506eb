// parser/eval: what is used moves into the scene under new ids.
#include "parser/eval/used_records.h"

#include "core/base/overloaded.h"

namespace alhazen::parser {

MaterialId UsedRecords::material(MaterialId in_store) {
  const auto known = materials_.find(in_store);
  if (known != materials_.end()) return known->second;
  Material copy = store_.material(in_store);
  std::visit(Overloaded{[&](Diffuse& d) { d.albedo = texture(d.albedo); },
                        [&](Mirror& m) { m.reflectance = texture(m.reflectance); },
                        [&](Coat& c) { c.base_albedo = texture(c.base_albedo); },
                        [&](PovFinish& m) { m.color = texture(m.color); }, [](auto&) {}},
             copy.scattering);
  const auto id = static_cast<MaterialId>(scene_.materials.size());
  scene_.materials.push_back(std::move(copy));
  materials_.emplace(in_store, id);
  return id;
}

// As deep as textures nest, which the nesting of evaluations bounds.
TextureId UsedRecords::texture(TextureId in_store) {
  const auto known = textures_.find(in_store);
  if (known != textures_.end()) return known->second;
  Texture copy = store_.texture(in_store);
  std::visit(Overloaded{[&](CheckerPattern& p) {
                          p.even = texture(p.even);
                          p.odd = texture(p.odd);
                        },
                        [&](StripesPattern& p) {
                          p.even = texture(p.even);
                          p.odd = texture(p.odd);
                        },
                        [&](BrickPattern& p) {
                          p.brick = texture(p.brick);
                          p.mortar = texture(p.mortar);
                        },
                        [&](ImagePattern& p) { p.image = image(p.image); }, [](auto&) {}},
             copy.pattern);
  const auto id = static_cast<TextureId>(scene_.textures.size());
  scene_.textures.push_back(std::move(copy));
  textures_.emplace(in_store, id);
  return id;
}

ImageId UsedRecords::image(ImageId in_store) {
  const auto known = images_.find(in_store);
  if (known != images_.end()) return known->second;
  const auto id = static_cast<ImageId>(scene_.images.size());
  scene_.images.push_back(store_.image(in_store));
  images_.emplace(in_store, id);
  return id;
}

}  // namespace alhazen::parser

// parser/eval: checked properties to records of the scene, one file for each kind of record. Each
// function reports what the schema's tables cannot say, gives nothing then, and gives only finite
// numbers otherwise.
#pragma once

#include <optional>

#include "core/scene/scene.h"
#include "parser/eval/object.h"
#include "parser/eval/properties.h"

namespace alhazen::parser {

// All of `translate`, `rotate`, `scale` and `matrix`, applied in the order written.
std::optional<Affined> lower_transform(Context& context, const Properties& properties);

std::optional<Geometry> lower_shape(Context& context, const Properties& properties);

// `base` is the material that is varied: what is not written stays as it is there.
std::optional<MaterialId> lower_material(Context& context, const Properties& properties,
                                         const Material* base);
// The kind of block that a material was made by: what its variations may hold.
const BlockSchema& schema_of(const Material& material);
Highlight lower_highlight(const Properties& properties);
std::optional<PovFinish> lower_pov_finish(Context& context, const Properties& properties,
                                          TextureId color, const PovFinish* base);

// The texture with the mapping and the transforms of a body.
std::optional<TextureId> lower_texture(Context& context, const Properties& properties,
                                       TextureId base);
const BlockSchema& schema_of(const Texture& texture);

std::optional<PlacedLight> lower_light(Context& context, const Properties& properties);
// The light seen from the parent's frame; reports at `span` where a sphere would stop being one.
std::optional<LightSource> transformed(Context& context, const LightSource& source,
                                       const Affined& parent_from_child, SourceSpan span);

std::optional<Camera> lower_camera(Context& context, const Properties& properties);
std::optional<Background> lower_background(Context& context, const Property& property);
std::optional<RenderSettings> lower_render(Context& context, const Properties& properties);

}  // namespace alhazen::parser

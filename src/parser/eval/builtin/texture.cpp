// parser/eval: functions that make textures. Their bodies, `checker(a, b) { scale 0.5 }`, are in
// schema/texture.cpp.
#include "parser/eval/builtin/builtin.h"
#include "parser/eval/files.h"
#include "parser/eval/schema/types.h"
#include "parser/eval/texture_value.h"

namespace alhazen::parser {
namespace {

constexpr BuiltinParameter kTwo[] = {{"first", kColor | kTexture}, {"second", kColor | kTexture}};
constexpr BuiltinParameter kBrick[] = {{"brick", kColor | kTexture}, {"mortar", kColor | kTexture}};
constexpr BuiltinParameter kStops[] = {{"stops", kList}};
constexpr BuiltinParameter kFile[] = {{"file", kString}};

Value make(const BuiltinCall& call, Pattern pattern, Mapping mapping = Mapping::object) {
  return TextureRef{call.context.add(Texture{std::move(pattern), mapping, {}, call.span})};
}
TextureId argument(const BuiltinCall& call, std::size_t i) {
  return texture_of(call.context, call.values[i], call.spans[i]);
}

Value checker_of(const BuiltinCall& call) {
  return make(call, CheckerPattern{argument(call, 0), argument(call, 1)});
}
Value stripes_of(const BuiltinCall& call) {
  return make(call, StripesPattern{argument(call, 0), argument(call, 1)});
}
Value brick_of(const BuiltinCall& call) {
  return make(call, BrickPattern{argument(call, 0), argument(call, 1)});
}
Value gradient_of(const BuiltinCall& call) {
  auto stops = gradient_stops(call.context, call.values[0], call.spans[0], 0, 1);
  if (!stops) return Poison{};
  return make(call, GradientPattern{std::move(*stops)});
}
Value image_of(const BuiltinCall& call) {
  const auto path = resolve_file(call.context, call.spans[0], call.values[0].text());
  if (!path) return Poison{};
  const ImageId id = call.context.store().add(ImageFile{path->string(), "", call.spans[0]});
  return make(call, ImagePattern{id}, Mapping::uv);
}

constexpr BuiltinFunction kFunctions[] = {
    {"brick", kBrick, false, "texture",
     "a wall of bricks; the body may hold `size`, `mortar_width`", brick_of},
    {"checker", kTwo, false, "texture", "unit cubes in turn", checker_of},
    {"gradient", kStops, false, "texture",
     "along x, from a list of colours (evenly from 0 to 1) or of pairs [position, colour]",
     gradient_of},
    {"image", kFile, false, "texture",
     "a picture file (PNG, JPEG, EXR); the body may hold `color_space`, `wrap`, `filter`",
     image_of},
    {"stripes", kTwo, false, "texture", "slabs of unit width across x, in turn", stripes_of},
};

}  // namespace

std::span<const BuiltinFunction> texture_functions() {
  return kFunctions;
}

}  // namespace alhazen::parser

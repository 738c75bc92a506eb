// parser/eval: colours state their space. rgb() is the scene-linear working space; all others are
// converted to it.
#include "parser/eval/builtin/builtin.h"
#include "parser/eval/color_convert.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {
namespace {

constexpr BuiltinParameter kChannels[] = {
    {"red", kNumber}, {"green", kNumber, true}, {"blue", kNumber, true}};
constexpr BuiltinParameter kHsv[] = {
    {"hue", kNumber | kAngle}, {"saturation", kNumber}, {"value", kNumber}};
constexpr BuiltinParameter kGray[] = {{"value", kNumber}};
constexpr BuiltinParameter kKelvin[] = {{"temperature", kNumber}};
constexpr BuiltinParameter kColorParameter[] = {{"color", kColor}};

// One number for all three channels, or three.
std::optional<Rgbd> channels(const BuiltinCall& call) {
  if (call.has(1) != call.has(2)) {
    call.context.report<DiagnosticKind::wrong_argument_count>(call.span, call.function,
                                                              "one number or three", 2);
    return std::nullopt;
  }
  if (!call.has(1)) return Rgbd(call.number(0));
  return Rgbd{call.number(0), call.number(1), call.number(2)};
}

Value rgb_of(const BuiltinCall& call) {
  const auto color = channels(call);
  return color ? Value(*color) : Value(Poison{});
}

Value srgb_of(const BuiltinCall& call) {
  const auto c = channels(call);
  if (!c) return Poison{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (call.has(i) && !(call.number(i) >= 0 && call.number(i) <= 1)) {
      return call.outside_domain(i, "numbers from 0 to 1 (`srgb(...) * 5` is brighter)");
    }
  }
  return call.context.from_srgb(*c);
}

Value hsv_of(const BuiltinCall& call) {
  const double hue = call.values[0].is(Type::angle) ? call.deg(0) / 360 : call.number(0);
  for (const std::size_t i : {1U, 2U}) {
    if (!(call.number(i) >= 0 && call.number(i) <= 1)) {
      return call.outside_domain(i, "a number from 0 to 1");
    }
  }
  return call.context.from_srgb(hsv_to_rgb(hue, call.number(1), call.number(2)));
}

Value gray_of(const BuiltinCall& call) {
  return Rgbd(call.number(0));
}

Value kelvin_of(const BuiltinCall& call) {
  if (!(call.number(0) >= kMinKelvin && call.number(0) <= kMaxKelvin)) {
    return call.outside_domain(0, "a temperature from 1667 to 25000 (kelvin)");
  }
  const Rgbd c = working_from_rec709(call.context.options().working_from_rec709,
                                     black_body_rec709(call.number(0)));
  return Rgbd{larger(0.0, c.r), larger(0.0, c.g), larger(0.0, c.b)};
}

Value brightness(const BuiltinCall& call) {
  return largest_channel(call.color(0));
}

constexpr BuiltinFunction kFunctions[] = {
    {"gray", kGray, false, "colour", "the same as rgb(value)", gray_of},
    {"hsv", kHsv, false, "colour",
     "hue in turns or as an angle, saturation and value from 0 to 1, as in colour pickers: of "
     "encoded sRGB",
     hsv_of},
    {"kelvin", kKelvin, false, "colour",
     "the colour of a black body of luminance 1, from 1667 K to 25000 K; a channel that the "
     "working "
     "space cannot hold is 0",
     kelvin_of},
    {"largest_channel", kColorParameter, false, "number", "the largest of the three channels",
     brightness},
    {"rgb", kChannels, false, "colour",
     "a colour of the scene-linear working space: three channels, or one number for all", rgb_of},
    {"srgb", kChannels, false, "colour",
     "a colour as pickers and the web give it, from 0 to 1; `#rrggbb` is the same in hexadecimal",
     srgb_of},
};

}  // namespace

std::span<const BuiltinFunction> color_functions() {
  return kFunctions;
}

}  // namespace alhazen::parser

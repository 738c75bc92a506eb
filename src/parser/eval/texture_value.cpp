// parser/eval: colours as textures, lists as gradients.
#include "parser/eval/texture_value.h"

namespace alhazen::parser {
namespace {

struct Stop {
  std::optional<double> position;
  Rgbd color;
};

std::optional<Stop> stop_of(const Value& value) {
  if (value.is(Type::color)) return Stop{std::nullopt, value.as<Rgbd>()};
  if (!value.is(Type::list)) return std::nullopt;
  const auto& pair = value.elements();
  if (pair.size() != 2 || !pair[0].is(Type::number) || !pair[1].is(Type::color)) {
    return std::nullopt;
  }
  return Stop{pair[0].number(), pair[1].as<Rgbd>()};
}

}  // namespace

TextureId texture_of(Context& context, const Value& value, SourceSpan span) {
  if (value.is(Type::texture)) return value.as<TextureRef>().id;
  return context.add(Texture{SolidPattern{value.as<Rgbd>()}, Mapping::object, {}, span});
}

std::optional<std::vector<GradientStop>> gradient_stops(Context& context, const Value& list,
                                                        SourceSpan span, double first,
                                                        double last) {
  const auto fail = [&](std::string_view what) {
    context.report<DiagnosticKind::bad_gradient>(span, what)
        .hint("write colours, `[rgb(0), rgb(1)]`, or pairs in order, `[[0, rgb(0)], [1, rgb(1)]]`");
    return std::nullopt;
  };
  const auto& elements = list.elements();
  if (!context.spend_fuel(elements.size(), span)) return std::nullopt;
  if (elements.empty()) return fail("is empty");
  std::vector<GradientStop> stops;
  bool any_pair = false, any_color = false;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto stop = stop_of(elements[i]);
    if (!stop) return fail("holds something that is neither a colour nor a pair of both");
    (stop->position ? any_pair : any_color) = true;
    if (any_pair && any_color) return fail("mixes colours and pairs");
    const Rgbd c = stop->color;
    if (c.r < 0 || c.g < 0 || c.b < 0) return fail("holds a colour below 0");
    const double w = elements.size() == 1
                         ? 0
                         : static_cast<double>(i) / static_cast<double>(elements.size() - 1);
    stops.push_back({stop->position.value_or((1 - w) * first + w * last), c});
    if (i > 0 && stops[i].position < stops[i - 1].position) {
      return fail("has a position that is less than the one before it");
    }
  }
  return stops;
}

}  // namespace alhazen::parser

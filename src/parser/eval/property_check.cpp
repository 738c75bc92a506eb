// parser/eval: types and ranges of properties, with what to write instead.
#include "parser/eval/property_check.h"

#include <algorithm>
#include <fmt/format.h>

#include "core/base/near_name.h"
#include "parser/eval/builtin/componentwise.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {
namespace {

constexpr TypeSet kMeasured = kNumber | kAngle | kVec2 | kVec3 | kAngles | kColor;

// Names stand in the header of the picture and in the channels that tell objects apart.
constexpr std::size_t kLongestName = 256;

bool in_range(const NumberRange& range, const Value& value) {
  if ((set_of(value.type()) & kMeasured) == 0) return true;
  bool inside = true, all_zero = true;
  for_each_component(value, [&](double c) {
    inside = inside && range.contains(c) && (!range.integer || c == round_down(c));
    all_zero = all_zero && c == 0;
  });
  return inside && !(range.nonzero && all_zero);
}

// These give false.
bool report_type(Context& context, const PropertySpec& spec, const Value& value, SourceSpan span) {
  Diagnostic& d = context.report<DiagnosticKind::property_type>(
      span, spec.name, describe(spec.types), a_type_name(value.type()));
  const std::string hint = conversion_hint(spec.types, value);
  if (!hint.empty()) d.hint(hint);
  return false;
}

bool report_range(Context& context, const PropertySpec& spec, const std::string& found,
                  SourceSpan span) {
  Diagnostic& d =
      context.report<DiagnosticKind::out_of_range>(span, spec.name, describe(spec.range), found);
  if ((spec.types & kTexture) != 0 && spec.range.contains(1) && !spec.range.contains(2)) {
    d.hint("a surface cannot reflect more light than it receives; channels are from 0 to 1");
  }
  return false;
}

bool check_word(Context& context, const PropertySpec& spec, const std::string& word,
                SourceSpan span) {
  if (std::find(spec.words.begin(), spec.words.end(), word) != spec.words.end()) return true;
  Diagnostic& d = context.report<DiagnosticKind::unknown_word>(span, spec.name, word);
  const std::vector<std::string_view> words(spec.words.begin(), spec.words.end());
  if (const auto meant = near_name(word, words)) d.hint(fmt::format("did you mean `{}`?", *meant));
  d.hint(fmt::format("it is one of `{}`", fmt::join(words, "`, `")));
  return false;
}

}  // namespace

std::string conversion_hint(TypeSet wanted, const Value& given) {
  if ((wanted & kColor) != 0 && given.is(Type::number)) {
    return fmt::format("write `rgb({})`", to_text(given, 40));
  }
  if ((wanted & kColor) != 0 && given.is(Type::vec3)) {
    const auto v = given.as<Vec3d>();
    return fmt::format("colours state their space: `rgb({}, {}, {})`", number_text(v.x),
                       number_text(v.y), number_text(v.z));
  }
  if ((wanted & kAngle) != 0 && given.is(Type::number)) {
    return fmt::format("write `{}deg`", to_text(given, 40));
  }
  if ((wanted & kAngles) != 0 && given.is(Type::vec3)) {
    return "angles carry a unit: `<0, 30deg, 0>`";
  }
  if ((wanted & kAngles) != 0 && given.is(Type::angle)) {
    return fmt::format("say about which axis: `y*{}`", to_text(given, 40));
  }
  if ((wanted & kNumber) != 0 && given.is(Type::angle)) {
    return fmt::format("write `{}`, without a unit", number_text(given.as<Angle>().deg));
  }
  if ((wanted & kMaterial) != 0 && (given.is(Type::color) || given.is(Type::texture))) {
    return "write `diffuse { color ... }`";
  }
  if ((wanted & kVec3) != 0 && given.is(Type::vec2)) return "it needs three components";
  if ((wanted & kString) != 0 && given.is(Type::number)) return "write it in quotes";
  return "";
}

bool check_property(Context& context, const PropertySpec& spec, const Value& value,
                    SourceSpan span) {
  if ((spec.types & set_of(value.type())) == 0) return report_type(context, spec, value, span);
  if (value.is(Type::string) && spec.name == "name" && value.text().size() > kLongestName) {
    context.report<DiagnosticKind::name_too_long>(span, kLongestName, value.text().size());
    return false;
  }
  if (!spec.words.empty()) return check_word(context, spec, value.text(), span);
  if (spec.range == NumberRange()) return true;
  if (!value.is(Type::texture)) {
    return in_range(spec.range, value) || report_range(context, spec, to_text(value, 60), span);
  }
  // The bound of a texture's colours is what it may reflect.
  const Value bound = context.store().largest(value.as<TextureRef>().id);
  return in_range(spec.range, bound) ||
         report_range(context, spec, "a texture with colours up to " + to_text(bound, 60), span);
}

}  // namespace alhazen::parser

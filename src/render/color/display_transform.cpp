// render/color: from the working space to a display, with the names that the user gave.
#include <algorithm>

#include "render/color/color_config.h"
#include "render/color/color_config_impl.h"

namespace alhazen::render {
namespace {

// Display and view names are plain ASCII in practice; other letters compare as they are.
bool same_name(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

// The entry of `names` that is meant by `name`.
Result<std::string> choose(const char* what, std::string_view name,
                           const std::vector<std::string>& names, const std::string& origin) {
  std::string known;
  for (const std::string& candidate : names) {
    if (same_name(candidate, name)) return candidate;
    known += fmt::format("{}`{}`", known.empty() ? "" : ", ", candidate);
  }
  return Error{ErrorCode::usage,
               fmt::format("no {} `{}` in the colour configuration {}; it has: {}", what, name,
                           origin, known.empty() ? "none" : known)};
}

}  // namespace

Result<ColorTransform> ColorConfig::display_transform(std::string_view display,
                                                      std::string_view view) const {
  const std::vector<DisplayViews> all = displays();
  if (all.empty()) {
    return Error{ErrorCode::io,
                 fmt::format("the colour configuration {} has no display", origin())};
  }
  std::vector<std::string> names;
  for (const DisplayViews& views : all)
    names.push_back(views.display);
  const auto chosen_display =
      choose("display", display.empty() ? names.front() : display, names, origin());
  if (!chosen_display) return chosen_display.error();

  const DisplayViews& views = *std::find_if(
      all.begin(), all.end(),
      [&](const DisplayViews& candidate) { return candidate.display == chosen_display.value(); });
  const auto chosen_view =
      choose("view", view.empty() ? views.default_view : view, views.views, origin());
  if (!chosen_view) return chosen_view.error();

  return guarded(fmt::format("cannot show on display `{}` with view `{}`", chosen_display.value(),
                             chosen_view.value()),
                 [&] {
                   return make_transform(impl_->config->getProcessor(
                       ocio::ROLE_SCENE_LINEAR, chosen_display.value().c_str(),
                       chosen_view.value().c_str(), ocio::TRANSFORM_DIR_FORWARD));
                 });
}

}  // namespace alhazen::render

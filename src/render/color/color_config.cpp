#include "render/color/color_config.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <system_error>

#include "render/color/builtin_config.h"
#include "render/color/color_config_impl.h"

namespace alhazen::render {
namespace {

std::string role_names(const ocio::Config& config) {
  std::string names;
  for (int i = 0; i < config.getNumRoles(); ++i) {
    names += fmt::format("{}`{}`", names.empty() ? "" : ", ", config.getRoleName(i));
  }
  return names.empty() ? "none" : names;
}

Result<ocio::ConstConfigRcPtr> open_file(const std::string& file, const std::string& origin) {
  // A folder can be opened but not read, which the YAML reader below OpenColorIO answers with a
  // leak.
  if (std::error_code ignored; std::filesystem::is_directory(file, ignored)) {
    return Error{ErrorCode::io,
                 fmt::format("cannot use the colour configuration {}: it is a folder", origin)};
  }
  // Not CreateFromEnv: with a missing file name it goes on without any colour management.
  auto config = guarded(fmt::format("cannot use the colour configuration {}", origin), [&] {
    ocio::ConstConfigRcPtr opened = ocio::Config::CreateFromFile(file.c_str());
    opened->validate();
    return opened;
  });
  if (config && !config.value()->hasRole(ocio::ROLE_SCENE_LINEAR)) {
    return Error{
        ErrorCode::io,
        fmt::format("the colour configuration {} has no role `{}`, so there is no space to "
                    "render in; its roles: {}",
                    origin, ocio::ROLE_SCENE_LINEAR, role_names(*config.value()))};
  }
  return config;
}

DisplayViews views_of(const ocio::Config& config, const char* display) {
  DisplayViews result{display, {}, config.getDefaultView(display)};
  for (int i = 0; i < config.getNumViews(display); ++i) {
    result.views.emplace_back(config.getView(display, i));
  }
  return result;
}

}  // namespace

ColorSource color_source(std::string explicit_file) {
  const char* environment = std::getenv("OCIO");
  return {std::move(explicit_file), environment == nullptr ? "" : environment};
}

Result<ColorConfig> ColorConfig::open(const ColorSource& source) {
  const auto builtin = guarded("cannot make the built-in colour configuration",
                               [] { return make_builtin_config(); });
  if (!builtin) return builtin.error();
  Impl impl{builtin.value(), builtin.value(), "built-in"};
  const bool is_explicit = !source.explicit_file.empty();
  const std::string& file = is_explicit ? source.explicit_file : source.environment_file;
  if (!file.empty()) {
    impl.origin = fmt::format("{} `{}`", is_explicit ? "--ocio" : "$OCIO", file);
    const auto config = open_file(file, impl.origin);
    if (!config) return config.error();
    impl.config = config.value();
  }
  return ColorConfig(std::make_shared<const Impl>(std::move(impl)));
}

const std::string& ColorConfig::origin() const {
  return impl_->origin;
}

std::string ColorConfig::working_space() const {
  return impl_->config->getCanonicalName(ocio::ROLE_SCENE_LINEAR);
}

std::string ColorConfig::serialize() const {
  std::ostringstream text;
  impl_->config->serialize(text);
  return text.str();
}

std::vector<DisplayViews> ColorConfig::displays() const {
  const ocio::Config& config = *impl_->config;
  std::vector<DisplayViews> result;
  for (int i = 0; i < config.getNumDisplays(); ++i) {
    result.push_back(views_of(config, config.getDisplay(i)));
  }
  const std::string first = config.getDefaultDisplay();
  std::stable_partition(result.begin(), result.end(),
                        [&](const DisplayViews& views) { return views.display == first; });
  return result;
}

}  // namespace alhazen::render

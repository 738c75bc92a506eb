// render/color: which colour space the file of a texture is in.
#include <algorithm>
#include <array>
#include <cctype>

#include "render/color/builtin_config.h"
#include "render/color/color_config.h"
#include "render/color/color_config_impl.h"

namespace alhazen::render {
namespace {

// What configurations call the sRGB of picture files; the built-in one where none is there.
std::string srgb_texture(const ocio::Config& config) {
  for (const char* name : {kSrgbTexture, "srgb_texture", "srgb_tx", "Utility - sRGB - Texture",
                           "sRGB Encoded Rec.709 (sRGB)", "sRGB"}) {
    if (config.getColorSpace(name)) return name;
  }
  return kSrgbTexture;
}

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace

TextureSpace ColorConfig::texture_space(const std::filesystem::path& file,
                                        std::string_view explicit_space, TextureUse use) const {
  const ocio::Config& config = *impl_->config;
  if (!explicit_space.empty()) return {std::string(explicit_space), "named in the scene"};
  if (use == TextureUse::data) {
    return {config.hasRole(ocio::ROLE_DATA) ? ocio::ROLE_DATA : kRaw, "used as data"};
  }
  const std::string path = file.string();
  const auto by_rule = guarded("file rules", [&]() -> std::optional<TextureSpace> {
    if (config.filepathOnlyMatchesDefaultRule(path.c_str())) return std::nullopt;
    std::size_t rule = 0;
    const std::string space = config.getColorSpaceFromFilepath(path.c_str(), rule);
    if (space.empty()) return std::nullopt;
    return TextureSpace{space, fmt::format("file rule `{}`", config.getFileRules()->getName(rule))};
  });
  if (by_rule && by_rule.value()) return *by_rule.value();
  const std::string extension = lower_extension(file);
  if (extension == ".png" || extension == ".jpg" || extension == ".jpeg") {
    return {srgb_texture(config), fmt::format("extension `{}`", extension)};
  }
  return {ocio::ROLE_SCENE_LINEAR, "no rule for the name"};
}

}  // namespace alhazen::render

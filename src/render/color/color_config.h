// render/color: the colour configuration of a run: which space is worked in, and how to get there
// from textures and from there to displays.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/math/chromaticities.h"
#include "render/color/color_transform.h"

namespace alhazen::render {

// Where the configuration comes from; the first that is not empty wins, otherwise the built-in one.
struct ColorSource {
  std::string explicit_file;     // --ocio FILE
  std::string environment_file;  // $OCIO
};
// `explicit_file` and the environment of the process.
ColorSource color_source(std::string explicit_file);

struct DisplayViews {
  std::string display;
  std::vector<std::string> views;
  std::string default_view;
};

// What a texture is used for.
enum class TextureUse {
  color,
  data,  // normals, heights, masks: never converted
};

struct TextureSpace {
  std::string name;
  std::string reason;  // for -v: "named in the scene", "file rule `png`", ...
};

// Immutable and cheap to copy. Names of displays, views and spaces are those of the configuration,
// in any case, aliases included. Unless said otherwise errors have ErrorCode::usage and list what
// there is.
class ColorConfig {
 public:
  // ErrorCode::io when the file cannot be read or is not a valid configuration; a configuration
  // that was asked for and is broken is never silently replaced. It must have the role
  // scene_linear.
  static Result<ColorConfig> open(const ColorSource& source);
  static Result<ColorConfig> builtin() { return open({}); }

  // "--ocio FILE", "$OCIO FILE" or "built-in".
  const std::string& origin() const;
  // The space of the role scene_linear.
  std::string working_space() const;
  // The configuration as text, for other programs.
  std::string serialize() const;

  // Linear Rec.709 (what kelvin(), rgb literals of other programs and #rrggbb speak) to the working
  // space. For a configuration of somebody else this goes through its role aces_interchange;
  // without that, or when the working space is not linear, there is no matrix.
  Result<ColorMatrix> working_from_rec709() const;
  // When the working space is one of the spaces in core/math/chromaticities.h.
  std::optional<Chromaticities> working_chromaticities() const;

  // The default display first.
  std::vector<DisplayViews> displays() const;
  // Scene-linear to display-encoded values, not clamped: an un-tone-mapped 4 stays above 1. An
  // empty name stands for the default.
  Result<ColorTransform> display_transform(std::string_view display = {},
                                           std::string_view view = {}) const;

  // To the working space from a space, alias or role of the configuration; or else from one of the
  // built-in configuration ("Linear Rec.709 (sRGB)", "sRGB - Texture", ...) through
  // aces_interchange.
  Result<ColorTransform> to_working(std::string_view space) const;

  // Which space the file of a texture is in: `explicit_space` when not empty; data for data; what a
  // file rule says (the default rule is no answer); PNG and JPEG by extension sRGB, otherwise
  // linear.
  TextureSpace texture_space(const std::filesystem::path& file, std::string_view explicit_space,
                             TextureUse use) const;

 private:
  struct Impl;
  explicit ColorConfig(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

  std::shared_ptr<const Impl> impl_;
};

}  // namespace alhazen::render

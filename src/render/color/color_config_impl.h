// render/color: what a ColorConfig holds; OpenColorIO's types stay inside this folder.
#pragma once

#include <string>

#include "render/color/color_config.h"
#include "render/color/ocio.h"

namespace alhazen::render {

struct ColorConfig::Impl {
  ocio::ConstConfigRcPtr config;
  ocio::ConstConfigRcPtr builtin;  // the same object when the built-in configuration is used
  std::string origin;

  bool is_builtin() const { return config == builtin; }
};

}  // namespace alhazen::render

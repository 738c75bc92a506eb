// render/color: the way into the working space, from textures and from other linear spaces.
#include <cmath>

#include "render/color/builtin_config.h"
#include "render/color/color_config.h"
#include "render/color/color_config_impl.h"
#include "render/color/rgb_matrix.h"

namespace alhazen::render {
namespace {

std::string space_names(const ocio::Config& config) {
  std::string names;
  for (int i = 0; i < config.getNumColorSpaces(); ++i) {
    names += fmt::format("{}`{}`", names.empty() ? "" : ", ", config.getColorSpaceNameByIndex(i));
  }
  return names;
}

// From `space` of the built-in configuration to the working space of another. Throws.
ocio::ConstProcessorRcPtr to_foreign_working(const ocio::ConstConfigRcPtr& builtin,
                                             const char* space,
                                             const ocio::ConstConfigRcPtr& config) {
  return ocio::Config::GetProcessorFromConfigs(builtin, space, config, ocio::ROLE_SCENE_LINEAR);
}

Error no_interchange(const std::string& origin, const std::string& space) {
  return {ErrorCode::usage,
          fmt::format("the colour configuration {} has no role `{}`, so there is no way to its "
                      "working space from `{}`",
                      origin, ocio::ROLE_INTERCHANGE_SCENE, space)};
}

// The matrix that `processor` is, in double and not sampled through its float arithmetic. Throws.
std::optional<ColorMatrix> pure_matrix(const ocio::ConstProcessorRcPtr& processor) {
  const ocio::GroupTransformRcPtr group =
      processor->getOptimizedProcessor(kOptimization)->createGroupTransform();
  ColorMatrix result;
  if (group->getNumTransforms() == 0) return result;
  const auto matrix =
      std::dynamic_pointer_cast<const ocio::MatrixTransform>(group->getTransform(0));
  if (group->getNumTransforms() > 1 || !matrix) return std::nullopt;
  double m44[16];
  double offset[4];
  matrix->getMatrix(m44);
  matrix->getOffset(offset);
  if (offset[0] != 0 || offset[1] != 0 || offset[2] != 0) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      result.rows[i][j] = m44[4 * i + j];
  }
  if (matrix->getDirection() == ocio::TRANSFORM_DIR_INVERSE) return std::nullopt;
  return result;
}

// Whether two matrices stand for the same pair of spaces. Configurations publish matrices rounded
// to between five and ten digits; different spaces differ in the second.
bool nearly_equal(const ColorMatrix& a, const ColorMatrix& b) {
  constexpr double kPublishedDigits = 1e-4;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (!(std::fabs(a.rows[i][j] - b.rows[i][j]) <= kPublishedDigits)) return false;
    }
  }
  return true;
}

}  // namespace

Result<ColorTransform> ColorConfig::to_working(std::string_view space) const {
  const std::string name(space);
  const std::string what = fmt::format("cannot convert from colour space `{}`", name);
  if (impl_->config->getColorSpace(name.c_str())) {
    return guarded(what, [&] {
      return make_transform(impl_->config->getProcessor(name.c_str(), ocio::ROLE_SCENE_LINEAR));
    });
  }
  const ocio::ConstColorSpaceRcPtr ours = impl_->builtin->getColorSpace(name.c_str());
  if (!ours) {
    return Error{ErrorCode::usage,
                 fmt::format("no colour space `{}` in the colour configuration {}; it has: {}",
                             name, origin(), space_names(*impl_->config))};
  }
  if (ours->isData()) {
    return guarded(what, [&] {
      return make_transform(impl_->builtin->getProcessor(name.c_str(), name.c_str()));
    });
  }
  if (!impl_->config->hasRole(ocio::ROLE_INTERCHANGE_SCENE)) return no_interchange(origin(), name);
  return guarded(what, [&] {
    return make_transform(to_foreign_working(impl_->builtin, name.c_str(), impl_->config));
  });
}

Result<ColorMatrix> ColorConfig::working_from_rec709() const {
  if (!impl_->config->hasRole(ocio::ROLE_INTERCHANGE_SCENE)) {
    return no_interchange(origin(), kLinearRec709);
  }
  auto matrix =
      guarded("cannot convert linear Rec.709 colours", [&]() -> std::optional<ColorMatrix> {
        return pure_matrix(impl_->is_builtin()
                               ? impl_->config->getProcessor(kLinearRec709, ocio::ROLE_SCENE_LINEAR)
                               : to_foreign_working(impl_->builtin, kLinearRec709, impl_->config));
      });
  if (!matrix) return matrix.error();
  if (!matrix.value()) {
    return Error{ErrorCode::usage,
                 fmt::format("the working space `{}` of the colour configuration {} is not linear",
                             working_space(), origin())};
  }
  return *matrix.value();
}

std::optional<Chromaticities> ColorConfig::working_chromaticities() const {
  const Result<ColorMatrix> matrix = working_from_rec709();
  if (!matrix) return std::nullopt;
  for (const Chromaticities& space : {kAcesAp1, kRec709, kRec2020, kP3D65, kAcesAp0}) {
    if (nearly_equal(matrix.value(), rgb_from_rgb(space, kRec709))) return space;
  }
  return std::nullopt;
}

}  // namespace alhazen::render

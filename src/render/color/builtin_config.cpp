#include "render/color/builtin_config.h"

#include <initializer_list>

namespace alhazen::render {
namespace {

constexpr const char* kAces = "ACES2065-1";
constexpr const char* kSrgbDisplay = "sRGB - Display";
constexpr const char* kXyzD65 = "CIE-XYZ-D65";
constexpr const char* kUntonemapped = "Un-tone-mapped";
constexpr const char* kAcesSdr = "ACES 1.0 SDR";

ocio::BuiltinTransformRcPtr builtin(
    const char* style, ocio::TransformDirection direction = ocio::TRANSFORM_DIR_FORWARD) {
  ocio::BuiltinTransformRcPtr transform = ocio::BuiltinTransform::Create();
  transform->setStyle(style);
  transform->setDirection(direction);
  return transform;
}

// ACES2065-1 to linear Rec.709, by way of AP1.
ocio::GroupTransformRcPtr rec709_from_aces() {
  ocio::GroupTransformRcPtr group = ocio::GroupTransform::Create();
  group->appendTransform(builtin("ACEScg_to_ACES2065-1", ocio::TRANSFORM_DIR_INVERSE));
  group->appendTransform(builtin("UTILITY - ACES-AP1_to_LINEAR-REC709_BFD"));
  return group;
}

// IEC 61966-2-1, written as OpenColorIO writes it: exponent 2.4, offset 0.055, and the straight
// piece that meets the curve with the same slope.
ocio::ExponentWithLinearTransformRcPtr srgb_encoding() {
  ocio::ExponentWithLinearTransformRcPtr curve = ocio::ExponentWithLinearTransform::Create();
  curve->setGamma({2.4, 2.4, 2.4, 1.0});
  curve->setOffset({0.055, 0.055, 0.055, 0.0});
  curve->setDirection(ocio::TRANSFORM_DIR_INVERSE);
  return curve;
}

ocio::ColorSpaceRcPtr space(const char* name, const char* encoding,
                            std::initializer_list<const char*> aliases, const char* description,
                            ocio::ReferenceSpaceType reference = ocio::REFERENCE_SPACE_SCENE) {
  ocio::ColorSpaceRcPtr result = ocio::ColorSpace::Create(reference);
  result->setName(name);
  result->setEncoding(encoding);
  result->setDescription(description);
  for (const char* alias : aliases)
    result->addAlias(alias);
  return result;
}

void add_scene_spaces(ocio::Config& config) {
  config.addColorSpace(space(kAces, "scene-linear", {"aces2065_1", "lin_ap0"},
                             "SMPTE ST 2065-1: linear, AP0 primaries, ACES white"));

  ocio::ColorSpaceRcPtr acescg = space(kAcesCg, "scene-linear", {"lin_ap1"},
                                       "linear, AP1 primaries, ACES white; the working space");
  acescg->setTransform(builtin("ACEScg_to_ACES2065-1"), ocio::COLORSPACE_DIR_TO_REFERENCE);
  config.addColorSpace(acescg);

  ocio::ColorSpaceRcPtr rec709 =
      space(kLinearRec709, "scene-linear", {"lin_rec709", "lin_srgb", "lin_rec709_scene"},
            "linear, primaries and white of Rec.709 and sRGB");
  rec709->setTransform(rec709_from_aces(), ocio::COLORSPACE_DIR_FROM_REFERENCE);
  config.addColorSpace(rec709);

  ocio::GroupTransformRcPtr encoded = rec709_from_aces();
  encoded->appendTransform(srgb_encoding());
  ocio::ColorSpaceRcPtr texture =
      space(kSrgbTexture, "sdr-video", {"srgb_texture", "srgb_tx", "sRGB"},
            "IEC 61966-2-1 colours of a picture file, taken as scene-referred");
  texture->setTransform(encoded, ocio::COLORSPACE_DIR_FROM_REFERENCE);
  config.addColorSpace(texture);

  ocio::ColorSpaceRcPtr raw =
      space(kRaw, "data", {"Utility - Raw"}, "numbers that are not colours; never converted");
  raw->setIsData(true);
  config.addColorSpace(raw);
}

void add_display_spaces(ocio::Config& config) {
  config.addColorSpace(space(kXyzD65, "display-linear", {"cie_xyz_d65"},
                             "CIE XYZ of the display, its white at D65",
                             ocio::REFERENCE_SPACE_DISPLAY));
  ocio::ColorSpaceRcPtr srgb = space(kSrgbDisplay, "sdr-video", {"srgb_display"},
                                     "IEC 61966-2-1 display", ocio::REFERENCE_SPACE_DISPLAY);
  srgb->setTransform(builtin("DISPLAY - CIE-XYZ-D65_to_sRGB"), ocio::COLORSPACE_DIR_FROM_REFERENCE);
  config.addColorSpace(srgb);
}

void add_view(ocio::Config& config, const char* name, const char* style, const char* description) {
  ocio::ViewTransformRcPtr view = ocio::ViewTransform::Create(ocio::REFERENCE_SPACE_SCENE);
  view->setName(name);
  view->setDescription(description);
  view->setTransform(builtin(style), ocio::VIEWTRANSFORM_DIR_FROM_REFERENCE);
  config.addViewTransform(view);
  config.addDisplayView("sRGB", name, name, kSrgbDisplay, "", "", description);
}

void add_views(ocio::Config& config) {
  // The first view is the default: a renderer's pictures are first of all looked at as they are.
  add_view(config, kUntonemapped, "UTILITY - ACES-AP0_to_CIE-XYZ-D65_BFD",
           "scene-linear 1 is display white; brighter is clipped");
  add_view(config, kAcesSdr, "ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - SDR-VIDEO_1.0",
           "the film-like curve of ACES 1.0 for a display of 100 nits");
  config.addDisplayView("sRGB", "Raw", kRaw, "");
  config.setDefaultViewTransformName(kUntonemapped);
}

void add_roles(ocio::Config& config) {
  config.setRole(ocio::ROLE_SCENE_LINEAR, kAcesCg);
  config.setRole(ocio::ROLE_RENDERING, kAcesCg);
  config.setRole(ocio::ROLE_DEFAULT, kAcesCg);
  config.setRole(ocio::ROLE_DATA, kRaw);
  config.setRole(ocio::ROLE_COLOR_PICKING, kSrgbTexture);
  config.setRole(ocio::ROLE_TEXTURE_PAINT, kSrgbTexture);
  config.setRole(ocio::ROLE_MATTE_PAINT, kSrgbTexture);
  config.setRole(ocio::ROLE_INTERCHANGE_SCENE, kAces);
  config.setRole(ocio::ROLE_INTERCHANGE_DISPLAY, kXyzD65);
}

// Patterns are case-sensitive, file names in the wild are not.
void add_file_rules(ocio::Config& config) {
  ocio::FileRulesRcPtr rules = ocio::FileRules::Create();
  rules->insertRule(0, "linear pictures", kAcesCg, "*", "[eE][xX][rR]");
  rules->insertRule(1, "png", kSrgbTexture, "*", "[pP][nN][gG]");
  rules->insertRule(2, "jpg", kSrgbTexture, "*", "[jJ][pP][gG]");
  rules->insertRule(3, "jpeg", kSrgbTexture, "*", "[jJ][pP][eE][gG]");
  rules->setDefaultRuleColorSpace(kAcesCg);
  config.setFileRules(rules);
}

}  // namespace

ocio::ConstConfigRcPtr make_builtin_config() {
  ocio::ConfigRcPtr config = ocio::Config::Create();
  config->setVersion(2, 1);
  config->setName("alhazen-builtin");
  config->setDescription("ACEScg working space, sRGB display");
  add_scene_spaces(*config);
  add_display_spaces(*config);
  add_roles(*config);
  add_views(*config);
  add_file_rules(*config);
  config->validate();
  return config;
}

}  // namespace alhazen::render

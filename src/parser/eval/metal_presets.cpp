// parser/eval: complex indices of refraction of real metals at wavelengths of 650, 550 and 450 nm,
// as refractiveindex.info tabulates the measurements of the literature; seven of them (all but
// titanium, brass and tungsten) agree with a second published table digit by digit. Three
// wavelengths stand for three channels, which is an approximation whatever the working space.
#include "parser/eval/metal_presets.h"

namespace alhazen::parser {
namespace {

struct Preset {
  std::string_view name;
  Metal metal;
};
constexpr Preset kPresets[] = {
    {"gold", {{0.18299, 0.42108, 1.3734}, {3.4242, 2.3459, 1.7704}}},
    {"silver", {{0.15943, 0.14512, 0.13547}, {3.9291, 3.1900, 2.3808}}},
    {"copper", {{0.27105, 0.67693, 1.3164}, {3.6092, 2.6248, 2.2921}}},
    {"aluminium", {{1.3456, 0.96521, 0.61722}, {7.4746, 6.3995, 5.3031}}},
    {"iron", {{2.9114, 2.9497, 2.5845}, {3.0893, 2.9318, 2.7670}}},
    {"chromium", {{3.1071, 3.1812, 2.3230}, {3.3314, 3.3291, 3.1350}}},
    {"titanium", {{2.7407, 2.5418, 2.2670}, {3.8143, 3.4345, 3.0385}}},
    {"brass", {{0.44400, 0.52700, 1.0940}, {3.6950, 2.7650, 1.8290}}},
    {"platinum", {{2.3757, 2.0847, 1.8453}, {4.2655, 3.7153, 3.1365}}},
    {"tungsten", {{4.3707, 3.3002, 2.9982}, {3.5006, 2.6048, 2.2731}}},
};

}  // namespace

std::optional<Metal> metal_preset(std::string_view name) {
  for (const Preset& preset : kPresets) {
    if (preset.name == name) return preset.metal;
  }
  return std::nullopt;
}

}  // namespace alhazen::parser

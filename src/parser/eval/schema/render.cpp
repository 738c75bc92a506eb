// parser/eval: the block of the settings. core/scene/settings.h says what each is.
#include "core/scene/settings.h"
#include "parser/eval/schema/schema.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {
namespace {

constexpr std::string_view kFilters[] = {"box", "tent", "gaussian", "mitchell"};

constexpr PropertySpec kRender[] = {
    {.name = "size",
     .types = kVec2,
     .range = integers(1, kMaxImageSide),
     .default_value = vec2_default(640, 360),
     .doc = "width and height of the picture in pixels"},
    {.name = "samples",
     .types = kNumber,
     .range = integers(1, kMaxSamples),
     .default_value = number_default(16),
     .doc = "for each pixel; 1 is the pixel's centre. With `adaptive` at most that, and 1024 if it "
            "is not written"},
    {.name = "adaptive",
     .types = kNumber,
     .range = above(0),
     .doc = "stop a pixel when the standard error of its mean is at most this"},
    {.name = "min_samples",
     .types = kNumber,
     .range = integers(2, kMaxSamples),
     .doc = "before `adaptive` may stop a pixel, less than `samples`; 16 if not given"},
    {.name = "max_error",
     .types = kNumber,
     .range = between(kMinError, kMaxError),
     .doc = "take samples, and follow rays, until the RMSE of the picture is at most this, as in "
            "`1/255`; in the place of samples, adaptive, depth and cutoff"},
    {.name = "max_error_share",
     .types = kNumber,
     .range = strictly_between(0, 1),
     .doc = "until this share of the pixels is off by `max_error` at most, instead of the RMSE; "
            "0.99 is 99%"},
    {.name = "depth",
     .types = kNumber,
     .range = integers(0, kMaxDepth),
     .default_value = number_default(16),
     .doc = "reflections and refractions along a path"},
    {.name = "cutoff",
     .types = kNumber,
     .range = between(0, 1),
     .default_value = number_default(1.0 / 512),
     .doc = "rays that contribute less than this are not traced"},
    {.name = "filter",
     .types = kString,
     .default_value = word_default("box"),
     .words = kFilters,
     .doc = "how samples make a pixel"},
    {.name = "filter_radius",
     .types = kNumber,
     .range = between(kMinFilterRadius, kMaxFilterRadius),
     .doc = "in pixels; usual for the filter if not given: box 0.5, tent 1, gaussian 1.5, "
            "mitchell 2"},
    {.name = "transparent_background",
     .types = kBool,
     .default_value = bool_default(false),
     .doc = "alpha 0 where nothing is seen"},
    {.name = "seed",
     .types = kNumber,
     .range = integers(0, static_cast<double>(kMaxSeed)),
     .default_value = number_default(0),
     .doc = "another gives other random numbers"},
};

constexpr BlockSchema kSchema = {
    .name = "render",
    .doc = "How the picture is made. The command line overrides it.",
    .tables = {kRender},
    .example = "render { size <640, 480>  samples 64  adaptive 0.005  filter mitchell }"};
constexpr const BlockSchema* kAll[] = {&kSchema};

}  // namespace

std::span<const BlockSchema* const> render_schemas() {
  return kAll;
}

}  // namespace alhazen::parser

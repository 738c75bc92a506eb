// parser/eval: the blocks of backgrounds.
#include "parser/eval/schema/schema.h"
#include "parser/eval/schema/types.h"

namespace alhazen::parser {
namespace {

constexpr PropertySpec kGradient[] = {
    {.name = "stops",
     .types = kList,
     .presence = Presence::required,
     .doc = "colours, evenly from straight down to straight up, or pairs [position, colour] with "
            "positions from -1, straight down, by 0, the horizon, to 1, straight up"},
};
constexpr PropertySpec kEnvironment[] = {
    {.name = "file",
     .types = kString,
     .presence = Presence::required,
     .doc = "a latitude-longitude picture, relative to the file this is written in"},
    {.name = "rotation",
     .types = kAngle,
     .default_value = angle_default(0),
     .doc = "turns it about y; at 0 its centre is in direction z"},
    {.name = "intensity",
     .types = kNumber,
     .range = at_least(0),
     .default_value = number_default(1),
     .doc = "a factor on its colours"},
    {.name = "color_space",
     .types = kString,
     .doc = "what the file holds; found by the rules of the colour configuration if not given"},
};

constexpr BlockSchema kSchemas[] = {
    {.name = "gradient",
     .doc = "Colours by the height of the direction.",
     .tables = {kGradient},
     .example = "background gradient { stops [rgb(0.2), rgb(0.9), rgb(0.3, 0.5, 0.9)] }"},
    {.name = "environment", .doc = "A picture of the surroundings.", .tables = {kEnvironment}},
};
constexpr const BlockSchema* kAll[] = {&kSchemas[0], &kSchemas[1]};

}  // namespace

std::span<const BlockSchema* const> background_schemas() {
  return kAll;
}

}  // namespace alhazen::parser

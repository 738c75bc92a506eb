// render/wave: the instruction sets that the renderer was compiled for, and which to use. Every one
// gives the same bits (docs/lanes.md).
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace alhazen::render {

enum class Isa {
#define ALHAZEN_ISA(name, text) name,
#include "render/wave/isa.def"
#undef ALHAZEN_ISA
};

struct IsaInfo {
  Isa isa;
  std::string_view name;  // as --isa has it
  std::string_view text;  // what it asks of the processor
};
inline constexpr IsaInfo kIsaInfo[] = {
#define ALHAZEN_ISA(name, text) {Isa::name, #name, text},
#include "render/wave/isa.def"
#undef ALHAZEN_ISA
};
constexpr const IsaInfo& info(Isa isa) {
  return kIsaInfo[static_cast<std::size_t>(isa)];
}

// Whether this program has it, and whether this processor and its system do.
bool is_compiled(Isa isa);
bool runs_here(Isa isa);

// Those that are compiled and run here, from the least to the widest; the last is the one to use.
// The baseline is always there.
std::vector<Isa> usable_isas();

}  // namespace alhazen::render

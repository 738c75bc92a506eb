#include "render/wave/isa.h"

#include "render/wave/render_precision.h"

namespace alhazen::render {

#if ALHAZEN_HAS_AVX2
namespace avx2 {
Result<RenderOutput> render_in_float(const RenderJob& job);
Result<RenderOutput> render_in_double(const RenderJob& job);
}  // namespace avx2
#endif
#if ALHAZEN_HAS_AVX512
namespace avx512 {
Result<RenderOutput> render_in_float(const RenderJob& job);
Result<RenderOutput> render_in_double(const RenderJob& job);
}  // namespace avx512
#endif

bool is_compiled(Isa isa) {
  switch (isa) {
    case Isa::baseline:
      return true;
    case Isa::avx2:
      return ALHAZEN_HAS_AVX2 != 0;
    case Isa::avx512:
      return ALHAZEN_HAS_AVX512 != 0;
  }
  return false;
}

// The features that the flags in cmake/Isa.cmake let the compiler use. The question covers the
// system too: it has to save the wider registers.
bool runs_here(Isa isa) {
#if defined(__x86_64__)
  const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                  __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") &&
                  __builtin_cpu_supports("popcnt");
  switch (isa) {
    case Isa::baseline:
      return true;
    case Isa::avx2:
      return v3;
    case Isa::avx512:
      return v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
             __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512vl");
  }
  return false;
#else
  return isa == Isa::baseline;
#endif
}

std::vector<Isa> usable_isas() {
  std::vector<Isa> result;
  for (const IsaInfo& each : kIsaInfo) {
    if (is_compiled(each.isa) && runs_here(each.isa)) result.push_back(each.isa);
  }
  return result;
}

RenderFunctions render_functions([[maybe_unused]] Isa isa) {
#if ALHAZEN_HAS_AVX2
  if (isa == Isa::avx2) return {avx2::render_in_float, avx2::render_in_double};
#endif
#if ALHAZEN_HAS_AVX512
  if (isa == Isa::avx512) return {avx512::render_in_float, avx512::render_in_double};
#endif
  return {baseline::render_in_float, baseline::render_in_double};
}

}  // namespace alhazen::render

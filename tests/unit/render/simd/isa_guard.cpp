// Ends the program as skipped, before anything compiled for an instruction set runs, where the
// processor has not got it.
#include <cstdio>
#include <cstdlib>

namespace {

bool processor_suits() {
  __builtin_cpu_init();
#ifdef ALHAZEN_NEEDS_avx512
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif
}

constexpr int kSkipped = 77;  // as tests/unit/render/simd/CMakeLists.txt tells CTest

// 101 is the first of the priorities that programs may have: before any other constructor.
__attribute__((constructor(101))) void skip_where_the_processor_does_not_suit() {
  if (processor_suits()) return;
  std::fputs("skipped: the processor has not got this instruction set\n", stderr);
  std::_Exit(kSkipped);
}

}  // namespace

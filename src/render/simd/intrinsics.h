// render/simd: the one place where the compiler's intrinsics come in.
#pragma once

// g++ 12 takes the deliberately undefined registers of its own header for mistakes (GCC bug
// 105593).
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <immintrin.h>
#pragma GCC diagnostic pop

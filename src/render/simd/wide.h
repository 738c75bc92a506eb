// render/simd: lanes as wide as the registers of the instruction set that this file is compiled
// for. A type that depends on compiler flags: it never crosses from one instruction set's object to
// another (docs/lanes.md).
#pragma once

#include "render/simd/lanes.h"

namespace alhazen::render {

#if defined(__AVX512F__)
inline constexpr int kRegisterBytes = 64;
#elif defined(__AVX2__)
inline constexpr int kRegisterBytes = 32;
#else
inline constexpr int kRegisterBytes = 16;
#endif

template <class Real>
inline constexpr int kWideWidth = sizeof(Real) < 16
                                      ? kRegisterBytes / static_cast<int>(sizeof(Real))
                                      : 1;

template <class Real>
using Wide = Lanes<Real, kWideWidth<Real>>;

}  // namespace alhazen::render

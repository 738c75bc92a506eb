// render/simd: lanes as wide as the registers of the instruction set that this file is compiled
// for. A type that depends on compiler flags: it never crosses from one instruction set's object to
// another (docs/lanes.md).
#pragma once

#include "render/simd/lanes.h"

namespace alhazen::render {

template <class Real>
inline constexpr int kWideWidth = sizeof(Real) < 16
                                      ? kRegisterBytes / static_cast<int>(sizeof(Real))
                                      : 1;

template <class Real>
using Wide = Lanes<Real, kWideWidth<Real>>;

}  // namespace alhazen::render

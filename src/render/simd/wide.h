// render/simd: lanes as wide as the registers of the instruction set that this file is compiled
// for. A type that depends on compiler flags: it never crosses from one instruction set's object to
// another (docs/lanes.md).
#pragma once

#include <algorithm>

#include "render/simd/lanes.h"

namespace alhazen::render {

template <class Real>
inline constexpr int kWideWidth = sizeof(Real) < 16
                                      ? kRegisterBytes / static_cast<int>(sizeof(Real))
                                      : 1;

template <class Real>
using Wide = Lanes<Real, kWideWidth<Real>>;

// Lanes of rays that look for shapes together. Of doubles two registers where there are 32 of them,
// so that one has work while the other waits, and what is done once for all rays is done half as
// often; of floats sixteen fill one. In shading, where more numbers are alive at once, two do not
// pay (docs/lanes.md).
inline constexpr int kWidestPacket = 16;
template <class Real>
inline constexpr int kPacketWidth = (ALHAZEN_SIMD_AVX512 != 0 && kWideWidth<Real> > 1)
                                        ? std::min(2 * kWideWidth<Real>, kWidestPacket)
                                        : kWideWidth<Real>;

template <class Real>
using Packet = Lanes<Real, kPacketWidth<Real>>;

}  // namespace alhazen::render

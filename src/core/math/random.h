// core/math: random numbers that are functions of a seed and an index, so that any sample of any
// pixel can be drawn in any order, on any machine, with the same bits.
//
// The 2D points are the first two dimensions of Sobol's sequence, shuffled and scrambled by
// hashing: B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020, with the hash of S.
// Laine and T. Karras 2011 in the constants of N. Vegdahl, "Building a Better LK Hash", 2021. For
// every seed, indices 0 .. 2^m - 1 hold one point in every elementary interval of area 2^-m.
#pragma once

#include <cstdint>

#include "core/base/hash.h"
#include "core/math/scalar.h"

namespace alhazen {

struct Sample2d {
  std::uint32_t x, y;
};

constexpr std::uint32_t reversed_bits(std::uint32_t v) {
  v = (v << 16) | (v >> 16);
  v = ((v & 0x00ff00ffu) << 8) | ((v & 0xff00ff00u) >> 8);
  v = ((v & 0x0f0f0f0fu) << 4) | ((v & 0xf0f0f0f0u) >> 4);
  v = ((v & 0x33333333u) << 2) | ((v & 0xccccccccu) >> 2);
  return ((v & 0x55555555u) << 1) | ((v & 0xaaaaaaaau) >> 1);
}

// A bijection in which each bit is flipped by a hash of the lower bits and the seed alone: nested
// uniform scrambling, as Owen's, of the binary tree whose root is the lowest bit.
constexpr std::uint32_t scrambled_upward(std::uint32_t v, std::uint32_t seed) {
  v ^= v * 0x3d20adeau;
  v += seed;
  v *= (seed >> 16) | 1u;
  v ^= v * 0x05526c56u;
  v ^= v * 0x53a22864u;
  return v;
}

// Owen's scrambling of the digits of v * 2^-32, from the most significant down.
constexpr std::uint32_t owen_scrambled(std::uint32_t v, std::uint32_t seed) {
  return reversed_bits(scrambled_upward(reversed_bits(v), seed));
}

// The second dimension of Sobol's sequence, whose matrix is Pascal's triangle modulo two: the
// direction numbers are v_0 = 1/2, v_k = v_{k-1} ^ (v_{k-1} >> 1). The first is reversed_bits.
constexpr std::uint32_t sobol_second(std::uint32_t index) {
  std::uint32_t result = 0;
  for (std::uint32_t direction = 0x80000000u; index != 0; index >>= 1) {
    if ((index & 1u) != 0) result ^= direction;
    direction ^= direction >> 1;
  }
  return result;
}

// Sample `index` of the sequence named by `seed`. Seeds are to be hashes (mix_64) of what the
// sequence is for: pixel, dimension, ray.
constexpr Sample2d sample_2d(std::uint64_t seed, std::uint32_t index) {
  const std::uint64_t first = mix_64(seed, 1), second = mix_64(seed, 2);
  // Shuffling the index by an Owen scramble keeps prefixes of length 2^m what they are: a
  // scrambled prefix of the same length, at another place of the sequence.
  const std::uint32_t shuffled = owen_scrambled(index, static_cast<std::uint32_t>(first));
  return {owen_scrambled(reversed_bits(shuffled), static_cast<std::uint32_t>(first >> 32)),
          owen_scrambled(sobol_second(shuffled), static_cast<std::uint32_t>(second))};
}

// The first dimension alone: stratified in every prefix of length 2^m.
constexpr std::uint32_t sample_1d(std::uint64_t seed, std::uint32_t index) {
  return sample_2d(seed, index).x;
}

// A number in [0, 1) with 24 bits, so that float, double and Quad draw the same one.
template <class Real>
constexpr Real unit_real(std::uint32_t bits) {
  return static_cast<Real>(bits >> 8) * static_cast<Real>(0x1p-24);
}

}  // namespace alhazen

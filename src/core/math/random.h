// core/math: random numbers that are functions of a seed and an index, so that any sample of any
// pixel can be drawn in any order, on any machine, with the same bits.
//
// The 2D points are the first two dimensions of Sobol's sequence, shuffled and scrambled by
// hashing: B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020, with the hash of S.
// Laine and T. Karras 2011 in the constants of N. Vegdahl, "Building a Better LK Hash", 2021. For
// every seed, indices 0 .. 2^m - 1 hold one point in every elementary interval of area 2^-m.
#pragma once

#include <cstdint>
#include <type_traits>

#include "core/base/hash.h"
#include "core/math/scalar.h"

namespace alhazen {

// `Word` below is std::uint32_t or lanes of it (render/simd/lanes.h).

// The highest bit becomes the lowest.
template <class Word>
constexpr Word reversed_bits(Word v) {
  v = (v << 16) | (v >> 16);
  v = ((v & 0x00ff00ffu) << 8) | ((v & 0xff00ff00u) >> 8);
  v = ((v & 0x0f0f0f0fu) << 4) | ((v & 0xf0f0f0f0u) >> 4);
  v = ((v & 0x33333333u) << 2) | ((v & 0xccccccccu) >> 2);
  return ((v & 0x55555555u) << 1) | ((v & 0xaaaaaaaau) >> 1);
}

// A bijection in which each bit is flipped by a hash of the lower bits and the seed alone: nested
// uniform scrambling, as Owen's, of the binary tree whose root is the lowest bit.
template <class Word>
constexpr Word scrambled_upward(Word v, Word seed) {
  v ^= v * 0x3d20adeau;
  v += seed;
  v *= (seed >> 16) | 1u;
  v ^= v * 0x05526c56u;
  v ^= v * 0x53a22864u;
  return v;
}

// Owen's scrambling of the digits of v * 2^-32, from the most significant down.
template <class Word>
constexpr Word owen_scrambled(Word v, std::type_identity_t<Word> seed) {
  return reversed_bits(scrambled_upward(reversed_bits(v), seed));
}

// The second dimension of Sobol's sequence from its lowest digit up; the first is the index itself.
// Its direction numbers are v_0 = 1/2, v_k = v_{k-1} ^ (v_{k-1} >> 1), Pascal's triangle modulo
// two: the digits are the coefficients of p(1 + x), where those of p are the bits of the index.
// With p = h x^n + l and n a power of two, p(1 + x) = h(1 + x) (1 + x^n) + l(1 + x), so the upper
// half of each block of 2n bits is added to the lower.
template <class Word>
constexpr Word sobol_second_upward(Word index) {
  index ^= (index >> 16) & 0x0000ffffu;
  index ^= (index >> 8) & 0x00ff00ffu;
  index ^= (index >> 4) & 0x0f0f0f0fu;
  index ^= (index >> 2) & 0x33333333u;
  return index ^ ((index >> 1) & 0x55555555u);
}

template <class Word>
struct Sample2dOf {
  Word x, y;
};
using Sample2d = Sample2dOf<std::uint32_t>;

// What a sequence is shuffled and scrambled by. `Seed` is std::uint64_t or lanes of it.
template <class Seed>
struct SequenceKeys {
  Seed first, second;
};
// Of the sequence named by `seed`. Seeds are to be hashes (mix_64) of what the sequence is for:
// pixel, dimension, ray.
template <class Seed>
constexpr SequenceKeys<Seed> sequence_keys(Seed seed) {
  constexpr std::uint64_t kFirst = mix_64(1 + 0x9e3779b97f4a7c15ULL),
                          kSecond = mix_64(2 + 0x9e3779b97f4a7c15ULL);
  return {mixed_word(seed ^ Seed(kFirst)), mixed_word(seed ^ Seed(kSecond))};
}

// Sample `index` of a sequence. `Word` is std::uint32_t, or both are lanes.
template <class Seed, class Word>
constexpr Sample2dOf<Word> sample_2d_of(const SequenceKeys<Seed>& keys, Word index) {
  const auto& [first, second] = keys;
  // Shuffling the index by an Owen scramble keeps prefixes of length 2^m what they are: a
  // scrambled prefix of the same length, at another place of the sequence.
  const Word shuffled = owen_scrambled(index, static_cast<Word>(first));
  // Both dimensions are made from their lowest digit up, as the scrambling wants them.
  return {
      reversed_bits(scrambled_upward(shuffled, static_cast<Word>(first >> 32))),
      reversed_bits(scrambled_upward(sobol_second_upward(shuffled), static_cast<Word>(second)))};
}
constexpr Sample2d sample_2d(std::uint64_t seed, std::uint32_t index) {
  return sample_2d_of(sequence_keys(seed), index);
}
template <class Seed, class Word>
requires(!std::is_arithmetic_v<Seed>) constexpr Sample2dOf<Word> sample_2d(Seed seed, Word index) {
  return sample_2d_of(sequence_keys(seed), index);
}

// The first dimension alone: stratified in every prefix of length 2^m.
constexpr std::uint32_t sample_1d(std::uint64_t seed, std::uint32_t index) {
  return sample_2d(seed, index).x;
}

// A number in [0, 1) with 24 bits, so that float, double and Quad draw the same one.
template <class Real, class Word>
constexpr Real unit_real(Word bits) {
  return static_cast<Real>(bits >> 8) * static_cast<Real>(0x1p-24);
}

}  // namespace alhazen

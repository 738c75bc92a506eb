// core/base: hashes with published definitions, for provenance, ids and counter-based randomness.
#pragma once

#include <cstdint>
#include <string_view>
#include <type_traits>

namespace alhazen {

// FNV-1a, 64 bits (Fowler, Noll, Vo). Names a scene text; not a defence against forgery.
constexpr std::uint64_t fnv1a_64(std::string_view bytes,
                                 std::uint64_t seed = 0xcbf29ce484222325ULL) {
  std::uint64_t hash = seed;
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

// A bijection of 64-bit words in which every input bit moves every output bit: the finaliser of
// SplitMix64 (Steele, Lea, Flood 2014) with the constants of its variant 13 (Stafford). `Word` is
// std::uint64_t or lanes of it.
template <class Word>
constexpr Word mixed_word(Word word) {
  word ^= word >> 30;
  word *= 0xbf58476d1ce4e5b9ULL;
  word ^= word >> 27;
  word *= 0x94d049bb133111ebULL;
  word ^= word >> 31;
  return word;
}
constexpr std::uint64_t mix_64(std::uint64_t word) {
  return mixed_word(word);
}

// The hash of a sequence so far, extended by one word. Order matters.
constexpr std::uint64_t mix_64(std::uint64_t state, std::uint64_t word) {
  return mix_64(state ^ mix_64(word + 0x9e3779b97f4a7c15ULL));
}

// The same of lanes of words.
template <class Word>
requires(!std::is_arithmetic_v<Word>) constexpr Word
    mix_64(Word state, std::type_identity_t<Word> word) {
  return mixed_word(state ^ mixed_word(word + 0x9e3779b97f4a7c15ULL));
}

}  // namespace alhazen

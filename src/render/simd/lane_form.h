// render/simd: in what form lanes are kept: a register, two halves, or an array.
#pragma once

#include <bit>
#include <cstdint>

namespace alhazen::render {

// The registers of the instruction set that this file is compiled for. The kernels are compiled
// once for each of the three (cmake/Isa.cmake); what comes between them counts as the lower one.
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__) && \
    defined(__AVX512BW__) && defined(__FMA__)
#define ALHAZEN_SIMD_AVX512 1
#else
#define ALHAZEN_SIMD_AVX512 0
#endif
#if defined(__AVX2__) && defined(__FMA__)
#define ALHAZEN_SIMD_AVX2 1
#else
#define ALHAZEN_SIMD_AVX2 0
#endif
#if defined(__SSE2__)
#define ALHAZEN_SIMD_SSE2 1
#else
#define ALHAZEN_SIMD_SSE2 0
#endif

inline constexpr int kRegisterBytes = ALHAZEN_SIMD_AVX512 ? 64 : ALHAZEN_SIMD_AVX2 ? 32 : 16;

// array: a loop over numbers, for what no register holds (Quad, a single number, other machines).
// pair: two of half the width, where one register is too small.
// vector: one register, of 16 bytes up to kRegisterBytes.
enum class Form { array, pair, vector };

constexpr Form form_of(int bytes_of_number, int width) {
  const bool fits_registers = (bytes_of_number == 4 || bytes_of_number == 8) && width > 0 &&
                              std::has_single_bit(static_cast<unsigned>(width));
  const int bytes = bytes_of_number * width;
  if (!ALHAZEN_SIMD_SSE2 || !fits_registers || bytes < 16) return Form::array;
  return bytes <= kRegisterBytes ? Form::vector : Form::pair;
}

// What a form provides for W numbers of type T, and for W answers about numbers of `Bytes` bytes.
// Each is specialised in the file of the form; lanes.h is written on them.
template <class T, int W, Form = form_of(static_cast<int>(sizeof(T)), W)>
struct LaneStore;
template <int Bytes, int W, Form = form_of(Bytes, W)>
struct MaskStore;

// Numbers that are wider than any whole number, as Quad is, share the masks of std::int64_t.
template <class T>
inline constexpr int kMaskBytes = sizeof(T) < 8 ? static_cast<int>(sizeof(T)) : 8;

enum class Comparison { equal, unequal, less, less_equal, greater, greater_equal };

template <Comparison C, class T>
constexpr auto compared(const T& a, const T& b) {
  if constexpr (C == Comparison::equal) return a == b;
  if constexpr (C == Comparison::unequal) return a != b;
  if constexpr (C == Comparison::less) return a < b;
  if constexpr (C == Comparison::less_equal) return a <= b;
  if constexpr (C == Comparison::greater) return a > b;
  if constexpr (C == Comparison::greater_equal) return a >= b;
}

// The low `width` bits.
constexpr std::uint32_t low_bits(int width) {
  return width >= 32 ? ~std::uint32_t{0} : (std::uint32_t{1} << width) - 1;
}

}  // namespace alhazen::render

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Lanes_h
#define geodesic_Lanes_h

#include "base/Platform.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

/**
 * Numbers that the processor treats at once: a formula over one is also one over two or four, if it
 * is written with what is here instead of branches. Two go everywhere, four where the processor has
 * AVX2, which hasQuads() tells while the program runs.
 *
 * What works on four is compiled for AVX2 by being inlined into a function that is marked
 * GEODESIC_QUADS. Everything on the way that takes or returns a Quad by value is GEODESIC_INLINED,
 * as how one is passed differs between what is compiled for AVX2 and what is not. Results are the
 * same to the bit either way: products and sums are never contracted.
 */
/** For what a flat function does not call itself, but on the way to what works on four: GCC inlines
 * that as it is, Clang does not. */
#ifdef __clang__
#define GEODESIC_FLAT GEODESIC_INLINED
#else
#define GEODESIC_FLAT
#endif
#ifdef __x86_64__
#define GEODESIC_QUADS gnu::target("avx2,bmi,bmi2")
#else
#define GEODESIC_QUADS
#endif

namespace geodesic
{

/** How many numbers there are in a double, a Pair or a Quad. */
template <class Real>
inline constexpr std::size_t lanes = sizeof(Real) / sizeof(double);

/** Whether both tests hold; without a branch. */
template <class Test>
GEODESIC_INLINED auto both(const Test& a, const Test& b)
{
  return a & b;
}
inline bool both(bool a, bool b)
{
  return static_cast<bool>(static_cast<int>(a) & static_cast<int>(b));
}
inline bool any(bool test)
{
  return test;
}
inline double select(bool test, double a, double b)
{
  return test ? a : b;
}
/** These two are the second number where one is NaN. */
inline double least(double a, double b)
{
  return a < b ? a : b;
}
inline double largest(double a, double b)
{
  return a > b ? a : b;
}
inline double root(double x)
{
  return std::sqrt(x);
}

/** Whether this processor runs what is marked GEODESIC_QUADS. */
inline bool hasQuads()
{
#if GEODESIC_HAS_LANES && defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("bmi2") != 0;
#else
  return false;
#endif
}

inline void storeFloats(double number, float* to)
{
  *to = static_cast<float>(number);
}

#if GEODESIC_HAS_LANES

using Pair = double __attribute__((vector_size(16)));
using Quad = double __attribute__((vector_size(32)));
/** What comparing gives: for each of the numbers all bits or none. */
using PairTest = decltype(Pair() < Pair());
using QuadTest = decltype(Quad() < Quad());

/** The first test's result in bit 0, the second's in bit 1. */
inline unsigned bitsOf(PairTest test)
{
#ifdef __SSE2__
  return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(test)));
#else
  return static_cast<unsigned>((test[0] & 1) | (test[1] & 2));
#endif
}
/** The results in bits 0 to 3. */
[[GEODESIC_QUADS]] inline unsigned bitsOf(const QuadTest& test)
{
#ifdef __x86_64__
  return static_cast<unsigned>(__builtin_ia32_movmskpd256(reinterpret_cast<const Quad&>(test)));
#else
  return static_cast<unsigned>((test[0] & 1) | (test[1] & 2) | (test[2] & 4) | (test[3] & 8));
#endif
}

inline bool any(PairTest test)
{
  return bitsOf(test) != 0;
}
GEODESIC_INLINED bool any(QuadTest test)
{
  return bitsOf(test) != 0;
}

inline Pair select(PairTest test, Pair a, Pair b)
{
  return test ? a : b;
}
GEODESIC_INLINED Quad select(QuadTest test, Quad a, Quad b)
{
  return test ? a : b;
}

#ifdef __SSE2__
inline Pair least(Pair a, Pair b)
{
  return _mm_min_pd(a, b);
}
inline Pair largest(Pair a, Pair b)
{
  return _mm_max_pd(a, b);
}
inline Pair root(Pair x)
{
  return _mm_sqrt_pd(x);
}
#else
inline Pair least(Pair a, Pair b)
{
  return a < b ? a : b;
}
inline Pair largest(Pair a, Pair b)
{
  return a > b ? a : b;
}
inline Pair root(Pair x)
{
  return Pair{ std::sqrt(x[0]), std::sqrt(x[1]) };
}
#endif

GEODESIC_INLINED Quad least(Quad a, Quad b)
{
  return a < b ? a : b;
}
GEODESIC_INLINED Quad largest(Quad a, Quad b)
{
  return a > b ? a : b;
}
GEODESIC_INLINED Quad root(Quad x)
{
  return Quad{ std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3]) };
}

/** To and from where numbers are one after the other. */
template <class Several, class Number>
GEODESIC_INLINED void store(const Several& numbers, Number* to)
{
  std::memcpy(to, &numbers, sizeof numbers);
}
template <class Real>
GEODESIC_INLINED Real load(const double* from)
{
  Real numbers;
  std::memcpy(&numbers, from, sizeof numbers);
  return numbers;
}

/** Of the same number. */
template <class Real>
GEODESIC_INLINED Real sameOf(double number)
{
  if constexpr (lanes<Real> == 2)
  {
    return Real{ number, number };
  }
  else
  {
    return Real{ number, number, number, number };
  }
}

/** As many floats as there are numbers. */
template <class Real>
struct FloatsBeside;
template <>
struct FloatsBeside<Pair>
{
  using Type = float __attribute__((vector_size(8)));
};
template <>
struct FloatsBeside<Quad>
{
  using Type = float __attribute__((vector_size(16)));
};
template <class Real>
GEODESIC_INLINED void storeFloats(const Real& numbers, float* to)
{
  const auto floats = __builtin_convertvector(numbers, typename FloatsBeside<Real>::Type);
  std::memcpy(to, &floats, sizeof floats);
}

/** The numbers that @p numberAt gives for 0, 1 and so on. */
template <class Real, class NumberAt>
GEODESIC_INLINED Real lanesOf(NumberAt numberAt)
{
  if constexpr (lanes<Real> == 2)
  {
    return Real{ numberAt(0), numberAt(1) };
  }
  else
  {
    return Real{ numberAt(0), numberAt(1), numberAt(2), numberAt(3) };
  }
}

/** What comparing several numbers gives. */
template <class Real>
using TestOf = decltype(Real() < Real());

/** 32 bits beside each of several numbers. */
template <class Real>
struct BitsBeside;
template <>
struct BitsBeside<Pair>
{
  using Type = std::uint32_t __attribute__((vector_size(8)));
};
template <>
struct BitsBeside<Quad>
{
  using Type = std::uint32_t __attribute__((vector_size(16)));
};
template <class Real>
using BitsOf = typename BitsBeside<Real>::Type;

/** Those that @p bitsAt gives for 0, 1 and so on. */
template <class Real, class BitsAt>
GEODESIC_INLINED BitsOf<Real> bitsWith(BitsAt bitsAt)
{
  if constexpr (lanes<Real> == 2)
  {
    return BitsOf<Real>{ bitsAt(0), bitsAt(1) };
  }
  else
  {
    return BitsOf<Real>{ bitsAt(0), bitsAt(1), bitsAt(2), bitsAt(3) };
  }
}

/** Every second one of the bits of @p a, then of @p b, from number @p First of each on. */
template <int First, class Bits>
GEODESIC_INLINED Bits everySecond(const Bits& a, const Bits& b)
{
  if constexpr (sizeof(Bits) == sizeof(BitsOf<Pair>))
  {
    return __builtin_shufflevector(a, b, First, First + 2);
  }
  else
  {
    return __builtin_shufflevector(a, b, First, First + 2, First + 4, First + 6);
  }
}

/** What comparing them gives. */
template <class Real>
using BitsTestOf = decltype(BitsOf<Real>() == BitsOf<Real>());

/** The same beside numbers as among them. */
template <class Real>
GEODESIC_INLINED TestOf<Real> widened(const BitsTestOf<Real>& test)
{
  return __builtin_convertvector(test, TestOf<Real>);
}

/** Which of bits 0, 1 and so on are set. */
template <class Real>
GEODESIC_INLINED TestOf<Real> whereSet(unsigned bits)
{
  return widened<Real>((bitsWith<Real>([](int lane) { return 1u << lane; }) & bits) != 0);
}

/** Whether the highest of the bits is set, in bits 0, 1 and so on; of a test, its results. */
template <class Real>
GEODESIC_INLINED unsigned highestBits(const BitsTestOf<Real>& bits)
{
#ifdef __SSE2__
  if constexpr (lanes<Real> == 4)
  {
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<const __m128&>(bits)));
  }
#endif
  return bitsOf(widened<Real>(bits));
}
template <class Real>
GEODESIC_INLINED unsigned highestBits(const BitsOf<Real>& bits)
{
  return highestBits<Real>(reinterpret_cast<const BitsTestOf<Real>&>(bits));
}

/** The last of @p before, then @p numbers without their last. */
GEODESIC_INLINED Pair shiftedIn(Pair before, Pair numbers)
{
  return __builtin_shufflevector(before, numbers, 1, 2);
}
GEODESIC_INLINED Quad shiftedIn(Quad before, Quad numbers)
{
  return __builtin_shufflevector(before, numbers, 3, 4, 5, 6);
}

#endif

}

#endif

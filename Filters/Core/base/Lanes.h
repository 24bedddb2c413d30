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
 * Arithmetic on one, two or four numbers (lanes) at once, by the processor's vector instructions. A
 * formula that is a template over its number type works on a double, a Pair and a Quad, if it uses
 * the functions of this file instead of branches. Every processor takes a Pair; a Quad needs AVX2,
 * which hasQuads() checks at run time.
 *
 * A function marked GEODESIC_QUADS is compiled for AVX2, with all that is inlined into it.
 * Every function below it that takes or returns a Quad by value must be GEODESIC_INLINED, because
 * the calling conventions for a Quad differ between code compiled for AVX2 and other code. Results
 * are the same to the bit with any number of lanes: products and sums are never contracted.
 */
/**
 * Marks a function that a function with gnu::flatten calls through others and that must be inlined
 * there. GCC's flatten inlines all levels of calls; Clang's only the direct ones, so that Clang
 * needs the mark.
 */
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

/** The number of numbers in a Real: 1 in a double, 2 in a Pair, 4 in a Quad. */
template <class Real>
inline constexpr std::size_t lanes = sizeof(Real) / sizeof(double);

/** Whether both tests hold, for each lane; computed without a branch. */
template <class Test>
GEODESIC_INLINED auto both(const Test& a, const Test& b)
{
  return a & b;
}
inline bool both(bool a, bool b)
{
  return static_cast<bool>(static_cast<int>(a) & static_cast<int>(b));
}
/** Whether a test holds for at least one lane. */
inline bool any(bool test)
{
  return test;
}
/** For each lane, @p a where the test holds and @p b elsewhere. */
inline double select(bool test, double a, double b)
{
  return test ? a : b;
}
/** For each lane the smaller or larger number; @p b where either is NaN. */
inline double least(double a, double b)
{
  return a < b ? a : b;
}
inline double largest(double a, double b)
{
  return a > b ? a : b;
}
/** For each lane the square root. */
inline double root(double x)
{
  return std::sqrt(x);
}

/** Whether this processor can run functions marked GEODESIC_QUADS. */
inline bool hasQuads()
{
#if GEODESIC_HAS_LANES && defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("bmi2") != 0;
#else
  return false;
#endif
}

/** Writes the lanes one after the other to @p to, rounded to floats. */
inline void storeFloats(double number, float* to)
{
  *to = static_cast<float>(number);
}

#if GEODESIC_HAS_LANES

using Pair = double __attribute__((vector_size(16)));
using Quad = double __attribute__((vector_size(32)));
/** The result of a comparison: for each lane all bits set where it holds, none elsewhere. */
using PairTest = decltype(Pair() < Pair());
using QuadTest = decltype(Quad() < Quad());

/** Packs a test's results: that of lane 0 in bit 0, that of lane 1 in bit 1. */
inline unsigned bitsOf(PairTest test)
{
#ifdef __SSE2__
  return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(test)));
#else
  return static_cast<unsigned>((test[0] & 1) | (test[1] & 2));
#endif
}
/** Packs a test's results of lanes 0 to 3 in bits 0 to 3. */
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

/** store() writes the lanes one after the other to @p to; load() reads them from @p from. */
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

/** Returns @p number in every lane. */
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

/** The vector type of as many floats as a Real has lanes. */
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

/** Returns numberAt(i) in lane i. */
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

/** The result type of comparing two Reals. */
template <class Real>
using TestOf = decltype(Real() < Real());

/** The vector type of one 32-bit integer for each lane of a Real. */
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

/** Returns bitsAt(i) in lane i. */
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

/** Returns every second lane of @p a, then of @p b, each from lane First (0 or 1) on. */
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

/** The result type of comparing two BitsOf<Real>. */
template <class Real>
using BitsTestOf = decltype(BitsOf<Real>() == BitsOf<Real>());

/** Converts a test of 32-bit lanes to a test of the numbers' 64-bit lanes. */
template <class Real>
GEODESIC_INLINED TestOf<Real> widened(const BitsTestOf<Real>& test)
{
  return __builtin_convertvector(test, TestOf<Real>);
}

/** A test that holds in lane i where bit i of @p bits is set. */
template <class Real>
GEODESIC_INLINED TestOf<Real> whereSet(unsigned bits)
{
  return widened<Real>((bitsWith<Real>([](int lane) { return 1u << lane; }) & bits) != 0);
}

/** Packs the highest bit of lane i in bit i. From a test this packs its results. */
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

/** Shifts @p numbers up by one lane; lane 0 gets the last lane of @p before. */
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

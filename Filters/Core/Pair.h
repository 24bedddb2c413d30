#ifndef geodesic_Pair_h
#define geodesic_Pair_h

#include <cmath>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace geodesic
{

/** Two numbers that the processor treats at once: a formula over one is also one over two, if it is
 * written with what is here instead of branches. */
using Pair = double __attribute__((vector_size(16)));
/** What comparing pairs gives: for each of the two all bits or none. */
using PairTest = decltype(Pair() < Pair());

/** The first test's result in bit 0, the second's in bit 1. */
inline unsigned bitsOf(PairTest test)
{
#ifdef __SSE2__
  return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(test)));
#else
  return static_cast<unsigned>((test[0] & 1) | (test[1] & 2));
#endif
}

inline bool any(bool test)
{
  return test;
}
inline bool any(PairTest test)
{
  return bitsOf(test) != 0;
}

inline double select(bool test, double a, double b)
{
  return test ? a : b;
}
inline Pair select(PairTest test, Pair a, Pair b)
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

}

#endif

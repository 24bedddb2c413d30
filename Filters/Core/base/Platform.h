// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Platform_h
#define geodesic_Platform_h

/**
 * Compiler features that Core uses beyond C++20, each with a replacement for compilers without it.
 *
 * GEODESIC_HAS_LANES: 1 where the compiler has vector extensions, as GCC and Clang do (see
 * Lanes.h). Without them, or with GEODESIC_SCALAR defined, it is 0: all code then works on one
 * number at a time, and ReferenceSolver does the work of FastMarchingSolver.
 *
 * GEODESIC_INLINED: marks a function that is always inlined; elsewhere plain inline.
 */
#if defined(__GNUC__) && !defined(GEODESIC_SCALAR)
#define GEODESIC_HAS_LANES 1
#else
#define GEODESIC_HAS_LANES 0
#endif

#ifdef __GNUC__
#define GEODESIC_INLINED [[gnu::always_inline]] inline
#else
#define GEODESIC_INLINED inline
#endif

namespace geodesic
{

/**
 * Asks the processor to fetch memory into its cache that will soon be read. GCC drops the call
 * unless this function, and every function that contains the call, is inlined.
 */
GEODESIC_INLINED void prefetchToRead([[maybe_unused]] const void* memory)
{
#ifdef __GNUC__
  __builtin_prefetch(memory);
#endif
}
/** The same for memory that will soon be written. */
GEODESIC_INLINED void prefetchToWrite([[maybe_unused]] const void* memory)
{
#ifdef __GNUC__
  __builtin_prefetch(memory, 1);
#endif
}

/** Tells the processor that a thread only looks whether another one has got ahead. */
inline void pauseProcessor()
{
#if defined(__GNUC__) && (defined(__x86_64__) || defined(__i386__))
  __builtin_ia32_pause();
#elif defined(__GNUC__) && defined(__aarch64__)
  __asm__ volatile("yield");
#endif
}

}

#endif

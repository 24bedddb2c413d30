// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Platform_h
#define geodesic_Platform_h

/**
 * What Core asks of a compiler beyond C++20, each with what takes its place elsewhere.
 *
 * GEODESIC_HAS_LANES: vector extensions, as GCC and Clang have them; see Lanes.h. Without them, or
 * with GEODESIC_SCALAR defined, everything works on one number at a time, and ReferenceSolver does
 * what FastMarchingSolver does elsewhere.
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

/** Has the processor fetch memory that is soon to be read. GCC drops the call unless it, and every
 * function that it stands in, is inlined. */
GEODESIC_INLINED void prefetchToRead([[maybe_unused]] const void* memory)
{
#ifdef __GNUC__
  __builtin_prefetch(memory);
#endif
}
/** The same of memory that is soon to be written. */
GEODESIC_INLINED void prefetchToWrite([[maybe_unused]] const void* memory)
{
#ifdef __GNUC__
  __builtin_prefetch(memory, 1);
#endif
}

}

#endif

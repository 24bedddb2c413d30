// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedNumber_h
#define geodesic_SharedNumber_h

#include "base/Lanes.h"
#include "base/Platform.h"

#if defined(__x86_64__) && defined(__OPTIMIZE__) && !defined(__clang__) &&                         \
  !defined(__SANITIZE_THREAD__)
#define GEODESIC_READS_LANES_PLAINLY 1
#else
#define GEODESIC_READS_LANES_PLAINLY 0
#endif

namespace geodesic
{

/**
 * Reads or writes a number, of at most 8 bytes, that other threads write or read at the same time:
 * all of it at once, and in no order to others. As std::atomic_ref does, which not all compilers
 * have; only for compilers with vector extensions.
 */
template <class Number>
GEODESIC_INLINED Number readShared(const Number& from)
{
  Number number;
  __atomic_load(&from, &number, __ATOMIC_RELAXED);
  return number;
}
template <class Number>
GEODESIC_INLINED void writeShared(Number& to, Number number)
{
  __atomic_store(&to, &number, __ATOMIC_RELAXED);
}

/** What is read shared before is read before what is read after, and what is written shared before
 * is seen before what is written after. An x86 processor does both anyway. */
GEODESIC_INLINED void keepSharedInOrder()
{
#if defined(__x86_64__) || defined(__i386__)
  __atomic_signal_fence(__ATOMIC_ACQ_REL);
#else
  __atomic_thread_fence(__ATOMIC_ACQ_REL);
#endif
}

/**
 * Shared numbers in the lanes of a vector, each of which is read at once, where numberAt(lane)
 * returns a reference to one. Through an atomic read a number goes to a register of its own first,
 * which takes some hundredths of a march's instructions. On x86 an aligned number is always read at
 * once, so a plain read is enough there, as long as the compiler does not repeat it: the empty
 * instruction hides where the vector comes from. Clang takes no vectors of all sizes in it, and GCC
 * without optimisation none that are larger than a register.
 */
template <class Real, class NumberAt>
GEODESIC_INLINED Real sharedLanesOf(const NumberAt& numberAt)
{
#if GEODESIC_READS_LANES_PLAINLY
  Real vector = lanesOf<Real>([&](int lane) { return numberAt(lane); });
  __asm__("" : "+x"(vector));
  return vector;
#else
  return lanesOf<Real>([&](int lane) { return readShared(numberAt(lane)); });
#endif
}
/** The same for the bits of what has a function bits(). */
template <class Real, class ItemAt>
GEODESIC_INLINED BitsOf<Real> sharedBitsWith(const ItemAt& itemAt)
{
#if GEODESIC_READS_LANES_PLAINLY
  BitsOf<Real> vector = bitsWith<Real>([&](int lane) { return itemAt(lane).bits(); });
  __asm__("" : "+x"(vector));
  return vector;
#else
  return bitsWith<Real>([&](int lane) { return readShared(itemAt(lane)).bits(); });
#endif
}

}

#endif

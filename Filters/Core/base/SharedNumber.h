// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedNumber_h
#define geodesic_SharedNumber_h

#include "base/Lanes.h"
#include "base/Platform.h"

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
 * The same for numbers that go into the lanes of a vector, each of which is read at once: returns
 * vectorOf(read), where read(number) reads one of them. Through an atomic read a number goes to a
 * register of its own first, which takes some hundredths of a march's instructions. On x86 an
 * aligned number is always read at once, so a plain read is enough there, as long as the compiler
 * does not repeat it: the empty instruction hides where the vector comes from. Clang takes no
 * vectors of all sizes in it, and GCC without optimisation none that are larger than a register.
 */
template <class VectorOf>
GEODESIC_INLINED auto readSharedLanes(const VectorOf& vectorOf)
{
#if defined(__x86_64__) && defined(__OPTIMIZE__) && !defined(__clang__) &&                         \
  !defined(__SANITIZE_THREAD__)
  auto vector = vectorOf([](const auto& number) { return number; });
  __asm__("" : "+x"(vector));
  return vector;
#else
  return vectorOf([](const auto& number) { return readShared(number); });
#endif
}

}

#endif

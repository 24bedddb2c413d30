// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedNumber_h
#define geodesic_SharedNumber_h

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

}

#endif

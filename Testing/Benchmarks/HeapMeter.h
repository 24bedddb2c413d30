// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_HeapMeter_h
#define geodesic_testing_HeapMeter_h

#include <cstddef>

namespace geodesic::testing
{

/**
 * Counts what this program holds on the heap through operator new, and the most that it held. The
 * operators are replaced in the whole program.
 */
class HeapMeter
{
public:
  /** Starts at what is held now. */
  HeapMeter();

  /** Bytes held beyond those at the start. */
  std::size_t held() const;
  /** The most of held() since the start. */
  std::size_t peak() const;

private:
  std::size_t Start;
};

}

#endif

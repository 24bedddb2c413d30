// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WorkCount_h
#define geodesic_WorkCount_h

#include <cstddef>

namespace geodesic
{

/**
 * Counts the steps of what walks over a mesh beside fast marching: entries of rings, triangles and
 * faces of strips and vertices without a seed that are looked at, windows that cross a triangle.
 * Tests tell from it how work grows with the input, which a clock tells less surely. Each thread
 * has a count of its own.
 */
class WorkCount
{
public:
  static void add(std::size_t steps) { Steps += steps; }
  /** The steps of this thread since it began. */
  static std::size_t steps() { return Steps; }

private:
  static constinit inline thread_local std::size_t Steps = 0;
};

}

#endif

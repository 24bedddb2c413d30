// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BvhSplit_h
#define geodesic_BvhSplit_h

#include "base/Index.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

class TriangleMesh;

/**
 * Tells where to cut a run of a mesh's triangles in two. Triangles follow a space-filling curve,
 * which jumps: a run across a large jump lies in two places, and bounds both of them badly. The
 * farther the curve jumps, the higher is the first bit in which the codes on both sides of the jump
 * differ.
 */
class BvhSplit
{
public:
  explicit BvhSplit(const TriangleMesh& mesh);

  /**
   * Returns where to cut the run of triangles from @p first to before @p last, at least two: the
   * first triangle of the second part. That is at the farthest jump; of equal ones, at the one
   * nearest to the middle. No part is less than an eighth of the run. Time O(n).
   */
  Index cut(Index first, Index last) const;

private:
  /** For each triangle how far the curve jumps before it: the highest bit that changes, from 1. */
  std::vector<std::uint8_t> Jumps;
};

}

#endif

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
 * Tells where to cut a run of a mesh's triangles in two. They follow a space filling curve, which
 * jumps: a run that goes on behind a large jump is in two places, and tells little of either. The
 * farther the curve jumps, the higher is the first bit in which the codes before and behind differ.
 */
class BvhSplit
{
public:
  explicit BvhSplit(const TriangleMesh& mesh);

  /**
   * Where the second part of a run of at least two triangles begins: at the farthest jump, of equal
   * ones that nearest to the middle. No part is less than an eighth of the whole. Time O(n).
   */
  Index cut(Index first, Index last) const;

private:
  /** How far the curve jumps before each triangle. */
  std::vector<std::uint8_t> Jumps;
};

}

#endif

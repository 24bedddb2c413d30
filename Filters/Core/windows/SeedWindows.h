// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SeedWindows_h
#define geodesic_SeedWindows_h

#include "base/Index.h"
#include "solve/Seed.h"

#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

class TriangleMesh;
class WindowFront;

/**
 * Starts a front of windows at seeds.
 *
 * A curve sends straight fronts from its segments, and round ones from its points; so does the
 * border of a region. A vertex between segments sends none where these reach all round it: on
 * either side their angle is no more than a half turn. Time O(k log k) for a curve of k points and
 * a region of k vertices.
 */
class SeedWindows
{
public:
  /** Both arguments must live as long as this. */
  SeedWindows(const TriangleMesh& mesh, WindowFront& front);

  /** Starts at a seed. @param number of the seed @return false when cancelled */
  bool start(const Seed& seed, Index number);

private:
  bool startCurve(const Seed& seed, Index number);
  bool startRegion(const Seed& seed, Index number);
  /** Whether paths start at a vertex in directions that no straight front beside it takes.
   * @param isSide  tells of a neighbour whether the edge to it belongs to the seed */
  template <class IsSide>
  bool sends(Index vertex, const IsSide& isSide) const;
  /** The angle at a vertex between two of its neighbours. */
  double angleAt(Index vertex, Index a, Index b) const;

  const TriangleMesh& Mesh;
  WindowFront& Front;
};

}

#endif

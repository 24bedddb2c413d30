// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathStraightener_h
#define geodesic_PathStraightener_h

#include "path/PathPoint.h"
#include "path/StripFunnel.h"
#include "path/WeightedMesh.h"

#include <optional>
#include <vector>

namespace geodesic
{

/**
 * Turns any path into one that is locally shortest: straight where the faces that it crosses are
 * laid flat, and through a vertex only where neither side of it is shorter, that is where the path
 * makes at least half a turn on both (at saddles, boundaries and barriers).
 *
 * The path is made shortest in its strip of faces; where it then bends at a vertex with less than
 * half a turn on one side, the strip is led round the vertex on that side, until there is no such
 * vertex. Every step shortens the path. After S.-Q. Xin, G.-J. Wang, Efficiently determining a
 * locally exact shortest path on polyhedral surfaces, Computer-Aided Design 39 (2007); the turn is
 * sought in the graph of directions round the vertex, so that boundaries and edges with more than
 * two faces need no case of their own.
 */
class PathStraightener
{
public:
  /** @param weighted its costs play no part: on a surface of varying cost shortest is not straight
   */
  explicit PathStraightener(const WeightedMesh& weighted)
    : Surface(weighted)
  {
  }

  /** @return a path with the same ends, no longer than @p path */
  SurfacePath straightened(const SurfacePath& path) const;

private:
  /** The path shortened in its own strips. */
  std::vector<StraightPiece> tautPieces(const SurfacePath& path) const;
  /** Two pieces that join at a vertex, led round it; none where that is not shorter. */
  std::optional<std::vector<StraightPiece>> ledRound(
    const StraightPiece& piece, const StraightPiece& next) const;

  const WeightedMesh& Surface;
};

}

#endif

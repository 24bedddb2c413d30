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
 * Turns any path into one that is locally shortest. Such a path is straight if the faces that it
 * crosses are laid flat. It passes through a vertex only if neither side of the vertex is shorter:
 * if the angle between its two parts is at least 180 degrees on both sides (at saddles, boundaries
 * and barriers).
 *
 * The path is made shortest in its strip of faces. Where it then bends at a vertex with an angle
 * below 180 degrees on one side, the strip is led round the vertex on that side, until there is no
 * such vertex. Every step shortens the path. After S.-Q. Xin, G.-J. Wang, Efficiently determining a
 * locally exact shortest path on polyhedral surfaces, Computer-Aided Design 39 (2007). The smallest
 * angle is sought in the graph of directions round the vertex (VertexLink), so that boundaries and
 * edges with more than two faces need no case of their own.
 */
class PathStraightener
{
public:
  /** @param weighted mesh and barriers; its costs have no effect, since a shortest path through
   * varying cost is not straight */
  explicit PathStraightener(const WeightedMesh& weighted)
    : Surface(weighted)
  {
  }

  /** @return a path with the same ends, no longer than @p path */
  SurfacePath straightened(const SurfacePath& path) const;

private:
  /** The path, made shortest in the strips of faces between its vertices. */
  std::vector<StraightPiece> tautPieces(const SurfacePath& path) const;
  /** The path of two pieces that join at a vertex, led round the vertex; nothing if that is not
   * shorter. */
  std::optional<std::vector<StraightPiece>> ledRound(
    const StraightPiece& piece, const StraightPiece& next) const;

  const WeightedMesh& Surface;
};

}

#endif

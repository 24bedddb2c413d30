// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathStraightener_h
#define geodesic_PathStraightener_h

#include "path/PathPoint.h"
#include "path/StripFunnel.h"
#include "path/VertexLink.h"
#include "path/WeightedMesh.h"

#include <optional>
#include <utility>
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
 * locally exact shortest path on polyhedral surfaces, Computer-Aided Design 39 (2007). Each such
 * step lays two pieces of the path flat again, which adds up to much where both are long and bends
 * are many. After some work the rest is done at all bends at once, again and again. The smallest
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

  /** @return a path with the same ends, no longer than @p path
   * @throws SearchCancelled */
  SurfacePath straightened(const SurfacePath& path) const;

private:
  using Pieces = std::vector<StraightPiece>;

  /** The path, made shortest in the strips of faces between its vertices. */
  Pieces tautPieces(const SurfacePath& path) const;
  /** Leads a path round one vertex after the other. @return the path when it bends nowhere that can
   * be shortened, or when the work is over a limit, and which of the two it is */
  std::pair<Pieces, bool> ledRoundOneByOne(Pieces pieces) const;
  /** Leads a path round all vertices at once where it gets shorter, until it does so no more. It is
   * led round vertices as well that it passes in a straight line: a long row of them on a boundary
   * would else be left one by one. */
  Pieces ledRoundTogether(Pieces pieces) const;
  /** The faces round the vertex where two pieces join, on the side on which the path gets shorter;
   * nothing if there is none. */
  std::optional<std::vector<Triangle>> turnBetween(
    const StraightPiece& piece, const StraightPiece& next, VertexLink::Bend bend) const;
  /** The shortest path in a strip, or along the edge of both ends if there are no faces. */
  Pieces shortestOf(
    const PathPoint& start, const PathPoint& end, std::vector<Triangle> faces) const;
  /** The path of two pieces that join at a vertex, led round the vertex; nothing if that is not
   * shorter. */
  std::optional<Pieces> ledRound(const StraightPiece& piece, const StraightPiece& next) const;

  const WeightedMesh& Surface;
};

}

#endif

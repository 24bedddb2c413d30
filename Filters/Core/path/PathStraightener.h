// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathStraightener_h
#define geodesic_PathStraightener_h

#include "path/PathPoint.h"
#include "path/StripFunnel.h"
#include "path/VertexLink.h"
#include "path/WeightedMesh.h"

#include <list>
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
 * locally exact shortest path on polyhedral surfaces, Computer-Aided Design 39 (2007).
 *
 * They lead it round one vertex after the other, and lay the two pieces beside it flat again each
 * time. Here neighbouring vertices are gone round together, and all over the path before a second
 * time anywhere, so that pieces grow together in few rounds. A round costs only what lies between
 * the nearest vertices that stay. The smallest angle is sought in the graph of directions round the
 * vertex (VertexLink), so that boundaries and edges with more than two faces need no case of their
 * own.
 */
class PathStraightener
{
public:
  /** @param weighted mesh and barriers; its costs have no effect, since a shortest path through
   * varying cost is not straight */
  explicit PathStraightener(const WeightedMesh& weighted)
    : Surface(weighted)
    , Link(weighted)
  {
  }

  /** @return a path with the same ends, no longer than @p path
   * @throws SearchCancelled */
  SurfacePath straightened(const SurfacePath& path);

private:
  /** What is known of the vertex at the end of a piece. */
  enum class Joint
  {
    Unknown,
    /** No side of the vertex is shorter, or there is no next piece, or the piece is new. */
    Stays,
    /** The path bends to one side of the vertex, or runs straight through it. */
    Turns,
    /** The piece is no part of the path any more. */
    Gone
  };
  struct JoinedPiece
  {
    StraightPiece piece;
    Joint joint = Joint::Unknown;
    /** The faces round the vertex on the side to which the path turns. */
    std::vector<Triangle> turn{};
  };
  using Pieces = std::list<JoinedPiece>;
  using Place = Pieces::iterator;
  using Places = std::vector<Place>;

  /** The path, made shortest in the strips of faces between its vertices, and where it goes along
   * edges, once led round the vertices between these. */
  Pieces tautPieces(const SurfacePath& path);
  /**
   * Adds the edges that follow point @p first of a path, as far as the path turns at each vertex
   * between them: led round these vertices, or if that is no shorter, as one piece through them.
   * @return the number of the last point
   */
  std::size_t addEdges(Pieces& pieces, const SurfacePath& path, std::size_t first);
  /** Leads a path once round its vertices at some joints. @return the joints that are new, or
   * beside a piece that is new */
  Places ledRound(Pieces& pieces, const Places& joints);
  /** Whether the path gets shorter if it is led round the vertex at the end of a piece, or passes
   * it in a straight line: a long row of such vertices on a boundary would else be left one by one.
   */
  bool turns(Pieces& pieces, Place place);
  /** The strips of some pieces, led round the vertices between them. */
  Strip stripRound(Place first, Place last) const;
  /** Gives a strip without faces one in which both ends of its path lie. */
  void provideFace(Strip& strip, const PathPoint& start, const PathPoint& end) const;

  const WeightedMesh& Surface;
  VertexLink Link;
  /** Faces round a vertex; what it allocates stays. */
  std::vector<Triangle> Turn;
};

}

#endif

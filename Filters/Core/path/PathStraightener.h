// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathStraightener_h
#define geodesic_PathStraightener_h

#include "path/PathPoint.h"
#include "path/StripFunnel.h"
#include "path/VertexLink.h"
#include "path/WeightedMesh.h"

#include <list>
#include <optional>
#include <span>
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
 * time anywhere, so that pieces grow together in few rounds. The first round takes the path as it
 * comes. A round costs only what lies between the nearest vertices that stay. From the third round
 * on, the straight line between these is followed as well, over whatever faces it crosses (see
 * ChordWalk.h). The smallest angle is sought both ways round the vertex (VertexFan), or where an
 * edge has more than two faces, in the graph of directions (VertexLink).
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
  SurfacePath straightened(SurfacePath path);

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

  /** The beginning of a path, led round the vertices at which it turns. */
  struct Row
  {
    /** Whether it is a row of edges that is no longer than a straight line. */
    bool isStraight() const;

    PathPoint start;
    Strip strip{};
    /** The vertices that it is led round. */
    std::vector<Index> through{};
    bool isOfEdges = true;
    /** Of its edges. */
    double length = 0.0;
    /** Of all angles at vertices, how much less or more they are than 180 degrees. */
    double bend = 0.0;
  };

  /** The path, led round all vertices at which it turns, and made shortest in the strips between
   * the other ones. */
  Pieces tautPieces(const SurfacePath& path);
  /** Leads a row round the vertex @p through at which it ends, if the path turns there. @return
   * whether it does */
  bool leadRound(Row& row, const PathPoint& from, const PathPoint& through, const PathPoint& to);
  /** Adds the shortest path in the strip of a row. A straight row of edges is one piece, through
   * its vertices. */
  void addRow(Pieces& pieces, Row& row, const PathPoint& end) const;
  /** Leads a path once round its vertices at some joints. @return the joints that are new, or
   * beside a piece that is new */
  Places ledRound(Pieces& pieces, const Places& joints);
  /** The path in a strip, and then in the one along its chord as long as the path turns at all its
   * vertices and gets shorter.
   * @return nothing if it is no shorter than @p length */
  std::optional<std::vector<StraightPiece>> shorterPieces(
    Strip strip, const PathPoint& start, const PathPoint& end, double length);
  /** Whether the path turns at all vertices between some pieces. */
  bool doAllTurn(std::span<const StraightPiece> pieces);
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
  /** Of leading the path round its vertices. */
  int Round = 0;
  /** Faces round a vertex; what it allocates stays. */
  std::vector<Triangle> Turn;
};

}

#endif

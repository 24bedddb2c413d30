// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceTriangulation_h
#define geodesic_FaceTriangulation_h

#include "base/Index.h"
#include "base/PlanePoint.h"

#include <array>
#include <initializer_list>
#include <set>
#include <utility>
#include <vector>

namespace geodesic
{

/**
 * One face cut into pieces along segments: a constrained Delaunay triangulation of a triangle, with
 * points on its border and inside. Where a segment crosses another segment or an edge between
 * pieces, a point is added. Border points are placed by their order on the border, not by their
 * coordinates, so the faces on both sides of an edge are always cut alike there.
 *
 * A point inside is looked for from the last one on. So points that follow on each other, as those
 * of lines do, take a time that hardly depends on how many there are.
 */
class FaceTriangulation
{
public:
  /** @param corners counterclockwise; they become points 0, 1 and 2 */
  explicit FaceTriangulation(const std::array<PlanePoint, 3>& corners);

  /**
   * Adds a point on the border between two points that are neighbours on it.
   * @return its number
   * @throws std::logic_error if they are no neighbours on the border
   */
  Index addOnBorder(Index before, Index after, const PlanePoint& point);
  /** Adds a point inside. @return its number, or that of a point that is already at this place */
  Index addInside(const PlanePoint& point);
  /**
   * Makes the straight segment from one point to another run along edges.
   * @return the points along it, with both ends. Later segments may add points between them: call
   * it again when all segments are there, which changes nothing but returns all points.
   */
  std::vector<Index> addSegment(Index from, Index to);

  const std::vector<PlanePoint>& points() const { return this->Points; }
  std::vector<Triangle> triangles() const;

private:
  /** A triangle of the triangulation. Neighbour i is the piece over the side opposite to corner i;
   * NoIndex at the border. */
  struct Piece
  {
    Triangle corners;
    std::array<Index, 3> neighbours;
  };

  /** The piece in which a place is deepest: by rounding it may be outside all of them. */
  Index deepestAt(const PlanePoint& place) const;
  /** How far inside a piece a place is, negative outside, and the corner opposite to the side that
   * is nearest. */
  std::pair<double, int> depthIn(Index piece, const PlanePoint& place) const;
  /** The pieces that have a point as a corner, sorted. */
  std::vector<Index> piecesRound(Index point) const;
  /** Notes the corners of pieces that are new or have changed. */
  void note(std::initializer_list<Index> pieces);
  /** Whether the edge between two points is a part of a segment, which no flip removes. */
  bool isFixed(Index a, Index b) const;
  /** The number, 0 to 2, of the corner of a piece that is opposite to a neighbouring piece. */
  int cornerOpposite(Index piece, Index neighbour) const;
  /** The number of the corner of a piece that is a point; 3 if none is. */
  int cornerAt(Index piece, Index point) const;
  /** Replaces neighbour @p from of a piece by @p to. Does nothing for NoIndex. */
  void relink(Index piece, Index from, Index to);
  /** Cuts a piece into three at a point inside it. */
  void splitPiece(Index piece, Index point);
  /** Cuts the side opposite to a corner at a point, and so each piece beside it into two. */
  void splitSide(Index piece, int corner, Index point);
  /** Flips the sides opposite to @p point in @p pieces, and in those that flips make, until they
   * are Delaunay. */
  void legalize(std::vector<Index> pieces, Index point);
  /** Whether the side opposite to a corner may be flipped and is not Delaunay. */
  bool flipImproves(Index piece, int corner) const;
  /** Replaces the side opposite to a corner by the other diagonal of its two pieces. */
  void flip(Index piece, int corner);

  std::vector<PlanePoint> Points;
  std::vector<Piece> Pieces;
  /** For each point one of the pieces that have it. */
  std::vector<Index> PieceAt{ 0, 0, 0 };
  /** The piece where the last point was put. */
  Index LastPiece = 0;
  /** The edges that are parts of segments, smaller point first. */
  std::set<std::pair<Index, Index>> Fixed;
  /** Two places are one if they are not farther apart than this. */
  double Tolerance;
};

}

#endif

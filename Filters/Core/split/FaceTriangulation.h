// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceTriangulation_h
#define geodesic_FaceTriangulation_h

#include "base/Index.h"

#include <array>
#include <set>
#include <utility>
#include <vector>

namespace geodesic
{

/** A point in the plane of a face. */
struct PlanePoint
{
  double x = 0.0;
  double y = 0.0;
};

/**
 * One face cut up along segments: a constrained Delaunay triangulation of a triangle, with points
 * on its border and inside. Where a segment crosses another, or an edge in its way, a point is
 * added. Border points are placed by their order on the border, not by their coordinates, so that
 * the faces on both sides of an edge are always cut alike. Made for tens of points, not thousands:
 * O(n^2).
 */
class FaceTriangulation
{
public:
  /** Corners are points 0, 1 and 2, counterclockwise. */
  explicit FaceTriangulation(const std::array<PlanePoint, 3>& corners);

  /**
   * Adds a point on the border between two neighbours on it.
   * @return its number
   */
  Index addOnBorder(Index before, Index after, const PlanePoint& point);
  /** Adds a point inside. @return its number, or that of a point at the same place */
  Index addInside(const PlanePoint& point);
  /**
   * Makes the straight way from one point to another run along edges.
   * @return the points along it, both ends among them; more may come between them with later
   * segments, so ask again (an added segment changes nothing) when all are there
   */
  std::vector<Index> addSegment(Index from, Index to);

  const std::vector<PlanePoint>& points() const { return this->Points; }
  std::vector<Triangle> triangles() const;

private:
  /** Neighbour i is over the side opposite to corner i; NoIndex at the border. */
  struct Piece
  {
    Triangle corners;
    std::array<Index, 3> neighbours;
  };

  bool isFixed(Index a, Index b) const;
  int cornerOpposite(Index piece, Index neighbour) const;
  int cornerAt(Index piece, Index point) const;
  void relink(Index piece, Index from, Index to);
  /** Cuts a piece in three. */
  void splitPiece(Index piece, Index point);
  /** Cuts the side opposite to a corner, and so one piece or two in two each. */
  void splitSide(Index piece, int corner, Index point);
  /** Flips sides opposite to @p point until they are Delaunay. */
  void legalize(std::vector<Index> pieces, Index point);
  bool flipImproves(Index piece, int corner) const;
  void flip(Index piece, int corner);

  std::vector<PlanePoint> Points;
  std::vector<Piece> Pieces;
  std::set<std::pair<Index, Index>> Fixed;
  /** Length below which two places are one. */
  double Tolerance;
};

}

#endif

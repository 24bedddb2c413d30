// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Seed_h
#define geodesic_Seed_h

#include "base/Vector3.h"
#include "mesh/SurfacePoint.h"

#include <optional>
#include <utility>
#include <vector>

namespace geodesic
{

/** A source of distances. The number of a seed is its position in the list given to a solver. */
struct Seed
{
  enum class Kind
  {
    /** The seed is the one entry of Seed::points. */
    Point,
    /**
     * The seed is the straight segments from each entry of Seed::points to the next. A segment lies
     * inside a face or along an edge. Where the surface is in several pieces, one piece has all
     * points and the others none.
     */
    Curve,
    /** The seed is Seed::vertices, those on this piece of the surface, with the edges and faces
     * between them. */
    Region
  };

  static Seed atPoint(const SurfacePoint& point, double value = 0.0)
  {
    return { Kind::Point, { point }, {}, value, {} };
  }
  /** A point of a surface in several pieces; see Seed::position.
   * @param points the point where this piece has it, else none */
  static Seed atPosition(const Vector3& position, std::vector<SurfacePoint> points)
  {
    return { Kind::Point, std::move(points), {}, 0.0, position };
  }
  static Seed alongCurve(std::vector<SurfacePoint> points)
  {
    return { Kind::Curve, std::move(points), {}, 0.0, {} };
  }
  static Seed onRegion(std::vector<Index> vertices)
  {
    return { Kind::Region, {}, std::move(vertices), 0.0, {} };
  }

  Kind kind = Kind::Point;
  std::vector<SurfacePoint> points;
  std::vector<Index> vertices;
  /** Distance at the seed itself, at least 0, in the mesh's length unit (times the cost). */
  double value = 0.0;
  /**
   * For a point on a surface in several pieces: its position, the same on all of them. Pieces that
   * do not have the point have no points. If empty, the position is that of points[0].
   */
  std::optional<Vector3> position;
};

}

#endif

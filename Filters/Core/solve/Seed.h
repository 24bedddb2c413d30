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

/** A source of the front. Seeds are told apart by their position in the list given to a solver. */
struct Seed
{
  enum class Kind
  {
    /** The one entry of points. */
    Point,
    /**
     * The straight segments from each of points to the next, each inside a face or along an edge.
     * Of a surface in several pieces, one has all of them and the others none.
     */
    Curve,
    /** All of vertices, on this piece of the surface, and what lies between neighbours among them.
     */
    Region
  };

  static Seed atPoint(const SurfacePoint& point, double value = 0.0)
  {
    return { Kind::Point, { point }, {}, value, {} };
  }
  /** @param points on this piece of the surface, one or none */
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
   * Of a point on a surface in several pieces: where it is, the same for all of them. Those that
   * do not have the point itself have no points. Empty: where points[0] is.
   */
  std::optional<Vector3> position;
};

}

#endif

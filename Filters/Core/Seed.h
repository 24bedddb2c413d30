#ifndef geodesic_Seed_h
#define geodesic_Seed_h

#include "SurfacePoint.h"

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
    /** The straight segments from each of points to the next, each inside a face or along an edge.
     */
    Curve,
    /** All of vertices, and what lies between neighbours among them. */
    Region
  };

  static Seed atPoint(const SurfacePoint& point, double value = 0.0)
  {
    return { Kind::Point, { point }, {}, value };
  }
  static Seed alongCurve(std::vector<SurfacePoint> points)
  {
    return { Kind::Curve, std::move(points), {}, 0.0 };
  }
  static Seed onRegion(std::vector<Index> vertices)
  {
    return { Kind::Region, {}, std::move(vertices), 0.0 };
  }

  Kind kind = Kind::Point;
  std::vector<SurfacePoint> points;
  std::vector<Index> vertices;
  /** Distance at the seed itself, at least 0, in the mesh's length unit (times the cost). */
  double value = 0.0;
};

}

#endif

#ifndef geodesic_RingSweep_h
#define geodesic_RingSweep_h

#include "ClosedFans.h"
#include "EikonalUpdate.h"
#include "SeedFront.h"
#include "TriangleMesh.h"

#include <cmath>

namespace geodesic
{

/** The update for a front of a shape at cost @p w, which is constant in a triangle. */
template <FrontShape Shape>
inline double update(const FlatTriangle& t, double a, double b, double w)
{
  return Shape == FrontShape::Round ? w * pointSourceUpdate(t, a / w, b / w)
                                    : straightFrontUpdate(t, a, b, w);
}

/**
 * Updates the neighbours of @p vertex over the edges round it, after its own value fell to
 * @p value.
 * @param cost     of a triangle: UnitCost or VertexCost
 * @param valueOf  Index -> double: a neighbour's value, +infinity where it has none
 * @param propose  (Index, double) -> double: takes a new value if it counts; returns the value that
 *                 then holds
 * @param ceilingOf Index -> double: nothing at or above it is of interest to a neighbour
 */
template <FrontShape Shape, class Cost, class ValueOf, class CeilingOf, class Propose>
inline void sweepRing(const TriangleMesh& mesh, const ClosedFans& closed, const Cost& cost,
  Index vertex, double value, ValueOf&& valueOf, CeilingOf&& ceilingOf, Propose&& propose)
{
  struct Neighbour
  {
    Index index;
    Vector3 offset;
    double squaredLength;
    double length;
    double value;
  };
  const Vector3 centre = mesh.position(vertex);
  const auto look = [&](const RingEntry& entry) -> Neighbour
  {
    const Index index = entry.neighbour();
    const Vector3 offset = mesh.position(index) - centre;
    const double squared = dot(offset, offset);
    return { index, offset, squared, std::sqrt(squared), valueOf(index) };
  };

  const std::span<const RingEntry> ring = mesh.ring(vertex);
  Neighbour p{};
  bool follows = false;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    Neighbour q = look(ring[i]);
    if (follows)
    {
      const Vector3 side = q.offset - p.offset;
      const double squaredSide = dot(side, side);
      // A corner at or below both others, at an angle that is not obtuse, can gain nothing.
      const bool skipsP =
        p.value <= value && p.value <= q.value && p.squaredLength + squaredSide >= q.squaredLength;
      const bool skipsQ =
        q.value <= value && q.value <= p.value && q.squaredLength + squaredSide >= p.squaredLength;
      if (!skipsP || !skipsQ)
      {
        const double w = cost.ofTriangle(vertex, p.index, q.index);
        const double sideLength = std::sqrt(squaredSide);
        const double projection = dot(p.offset, q.offset);
        const double area = norm(cross(p.offset, q.offset));
        if (!skipsP)
        {
          const FlatTriangle flat{ q.length, projection / q.length, area / q.length, p.length,
            sideLength };
          if (updateLowerBound(flat, value, q.value, w) < ceilingOf(p.index, p.value))
          {
            p.value = propose(p.index, update<Shape>(flat, value, q.value, w));
          }
        }
        if (!skipsQ)
        {
          const FlatTriangle flat{ p.length, projection / p.length, area / p.length, q.length,
            sideLength };
          if (updateLowerBound(flat, value, p.value, w) < ceilingOf(q.index, q.value))
          {
            q.value = propose(q.index, update<Shape>(flat, value, p.value, w));
          }
        }
      }
    }
    p = q;
    follows = closed.isOpen(vertex, i);
  }
}

}

#endif

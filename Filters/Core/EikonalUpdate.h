#ifndef geodesic_EikonalUpdate_h
#define geodesic_EikonalUpdate_h

#include "Pair.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace geodesic
{

/**
 * One triangle laid flat: the edge from corner a to corner b of length c along the x axis, the
 * third corner v, to be updated, at (x, h).
 * @tparam Real  double, or Pair for two triangles at once
 */
template <class Real>
struct FlatTriangleOf
{
  /** Length of the edge. */
  Real c;
  /** Foot of v on the edge's line, from a. */
  Real x;
  /** Height of v over the edge, at least 0. */
  Real h;

  Real lengthFromA() const { return root(this->x * this->x + this->h * this->h); }
  Real lengthFromB() const
  {
    return root((this->c - this->x) * (this->c - this->x) + this->h * this->h);
  }
};
using FlatTriangle = FlatTriangleOf<double>;

/**
 * The least distance at v over the inside of the edge, where the distances @p a and @p b at its
 * ends define a flat point source whose straight line to v crosses the edge, or that lies on the
 * edge; +infinity where they don't. A part of pointSourceUpdate, which see.
 */
template <class Real>
inline Real pointSourceCrossing(
  const FlatTriangleOf<Real>& t, std::type_identity_t<Real> a, std::type_identity_t<Real> b)
{
  const Real none = Real() + std::numeric_limits<double>::infinity();
  const auto isTurned = b < a;
  const Real x = select(isTurned, t.c - t.x, t.x);
  const Real u = select(isTurned, a - b, b - a);
  const Real perEdge = 1.0 / t.c;
  const Real sum = a + b;
  // The source is at (sourceX, -sourceY), seen from the lower end.
  const Real sourceX = 0.5 * (t.c - u * sum * perEdge);
  const Real s = sum - t.c;
  const Real square = (sum + t.c) * s * (t.c + u) * (t.c - u);
  const Real sourceY = 0.5 * root(largest(square, Real())) * perEdge;
  const Real rise = sourceY + t.h;
  const Real run = x - sourceX;
  const Real crossing = sourceX * rise + run * sourceY;
  const auto isSource = u < t.c;
  const auto crosses = isSource & (crossing > 0.0) & (crossing < t.c * rise);
  Real found = select(crosses, root(run * run + rise * rise), none);
  if (const auto overlap = isSource & (s <= 0.0); any(overlap))
  {
    // The two discs overlap: the source lies on the edge, somewhere within them.
    const Real halfWidth = 0.5 * root(largest(-square, Real())) * perEdge;
    const Real within = largest(sourceX - halfWidth, least(sourceX + halfWidth, x));
    const Real p = largest(Real(), least(t.c, within));
    found = select(overlap, root((x - p) * (x - p) + t.h * t.h), found);
  }
  return found;
}

/**
 * Distance at v from distances @p a and @p b at the ends of the opposite edge: the minimum over the
 * points p of the edge of phi(p) + |p v|, where phi is the distance from the flat point source that
 * the two values define. A value of +infinity means that an end is not reached.
 *
 * The update is nondecreasing in a and in b, also where its clamps act, so that the field does not
 * depend on the order of a march; it is scale free from 1e-75 to 1e75 and right for triangles of
 * zero area. Where the values define no flat source (|b - a| >= c) the front comes along an edge.
 * Flat virtual sources: S. Novotni, R. Klein, Computing geodesic distances on triangular meshes,
 * WSCG (2002); the reduction to a minimum over the edge makes it monotone.
 */
inline double pointSourceUpdate(const FlatTriangle& t, double a, double b)
{
  return std::min({ a + t.lengthFromA(), b + t.lengthFromB(), pointSourceCrossing(t, a, b) });
}

/**
 * Like pointSourceCrossing for a straight front: over the inside of the edge, +infinity where none
 * of the front's straight ways to v crosses it.
 */
template <class Real>
inline Real straightFrontCrossing(const FlatTriangleOf<Real>& t, std::type_identity_t<Real> a,
  std::type_identity_t<Real> b, std::type_identity_t<Real> w)
{
  const Real none = Real() + std::numeric_limits<double>::infinity();
  const auto isTurned = b < a;
  const Real low = select(isTurned, b, a);
  const Real x = select(isTurned, t.c - t.x, t.x);
  const Real sine = select(isTurned, a - b, b - a) / (w * t.c);
  const Real cosine = root(largest((1.0 - sine) * (1.0 + sine), Real()));
  const Real crossing = x * cosine - sine * t.h;
  const auto crosses = (sine < 1.0) & (crossing > 0.0) & (crossing < t.c * cosine);
  return select(crosses, low + w * (sine * x + cosine * t.h), none);
}

/**
 * The update for a straight front, whose distance is linear along the edge: right beside a line of
 * sources, and nondecreasing in both values as well. @p w is the cost of a unit of length.
 * R. Kimmel, J. Sethian, Computing geodesic paths on manifolds, PNAS 95 (1998).
 */
inline double straightFrontUpdate(const FlatTriangle& t, double a, double b, double w = 1.0)
{
  return std::min(
    { a + w * t.lengthFromA(), b + w * t.lengthFromB(), straightFrontCrossing(t, a, b, w) });
}

}

#endif

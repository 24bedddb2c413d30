#ifndef geodesic_EikonalUpdate_h
#define geodesic_EikonalUpdate_h

#include <algorithm>
#include <cmath>

namespace geodesic
{

/**
 * One triangle laid flat: the edge from corner a to corner b of length c along the x axis, the
 * third corner v, to be updated, at (x, h).
 */
struct FlatTriangle
{
  /** Length of the edge. */
  double c;
  /** Foot of v on the edge's line, from a. */
  double x;
  /** Height of v over the edge, at least 0. */
  double h;
  /** Length from a to v. */
  double av;
  /** Length from b to v. */
  double bv;
};

/** The same triangle with the ends of the edge the other way round. */
inline FlatTriangle turned(const FlatTriangle& t)
{
  return { t.c, t.c - t.x, t.h, t.bv, t.av };
}

/**
 * A lower bound of every update of v over the edge, at cost @p w a unit of length: the distance on
 * the edge is w-Lipschitz, so nowhere on it less than (a + b - w c) / 2. Cheap, and most updates of
 * a march end here.
 */
inline double updateLowerBound(const FlatTriangle& t, double a, double b, double w = 1.0)
{
  const double low = std::min(a, b);
  const double high = std::min(std::max(a, b), low + w * t.c);
  return 0.5 * (low + high - w * t.c) + w * t.h;
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
  if (a > b)
  {
    return pointSourceUpdate(turned(t), b, a);
  }
  const double u = b - a;
  if (!(u < t.c))
  {
    return std::min(a + t.av, b + t.bv);
  }
  const double alongEdge = std::min(a + t.av, b + t.bv);
  // The source is at (sourceX, -sourceY).
  const double sourceX = 0.5 * (t.c - u * (a + b) / t.c);
  const double s = a + b - t.c;
  const double square = (a + b + t.c) * s * (t.c + u) * (t.c - u);
  if (s <= 0.0)
  {
    // The two discs overlap: the source lies on the edge, somewhere within them.
    const double halfWidth = std::sqrt(std::max(0.0, -square)) / (2.0 * t.c);
    const double p =
      std::clamp(std::clamp(t.x, sourceX - halfWidth, sourceX + halfWidth), 0.0, t.c);
    return std::min(alongEdge, std::sqrt((t.x - p) * (t.x - p) + t.h * t.h));
  }
  const double sourceY = std::sqrt(square) / (2.0 * t.c);
  const double rise = sourceY + t.h;
  const double run = t.x - sourceX;
  const double crossing = sourceX * rise + run * sourceY;
  if (crossing <= 0.0 || crossing >= t.c * rise)
  {
    return alongEdge;
  }
  return std::min(alongEdge, std::sqrt(run * run + rise * rise));
}

/**
 * The same for a straight front, whose distance is linear along the edge: right beside a line of
 * sources, and nondecreasing in both values as well. @p w is the cost of a unit of length.
 * R. Kimmel, J. Sethian, Computing geodesic paths on manifolds, PNAS 95 (1998).
 */
inline double straightFrontUpdate(const FlatTriangle& t, double a, double b, double w = 1.0)
{
  if (a > b)
  {
    return straightFrontUpdate(turned(t), b, a, w);
  }
  const double alongEdge = std::min(a + w * t.av, b + w * t.bv);
  const double sine = (b - a) / (w * t.c);
  if (!(sine < 1.0))
  {
    return alongEdge;
  }
  const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
  const double crossing = t.x * cosine - sine * t.h;
  if (crossing <= 0.0 || crossing >= t.c * cosine)
  {
    return alongEdge;
  }
  return std::min(alongEdge, a + w * (sine * t.x + cosine * t.h));
}

}

#endif

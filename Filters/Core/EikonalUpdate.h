#ifndef geodesic_EikonalUpdate_h
#define geodesic_EikonalUpdate_h

#include <algorithm>
#include <cmath>
#include <limits>

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

  double lengthFromA() const { return std::sqrt(this->x * this->x + this->h * this->h); }
  double lengthFromB() const
  {
    return std::sqrt((this->c - this->x) * (this->c - this->x) + this->h * this->h);
  }
};

/**
 * The least distance at v over the inside of the edge, where the distances @p a and @p b at its
 * ends define a flat point source whose straight line to v crosses the edge, or that lies on the
 * edge; +infinity where they don't. A part of pointSourceUpdate, which see.
 */
inline double pointSourceCrossing(const FlatTriangle& t, double a, double b)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  const bool isTurned = b < a;
  const double x = isTurned ? t.c - t.x : t.x;
  const double u = isTurned ? a - b : b - a;
  if (!(u < t.c))
  {
    return none;
  }
  const double perEdge = 1.0 / t.c;
  const double sum = a + b;
  // The source is at (sourceX, -sourceY), seen from the lower end.
  const double sourceX = 0.5 * (t.c - u * sum * perEdge);
  const double s = sum - t.c;
  const double square = (sum + t.c) * s * (t.c + u) * (t.c - u);
  if (s <= 0.0)
  {
    // The two discs overlap: the source lies on the edge, somewhere within them.
    const double halfWidth = 0.5 * std::sqrt(std::max(0.0, -square)) * perEdge;
    const double p = std::clamp(std::clamp(x, sourceX - halfWidth, sourceX + halfWidth), 0.0, t.c);
    return std::sqrt((x - p) * (x - p) + t.h * t.h);
  }
  const double sourceY = 0.5 * std::sqrt(square) * perEdge;
  const double rise = sourceY + t.h;
  const double run = x - sourceX;
  const double crossing = sourceX * rise + run * sourceY;
  return crossing > 0.0 && crossing < t.c * rise ? std::sqrt(run * run + rise * rise) : none;
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
inline double straightFrontCrossing(const FlatTriangle& t, double a, double b, double w = 1.0)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  const bool isTurned = b < a;
  const double low = isTurned ? b : a;
  const double x = isTurned ? t.c - t.x : t.x;
  const double sine = (isTurned ? a - b : b - a) / (w * t.c);
  if (!(sine < 1.0))
  {
    return none;
  }
  const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
  const double crossing = x * cosine - sine * t.h;
  return crossing > 0.0 && crossing < t.c * cosine ? low + w * (sine * x + cosine * t.h) : none;
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

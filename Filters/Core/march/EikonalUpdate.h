// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EikonalUpdate_h
#define geodesic_EikonalUpdate_h

#include "base/Lanes.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace geodesic
{

/**
 * A triangle as the update of its corner v over the edge from corner a to corner b sees it: by
 * products of that edge e and the side s from a to v, which take no roots.
 * @tparam Real  double, or Pair or Quad for several triangles at once
 */
template <class Real>
struct FlatTriangleOf
{
  /** e e */
  Real squaredEdge;
  /** e s: the edge times how far along its line the foot of v is, from a. */
  Real product;
  /** (e x s)^2: the square of the edge times the height of v over it. */
  Real squaredArea;

  Real lengthFromA() const { return this->length(this->product); }
  Real lengthFromB() const { return this->length(this->squaredEdge - this->product); }

private:
  Real length(Real along) const
  {
    return root((along * along + this->squaredArea) / this->squaredEdge);
  }
};
using FlatTriangle = FlatTriangleOf<double>;

/** The square of a number, with its sign: grows with the number. */
template <class Real>
GEODESIC_INLINED Real signedSquare(Real x)
{
  return x * largest(x, -x);
}

/**
 * The least distance at v over the inside of the edge, where the distances @p a and @p b at its
 * ends define a flat point source whose straight line to v crosses the edge, or that lies on the
 * edge; +infinity where they don't. A part of pointSourceUpdate, which see.
 */
template <class Real>
GEODESIC_INLINED Real pointSourceCrossing(
  const FlatTriangleOf<Real>& t, std::type_identity_t<Real> a, std::type_identity_t<Real> b)
{
  const Real none = Real() + std::numeric_limits<double>::infinity();
  const Real square = t.squaredEdge;
  const Real perSquare = 1.0 / square;
  const Real sum = a + b;
  const Real rise = b - a;
  // Above 0 where there is a source, and where it is off the edge's line.
  const Real within = square - rise * rise;
  const Real beyond = sum * sum - square;
  // The squares of the source's depth below the edge and of the height of v over it; the edge times
  // how far along its line the source is.
  const Real depth = largest(0.25 * within * beyond, Real()) * perSquare;
  const Real height = t.squaredArea * perSquare;
  const Real source = 0.5 * (square - rise * sum);
  // The line from the source to v meets the edge's line between its ends, where source * height +
  // product * depth, without the squares, is above 0, and the same seen from the other end.
  const auto isSource = within > 0.0;
  const auto crosses = both(isSource,
    both(signedSquare(source) * height + signedSquare(t.product) * depth > 0.0,
      signedSquare(square - source) * height + signedSquare(square - t.product) * depth > 0.0));
  const Real run = t.product - source;
  Real found = select(
    crosses, root(run * run * perSquare + (depth + height + 2.0 * root(depth * height))), none);
  if (const auto overlap = both(isSource, beyond <= 0.0); any(overlap))
  {
    // The discs of radius a and b round the ends meet in a point at most: the source lies on the
    // edge, somewhere between them.
    const Real halfWidth = 0.5 * root(largest(-within * beyond, Real()));
    const Real inside = largest(source - halfWidth, least(source + halfWidth, t.product));
    const Real off = t.product - largest(Real(), least(square, inside));
    found = select(overlap, root((off * off + t.squaredArea) * perSquare), found);
  }
  return found;
}

/**
 * Distance at v from distances @p a and @p b at the ends of the opposite edge: the minimum over the
 * points p of the edge of phi(p) + |p v|, where phi is the distance from the flat point source that
 * the two values define. A value of +infinity means that an end is not reached.
 *
 * The update is nondecreasing in a and in b, also where its clamps act, so that the field does not
 * depend on the order of a march; it is scale free from 1e-50 to 1e50 and right for triangles of
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
GEODESIC_INLINED Real straightFrontCrossing(const FlatTriangleOf<Real>& t,
  std::type_identity_t<Real> a, std::type_identity_t<Real> b, std::type_identity_t<Real> w)
{
  const Real none = Real() + std::numeric_limits<double>::infinity();
  const Real edge = root(t.squaredEdge);
  const Real perEdge = 1.0 / edge;
  const Real foot = t.product * perEdge;
  const Real height = root(t.squaredArea) * perEdge;
  const auto isTurned = b < a;
  const Real low = select(isTurned, b, a);
  const Real x = select(isTurned, edge - foot, foot);
  const Real sine = select(isTurned, a - b, b - a) / (w * edge);
  const Real cosine = root(largest((1.0 - sine) * (1.0 + sine), Real()));
  const Real crossing = x * cosine - sine * height;
  const auto crosses = both(sine < 1.0, both(crossing > 0.0, crossing < edge * cosine));
  return select(crosses, low + w * (sine * x + cosine * height), none);
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

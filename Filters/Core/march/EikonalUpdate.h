// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EikonalUpdate_h
#define geodesic_EikonalUpdate_h

#include "base/Lanes.h"

#include <algorithm>
#include <limits>
#include <type_traits>

/**
 * @file
 * The local update of fast marching: a value for corner v of a triangle from the values at its
 * corners a and b. Crossings are computed in this file only. ReferenceSolver calls
 * pointSourceUpdate() and straightFrontUpdate(); NeighbourUpdate calls the two crossings, for
 * several triangles at once, and computes the part along the edges itself.
 * Plugin/Documentation/algorithm.md derives the formula.
 *
 * A new formula must be nondecreasing in both values. These places assume more about it and must be
 * looked at when it changes; h is the height of v over the edge, c the edge's length and w the cost
 * (Plugin/Documentation/architecture.md, "Where to change what", says what each one assumes):
 *
 *  - march/TriangleSlack.h, computed in march/TriangleMeasure.cxx: a crossing gives
 * at least (a + b + w (2 h - c)) / 2
 *  - march/CandidateScan.h, Judgement::add: the same bound, and when an edge can gain anything
 *  - march/NeighbourUpdate.h, valueAlong and edgeCost, and update in march/ReferenceSolver.cxx: the
 *    part along edges; crossEdges, and the same update: how the cost enters
 *  - solve/Detours.h: where a + b < w c the point source update forgets both
 *  - march/NeighbourUpdate.h, crossEdges: a crossing is +infinity where the edge has no length or
 * an end has no value
 *  - march/LabelMargin.h: how far values of a label differ at the ends of an edge, and how an error
 *    spreads
 *  - march/SourceFront.h, StraightLineBound: values are lengths times cost
 *  - march/TriangleCost.h, reach: a crossing gives at least the larger of a and b, minus w c
 *  - solve/MarchControl.h: rounding errors are below a relative gain of 1e-12
 *  - solve/SeedFront.cxx and CostedStart.cxx: start values are straight lengths
 *  - mesh/SurfacePoint.h, snapped: how close to an edge a source may lie
 *  - path/BestStep.h, FlatSource, leastOfStraight and tryEdge: the inverse of the crossing;
 *    tryVertex, and seedsNear in path/PathTracer.cxx: that of the part along edges
 *  - path/EdgePathSearch.cxx: no path along edges is shorter than the field says
 *  - path/PathFinder.cxx, cornersOffThePath: values are comparable with straight lengths
 */

namespace geodesic
{

/**
 * The shape of a triangle, as needed to update its corner v over the edge from corner a to corner
 * b: products of that edge e and the side s from a to v, which take no square roots.
 * @tparam Real  double, or Pair or Quad for several triangles at once
 */
template <class Real>
struct FlatTriangleOf
{
  /** e · e: the square of the edge's length. */
  Real squaredEdge;
  /** e · s: the edge's length times the position of v's foot on the edge's line, from a. */
  Real product;
  /** (e x s)²: the square of the edge's length times the height of v over it. */
  Real squaredArea;

  /** The lengths of the sides from a and from b to v. */
  Real lengthFromA() const { return this->length(this->product); }
  Real lengthFromB() const { return this->length(this->squaredEdge - this->product); }

private:
  Real length(Real along) const
  {
    return root((along * along + this->squaredArea) / this->squaredEdge);
  }
};
using FlatTriangle = FlatTriangleOf<double>;

/** The square of a number, with the number's sign. It grows with the number. */
template <class Real>
GEODESIC_INLINED Real signedSquare(Real x)
{
  return x * largest(x, -x);
}

/**
 * The part of pointSourceUpdate() that crosses the inside of the edge.
 * @param a, b  distances at the ends of the edge, for cost 1; +infinity where one has none
 * @return the distance at v, if a and b define a flat point source that lies on the edge or whose
 *         straight line to v crosses it; +infinity otherwise
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
  // `within` is above 0 if there is a source, `beyond` if the source is off the edge's line.
  const Real within = square - rise * rise;
  const Real beyond = sum * sum - square;
  // The squares of the source's depth below the edge and of the height of v over it, and the edge's
  // length times the source's position along its line.
  const Real depth = largest(0.25 * within * beyond, Real()) * perSquare;
  const Real height = t.squaredArea * perSquare;
  const Real source = 0.5 * (square - rise * sum);
  // With roots instead of squares, the line from the source to v meets the edge's line between its
  // ends if source * height + product * depth is above 0, and so is the same from the other end.
  // Signed squares give the same answer without roots.
  const auto isSource = within > 0.0;
  const auto crosses = both(isSource,
    both(signedSquare(source) * height + signedSquare(t.product) * depth > 0.0,
      signedSquare(square - source) * height + signedSquare(square - t.product) * depth > 0.0));
  const Real run = t.product - source;
  Real found = select(
    crosses, root(run * run * perSquare + (depth + height + 2.0 * root(depth * height))), none);
  if (const auto overlap = both(isSource, beyond <= 0.0); any(overlap))
  {
    // The circles of radius a and b round the ends don't cross, so no point of the plane has these
    // distances. The source counts as an interval of the edge, at distance 0.
    const Real halfWidth = 0.5 * root(largest(-within * beyond, Real()));
    const Real inside = largest(source - halfWidth, least(source + halfWidth, t.product));
    const Real off = t.product - largest(Real(), least(square, inside));
    found = select(overlap, root((off * off + t.squaredArea) * perSquare), found);
  }
  return found;
}

/**
 * The update for a round front: the distance at v from the distances at the ends of the opposite
 * edge. It is the minimum over the points p of the edge of phi(p) + |p v|, where phi is the
 * distance from the flat point source that the two values define. Where they define none (|b - a|
 * >= c) the front comes along an edge.
 *
 * The update is nondecreasing in a and in b, also where its clamps act, so the field does not
 * depend on the order of a march. It is scale free from 1e-50 to 1e50 and right for triangles of
 * zero area. Flat virtual sources: S. Novotni, R. Klein, Computing geodesic distances on triangular
 * meshes, WSCG (2002); the reduction to a minimum over the edge makes it monotone.
 * @param a, b  distances at the ends of the edge, for cost 1; +infinity where one has none. Under a
 *              cost w the update is w times that of a / w and b / w.
 */
inline double pointSourceUpdate(const FlatTriangle& t, double a, double b)
{
  return std::min({ a + t.lengthFromA(), b + t.lengthFromB(), pointSourceCrossing(t, a, b) });
}

/**
 * The part of straightFrontUpdate() that crosses the inside of the edge.
 * @param a, b  distances at the ends of the edge; +infinity where one has none
 * @param w     cost of a unit of length
 * @return the distance at v; +infinity if the front's straight line to v does not cross the edge
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
 * The same for round fronts in bypassed triangles (see solve/Detours.h), and no less than the value
 * of either end. Where triangles are thin, vertices would else lower one another for very long,
 * each time by less.
 */
template <class Real>
GEODESIC_INLINED Real bypassedCrossing(const FlatTriangleOf<Real>& t, std::type_identity_t<Real> a,
  std::type_identity_t<Real> b, std::type_identity_t<Real> w)
{
  return largest(straightFrontCrossing<Real>(t, a, b, w), largest(a, b));
}

/**
 * The update for a straight front, whose distance is linear along the edge: exact beside a line of
 * sources, and nondecreasing in both values as well.
 * R. Kimmel, J. Sethian, Computing geodesic paths on manifolds, PNAS 95 (1998).
 * @param a, b  distances at the ends of the edge; +infinity where one has none
 * @param w     cost of a unit of length
 */
inline double straightFrontUpdate(const FlatTriangle& t, double a, double b, double w = 1.0)
{
  return std::min(
    { a + w * t.lengthFromA(), b + w * t.lengthFromB(), straightFrontCrossing(t, a, b, w) });
}

/** The update for a round front in a bypassed triangle; nondecreasing in both values as well. */
inline double bypassedUpdate(const FlatTriangle& t, double a, double b, double w)
{
  return std::min(
    { a + w * t.lengthFromA(), b + w * t.lengthFromB(), bypassedCrossing(t, a, b, w) });
}

}

#endif

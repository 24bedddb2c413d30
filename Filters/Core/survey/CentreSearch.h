// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CentreSearch_h
#define geodesic_CentreSearch_h

#include "base/Index.h"
#include "solve/SolveOptions.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace geodesic
{

class DistanceSolver;

/** The centre and the diameter of one part of a surface, among its vertices. A vertex's
 * *eccentricity* is its largest distance to another vertex of the part. */
struct PartExtent
{
  /** The vertex with the least eccentricity that was found, and that eccentricity. */
  Index centre = NoIndex;
  double radius = 0.0;
  /** No vertex has a smaller eccentricity than this. */
  double leastRadius = 0.0;
  /** The two vertices with the largest distance that was found, and that distance. */
  Index ends[2] = { NoIndex, NoIndex };
  double diameter = 0.0;
  /** No two vertices are farther apart than this. */
  double mostDiameter = 0.0;
  std::size_t numberOfVertices = 0;
  /** How many fields it took. */
  std::size_t numberOfFields = 0;
};

/** What to search for, and how well. */
struct CentreRequest
{
  /** A part is done when radius and diameter are known to this part of themselves. At least 0. */
  double error = 0.01;
  /** The most fields for a part; where they do not suffice, the bounds stay farther apart. At least
   * 1. */
  std::size_t mostFields = 100;
  /** Memory and tolerance, and barriers; the rest is not looked at. */
  SolveOptions options;
  /** Called now and then with the part of the work that is done, from 0 to 1. Returning false
   * cancels the search. */
  std::function<bool(double)> onProgress;
};

/**
 * Finds the centre and the diameter of each part of a surface in one piece.
 *
 * A field from a vertex v gives its eccentricity e, and by the triangle inequality bounds of all
 * others: that of a vertex at the distance d is at least max(d, e - d), and at most e + d. The next
 * field is in turn from the vertex whose lower bound is least, from the one whose upper bound is
 * largest, and from the vertex farthest from the last candidate of the centre; equal ones by
 * position (isBefore()). F. Takes, W. Kosters, Computing the eccentricity distribution of large
 * graphs, Algorithms 6 (2013).
 *
 * The bounds hold as far as the solver's distances do: with errors of its own, radius and diameter
 * are right to about these.
 *
 * @return the parts, the first by position of their vertices first; none if cancelled
 * @throws std::invalid_argument for an error below 0 or no field
 * Time: the fields, and O(number of vertices of the part) for each.
 */
std::vector<PartExtent> findCentres(DistanceSolver& solver, const CentreRequest& request);

}

#endif

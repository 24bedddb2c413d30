// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_Promises_h
#define geodesic_testing_Promises_h

#include <cstddef>
#include <string>
#include <vector>

namespace geodesic::testing
{

struct NastyCase;

/** What checkPromises() has done and found. */
struct PromiseReport
{
  std::size_t cases = 0;
  /** Surfaces that were refused, with a message that names a point or the limit. */
  std::size_t refusedSurfaces = 0;
  std::size_t solves = 0;
  /** Requests that a solver refused, with a message. */
  std::size_t refusedRequests = 0;
  /** Runs that ended at the budget of updates, with a message. */
  std::size_t budgetsReached = 0;
  /** Fields whose front settled only roughly, which they say (DistanceField::raisedGain()). */
  std::size_t roughFields = 0;
  std::size_t paths = 0;
  /** Comparisons of numbers. */
  std::size_t comparisons = 0;
  /** The most windows and other steps of a run (WorkCount). */
  std::size_t mostSteps = 0;
  /** Promises that were broken. */
  std::vector<std::string> broken;
};

/**
 * Runs every solver on a case and holds the fields to what is promised of them:
 * - a run ends, within a count of work, in a field or in an exception with a message;
 * - distances are numbers of at least 0 and the straight line times the least cost (VirtualSources:
 *   1e-3 less); all solvers reach the same vertices;
 * - without costs none is longer than Dijkstra's, and all but VirtualSources differ along an edge
 * by no more than its length;
 * - Bounded is within its tolerance of Exact; FastMarching and Reference give one field, to 1e-7 of
 *   the largest distance from one seed, 1e-6 from several, 1e-2 with costs; unless one of them says
 *   that its front settled only roughly;
 * - the same solver, run again, gives the same numbers (every fourth case);
 * - Dijkstra and Exact give the same distance from both ends;
 * - a surface with its points and triangles in another order, in other axes, and twice as large has
 *   the same field;
 * - paths begin and end where they should, every point of them lies on the surface, and their
 *   lengths are those of the field (Dijkstra, Exact).
 */
void checkPromises(const NastyCase& test, PromiseReport& report);

}

#endif

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Detours_h
#define geodesic_Detours_h

#include "base/Index.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace geodesic
{

class ClosedTriangles;
class Partition;
class TriangleMesh;
struct SolveOptions;

/**
 * Finds triangles that are dear beside a way round them. Two ends of an edge in a dear part of the
 * surface can be nearer to each other by way of a cheap part than along the edge. Their distances a
 * and b from a source then can sum up to less than the edge's length times the cost. To an update
 * that knows no more than a and b, the source seems to lie on the edge, and the distance to be 0
 * there, however large a and b are. So fronts cross such triangles as straight ones, whose distance
 * on an edge is between those of its ends (bypassedUpdate() in march/EikonalUpdate.h). Which
 * triangles these are is fixed before the march.
 *
 * A *detour* at a vertex costs for each unit of length what some other vertex costs, and the way
 * there, over the longest side here, 0.7 times what it costs. A triangle is bypassed if its cost is
 * more than 1.6 times that of the cheapest detour of its corners. Where the costs at a distance of
 * some longest side are nearly the same, no triangle is.
 */
class Detours
{
public:
  /** No triangle is bypassed. */
  Detours() = default;
  /**
   * Time O(n log n) at worst, O(n) where costs are smooth. Collective.
   * @param longestSides  one for each vertex; these and the costs are the same on all pieces that
   *                      share a vertex
   * @param closed, options  no way leads along what they close; with the cost of each vertex
   */
  Detours(const TriangleMesh& mesh, std::span<const float> longestSides,
    const ClosedTriangles& closed, const SolveOptions& options, Partition& partition);

  /** Whether there can be bypassed triangles. Where the costs of neighbours differ by less than a
   * quarter everywhere, none is looked for. @param largestJump  how many times as dear as a
   * neighbour a vertex is at most */
  static bool mayBypass(double largestJump) { return largestJump > 1.25; }

  /** Has fronts cross all triangles at some vertices as bypassed ones, until this is called again
   * for others. */
  void bypassAt(std::span<const Index> vertices);

  /** The largest cost of a triangle at a vertex that is not bypassed for the vertex's detours. */
  double limit(Index vertex) const { return std::abs(this->Limits[vertex]); }
  bool isEmpty() const { return this->Limits.empty(); }
  /** Whether the triangle of three vertices is bypassed. @param cost of the triangle */
  bool isBypassed(double cost, Index a, Index b, Index c) const
  {
    return !this->isEmpty() && cost > std::min({ this->limit(a), this->limit(b), this->limit(c) });
  }
  /** The same, and also where bypassAt() says so. @pre !isEmpty() */
  bool isCrossedAsBypassed(double cost, Index a, Index b, Index c) const
  {
    return cost > std::min({ this->Limits[a], this->Limits[b], this->Limits[c] });
  }

private:
  /** Below 0 at the vertices of bypassAt(). */
  std::vector<double> Limits;
  std::vector<Index> AtSeeds;
};

}

#endif

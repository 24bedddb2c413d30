// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleCost_h
#define geodesic_TriangleCost_h

#include "base/Platform.h"
#include "march/BucketQueue.h"
#include "mesh/TriangleMesh.h"
#include "solve/Detours.h"
#include "solve/Partition.h"
#include "solve/SolveOptions.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

namespace geodesic
{

/** The cost 1 of every triangle: distances are lengths. */
class UnitCost
{
public:
  static constexpr bool isUnit = true;

  /** @param margins one for each vertex, see UpdateBounds; must live as long as this object */
  UnitCost(const TriangleMesh& mesh, std::span<const float> margins, const Partition& partition)
    : LongestSides(partition.isDivided() ? partition.longestSides() : mesh.rings().longestSides())
    , Margins(margins)
  {
  }

  double ofVertex(Index) const { return 1.0; }
  /** The cost of the triangle of three vertices. */
  constexpr double ofTriangle(Index, Index, Index) const { return 1.0; }
  /** The same from the costs of the vertices, of one or of several triangles at once. */
  template <class Real>
  GEODESIC_INLINED static Real ofTriangles(Real, Real, Real)
  {
    return Real() + 1.0;
  }
  /** Whether there are triangles that round fronts cross as straight ones, see Detours. */
  static constexpr bool hasDetours() { return false; }
  /** Whether the triangle of three vertices is one of them. @param cost of the triangle */
  static constexpr bool isBypassed(double, Index, Index, Index) { return false; }
  /** How far a value at a vertex can lie above values that it leads to at its neighbours: the
   * longest side of the triangles round it, times the largest cost there. */
  double reach(Index vertex) const { return this->LongestSides[vertex]; }
  /** How much a label's value at a vertex may exceed the best one there and be kept; see
   * labelMargin(). */
  double margin(Index vertex) const { return this->Margins[vertex]; }
  std::span<const float> longestSides() const { return this->LongestSides; }
  /** Has the processor fetch a margin that is soon to be read. */
  GEODESIC_INLINED void prefetchMargin(Index vertex) const
  {
    prefetchToRead(&this->Margins[vertex]);
  }
  /** The mean, the smallest and the largest cost of the vertices. */
  double mean() const { return 1.0; }
  /** What most vertices cost at least. */
  double typical() const { return 1.0; }
  double smallest() const { return 1.0; }
  double largest() const { return 1.0; }
  /** The order of a queue that suits these costs; the same on all pieces. */
  QueueOrder queueOrder() const { return QueueOrder::ByBucket; }
  /** Whether the costs of neighbours differ so much that an update may forget its values, see
   * VertexCost; the same on all pieces. */
  bool jumps() const { return false; }

private:
  std::span<const float> LongestSides;
  std::span<const float> Margins;
};

/** A cost for each vertex. The cost of a triangle is the mean of its corners' costs. The functions
 * are those of UnitCost. Construction takes time O(n). */
class VertexCost
{
public:
  static constexpr bool isUnit = false;

  /** @param margins  one for each vertex, as the costs of @p options; both must live as long as
   *                  this object
   * @param closed, options  the barriers
   * @param partition  the pieces agree on what they share; collective */
  VertexCost(const TriangleMesh& mesh, std::span<const float> margins,
    const ClosedTriangles& closed, const SolveOptions& options, Partition& partition)
    : Cost(options.cost)
    , Length(mesh, margins, partition)
    , Dearest(options.cost.size())
  {
    const std::span<const double> cost = this->Cost;
    for (Index v = 0; v < cost.size(); ++v)
    {
      double dearest = cost[v];
      for (const RingEntry& entry : mesh.ring(v))
      {
        dearest = std::max(dearest, cost[entry.neighbour()]);
      }
      this->Dearest[v] = dearest;
      this->LargestJump = std::max(this->LargestJump, dearest / cost[v]);
      this->Sum += cost[v];
      this->SumOfInverses += 1.0 / cost[v];
      this->Smallest = std::min(this->Smallest, cost[v]);
      this->Largest = std::max(this->Largest, cost[v]);
    }
    this->agree(partition);
    if (Detours::mayBypass(this->LargestJump))
    {
      this->Ways = Detours(mesh, this->Length.longestSides(), closed, options, partition);
    }
  }

  double ofTriangle(Index a, Index b, Index c) const
  {
    return ofTriangles(this->Cost[a], this->Cost[b], this->Cost[c]);
  }
  double ofVertex(Index vertex) const { return this->Cost[vertex]; }
  template <class Real>
  GEODESIC_INLINED static Real ofTriangles(Real a, Real b, Real c)
  {
    return (a + b + c) / 3.0;
  }
  bool hasDetours() const { return !this->Ways.isEmpty(); }
  bool isBypassed(double cost, Index a, Index b, Index c) const
  {
    return this->hasDetours() && this->Ways.isCrossedAsBypassed(cost, a, b, c);
  }
  const Detours& detours() const { return this->Ways; }
  /** See Detours. @pre costs jump at these vertices, if there are any */
  void bypassAt(std::span<const Index> vertices) { this->Ways.bypassAt(vertices); }
  double reach(Index vertex) const { return this->Dearest[vertex] * this->Length.reach(vertex); }
  double margin(Index vertex) const { return this->Dearest[vertex] * this->Length.margin(vertex); }
  GEODESIC_INLINED void prefetchMargin(Index vertex) const
  {
    prefetchToRead(&this->Dearest[vertex]);
    this->Length.prefetchMargin(vertex);
  }
  /** The mean of the costs on this piece; 1 if it has no vertices. */
  double mean() const
  {
    return this->Cost.empty() ? 1.0 : this->Sum / static_cast<double>(this->Cost.size());
  }
  /** The mean; where costs are spread the harmonic one, as most vertices are cheaper than the mean
   * by far. */
  double typical() const
  {
    return this->Order == QueueOrder::ByBucket || this->Cost.empty()
      ? this->mean()
      : static_cast<double>(this->Cost.size()) / this->SumOfInverses;
  }
  /** The smallest cost on all pieces of the surface. */
  double smallest() const { return this->Smallest; }
  /** The largest cost on this piece. */
  double largest() const { return this->Largest; }
  QueueOrder queueOrder() const { return this->Order; }
  /**
   * Whether a vertex somewhere is more than MostOfSmooth times as dear as a neighbour. With a and b
   * at the ends of an edge of length c, the point source update at a cost w forgets both if
   * a + b < c w. Farther than three edges from the source, outside the disc of CostedStart.h, a and
   * b are at least three edges at the costs there. So as long as costs do not jump, and edges are
   * about equally long, a + b is more than c w. Where the disc ends earlier, and where costs jump,
   * most such triangles are bypassed (see Detours), but not all.
   */
  bool jumps() const { return this->LargestJump > MostOfSmooth; }

private:
  static constexpr double MostOfSmooth = 4.0;
  /** Where the mean cost is so many times the harmonic mean, most vertices are so much cheaper than
   * the mean that they would share a few buckets. */
  static constexpr double MostSpread = 8.0;

  /** Raises Dearest at shared vertices to the largest of all pieces, LargestJump to that of all,
   * lowers Smallest to the least of all, and chooses the order by the costs of all vertices. */
  void agree(Partition& partition)
  {
    std::vector<StartValue> own;
    for (Index vertex : partition.sharedVertices())
    {
      own.push_back({ vertex, 0, this->Dearest[vertex], false });
    }
    for (const StartValue& other : partition.exchange(own))
    {
      this->Dearest[other.vertex] = std::max(this->Dearest[other.vertex], other.value);
    }
    // Vertices that several pieces share count once, so that the order is that of one piece.
    std::array ownSums{ static_cast<double>(this->Cost.size()), this->Sum, this->SumOfInverses,
      this->Smallest, this->LargestJump };
    for (const Index vertex : partition.sharedVertices())
    {
      if (!partition.owns(vertex))
      {
        ownSums[0] -= 1.0;
        ownSums[1] -= this->Cost[vertex];
        ownSums[2] -= 1.0 / this->Cost[vertex];
      }
    }
    const std::vector<double> all = partition.gather(ownSums);
    std::array sums{ 0.0, 0.0, 0.0 };
    for (std::size_t i = 0; i < all.size(); i += ownSums.size())
    {
      for (std::size_t j = 0; j < sums.size(); ++j)
      {
        sums[j] += all[i + j];
      }
      this->Smallest = std::min(this->Smallest, all[i + 3]);
      this->LargestJump = std::max(this->LargestJump, all[i + 4]);
    }
    const auto [count, sum, sumOfInverses] = sums;
    this->Order =
      sum * sumOfInverses > MostSpread * count * count ? QueueOrder::ByValue : QueueOrder::ByBucket;
  }

  std::span<const double> Cost;
  UnitCost Length;
  /** Empty if costs hardly change from vertex to vertex. */
  Detours Ways;
  /** The largest cost among a vertex and its neighbours. */
  std::vector<double> Dearest;
  double Sum = 0.0;
  double SumOfInverses = 0.0;
  double Smallest = std::numeric_limits<double>::infinity();
  double Largest = 0.0;
  /** The largest of the costs of neighbours in proportion. */
  double LargestJump = 1.0;
  QueueOrder Order = QueueOrder::ByBucket;
};

}

#endif

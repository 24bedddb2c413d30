// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DistanceField_h
#define geodesic_DistanceField_h

#include "base/BulkVector.h"
#include "base/Index.h"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

namespace geodesic
{

/** Why a solver's run ended. */
enum class StopReason
{
  /** Every vertex that can be reached was. */
  Exhausted,
  /** Every vertex within SolveOptions::maximumDistance was reached. */
  MaximumDistance,
  /** The distances of SolveOptions::targets are final. */
  Targets,
  /** SolveOptions::onProgress returned false; the distances are not final. */
  Cancelled
};

/**
 * Distances at the vertices of a mesh, in its length unit times the cost. A solver owns its field
 * and writes the next one into it. Only the vertices that the last front reached are reset, so that
 * the time of a bounded run on a large mesh depends on what its front reaches, not on the mesh.
 */
class DistanceField
{
public:
  static constexpr double Unreached = std::numeric_limits<double>::infinity();

  explicit DistanceField(Index numberOfVertices)
    : Distances(numberOfVertices, Unreached)
    , NearestSeeds(numberOfVertices, NoIndex)
  {
  }

  /** The distance of a vertex; Unreached where it has none. */
  double distance(Index vertex) const { return this->Distances[vertex]; }
  std::span<const double> distances() const { return this->Distances; }
  bool isReached(Index vertex) const { return this->Distances[vertex] < Unreached; }
  /** Number of the nearest seed, the smallest of equally near ones; NoIndex where unreached. */
  Index nearestSeed(Index vertex) const
  {
    if (this->OnlySeed != NoIndex)
    {
      return this->isReached(vertex) ? this->OnlySeed : NoIndex;
    }
    return this->NearestSeeds[vertex];
  }
  /** The vertices that have a distance, each once, in no particular order. */
  std::span<const Index> reached() const { return this->Reached; }
  double largestDistance() const { return this->LargestDistance; }
  StopReason stopReason() const { return this->Reason; }
  /** Whether vertices that lie elsewhere than towards the targets were left out, see
   * SolveOptions::onlyTowardsTargets. */
  bool leavesOutElsewhere() const { return this->LeavesOutElsewhere; }
  /** Whether these are distances over intrinsic triangles, see SolveOptions::isIntrinsic. */
  bool isIntrinsic() const { return this->IsIntrinsic; }
  /** Above 0 where the front settled only roughly (see MarchControl): a distance counted no longer
   * if it was lower by less than this part. Distances are less exact then, by more than this part,
   * and depend on the order of vertices. On several pieces this is that of the own one. */
  double raisedGain() const { return this->RaisedGain; }

  // The rest is for solvers.

  /** Makes all vertices unreached. */
  void reset();
  /** The distances, for several threads that set them together; noteReached() is to be called then.
   */
  std::span<double> sharedDistances() { return this->Distances; }
  /** Notes the vertices that got their first distance by sharedDistances(), each once in all lists;
   * then orderReached() is to be called. */
  void noteReached(std::span<const std::span<const Index>> lists);
  /** Notes what MarchControl::raisedGain() says; the largest counts until reset(). */
  void noteRaisedGain(double gain) { this->RaisedGain = std::max(this->RaisedGain, gain); }
  void setIntrinsic() { this->IsIntrinsic = true; }
  void setLeavesOutElsewhere(bool leavesOut) { this->LeavesOutElsewhere = leavesOut; }
  /** Sets a vertex's distance, for the first time or again, and adds the vertex to reached(). */
  void setDistance(Index vertex, double distance)
  {
    if (!this->isReached(vertex))
    {
      this->Reached.push_back(vertex);
    }
    this->Distances[vertex] = distance;
  }
  /** Sets the distance of a vertex that has one. */
  void lowerDistance(Index vertex, double distance) { this->Distances[vertex] = distance; }
  /** Sorts reached() by vertex if it is at least an eighth of the mesh: a loop over it then goes
   * through memory from front to back. */
  void orderReached();
  void setNearestSeed(Index vertex, Index seed)
  {
    this->spreadOnlySeed();
    this->NearestSeeds[vertex] = seed;
  }
  /** Sets the nearest seed of all vertices that are or get reached. @pre no vertex has one */
  void setNearestSeed(Index seed) { this->OnlySeed = seed; }
  /** Sets the entries of all reached vertices in @p values, one for each vertex, to @p value. */
  template <class Value>
  void fillReached(std::span<Value> values, const Value& value) const
  {
    if (this->isWhole())
    {
      std::fill(values.begin(), values.end(), value);
      return;
    }
    for (Index vertex : this->Reached)
    {
      values[vertex] = value;
    }
  }
  /** Makes vertices farther than @p limit unreached; sets largestDistance() and stopReason(). */
  void finish(double limit, StopReason reason);

  std::size_t bytes() const
  {
    return this->Distances.size() * (sizeof(double) + 2 * sizeof(Index));
  }

private:
  /** Whether every vertex was reached. */
  bool isWhole() const { return this->Reached.size() == this->Distances.size(); }
  double largestReached() const;
  /** Gives each reached vertex the only seed as one of its own. */
  void spreadOnlySeed()
  {
    if (this->OnlySeed != NoIndex)
    {
      this->fillReached(std::span(this->NearestSeeds), this->OnlySeed);
      this->OnlySeed = NoIndex;
    }
  }

  std::vector<double> Distances;
  /** Where there is an only seed, all are NoIndex. */
  std::vector<Index> NearestSeeds;
  /** The nearest seed of all reached vertices, if it is one for all. */
  Index OnlySeed = NoIndex;
  BulkVector<Index> Reached;
  double LargestDistance = 0.0;
  StopReason Reason = StopReason::Exhausted;
  bool LeavesOutElsewhere = false;
  bool IsIntrinsic = false;
  double RaisedGain = 0.0;
};

}

#endif

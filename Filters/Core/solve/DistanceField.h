// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DistanceField_h
#define geodesic_DistanceField_h

#include "base/Index.h"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

namespace geodesic
{

/** Why a run ended. */
enum class StopReason
{
  /** Everything that can be reached was. */
  Exhausted,
  /** Everything within SolveOptions::maximumDistance was reached. */
  MaximumDistance,
  /** SolveOptions::targets were final. */
  Targets,
  /** SolveOptions::onProgress asked for it; the distances are not final. */
  Cancelled
};

/**
 * Distances at the vertices of a mesh, in its length unit. A solver owns its field and writes the
 * next one into it; only what the last front touched is reset, so a bounded run on a large mesh
 * costs what its front reaches.
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

  /** Unreached where no distance is known. */
  double distance(Index vertex) const { return this->Distances[vertex]; }
  std::span<const double> distances() const { return this->Distances; }
  bool isReached(Index vertex) const { return this->Distances[vertex] < Unreached; }
  /** Number of the nearest seed, the smallest of equally near ones; NoIndex where unreached. */
  Index nearestSeed(Index vertex) const { return this->NearestSeeds[vertex]; }
  /** The vertices that have a distance, each once, in no particular order. */
  std::span<const Index> reached() const { return this->Reached; }
  double largestDistance() const { return this->LargestDistance; }
  StopReason stopReason() const { return this->Reason; }

  // For solvers.

  void reset();
  /** Sets a distance, which may be set again, and notes the vertex as reached. */
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
  /** Brings what was reached into the order of the vertices where it is much of the mesh: who
   * visits it then goes through memory from front to back. */
  void orderReached();
  void setNearestSeed(Index vertex, Index seed) { this->NearestSeeds[vertex] = seed; }
  /** Of all that was reached. */
  void setNearestSeed(Index seed) { this->fillReached(std::span(this->NearestSeeds), seed); }
  /** Gives all that was reached the same value in @p values, which are one a vertex. */
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
  /** Takes back every distance above @p limit and sums up the run. */
  void finish(double limit, StopReason reason);

private:
  /** Whether every vertex was reached. */
  bool isWhole() const { return this->Reached.size() == this->Distances.size(); }
  double largestReached() const;

  std::vector<double> Distances;
  std::vector<Index> NearestSeeds;
  std::vector<Index> Reached;
  double LargestDistance = 0.0;
  StopReason Reason = StopReason::Exhausted;
};

}

#endif

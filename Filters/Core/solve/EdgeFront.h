// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EdgeFront_h
#define geodesic_EdgeFront_h

#include "base/Index.h"
#include "solve/MarchControl.h"
#include "solve/MarchingFront.h"

#include <cstddef>
#include <vector>

namespace geodesic
{

class ClosedTriangles;
class DistanceField;
class StopLimit;
class TriangleMesh;
struct SolveOptions;

/** A distance proposed for a vertex, and the seed that it is from; waits in the heap. */
struct EdgeTrial
{
  /** The distance, and what is left to the goal at least. */
  double bound;
  double distance;
  Index vertex;
  Index seed;
};

/** A front that spreads along edges. A vertex keeps one value, that of its nearest seed; a label
 * here is the number of a seed. */
class EdgeFront final : public MarchingFront
{
public:
  /** What counts at a vertex that has a distance. */
  enum class Counts
  {
    /** A lower distance, and an equal one of a seed with a smaller number. */
    LowerOrSmallerSeed,
    /** A distance that is lower by more than rounding, as a march counts it (see MarchControl). */
    ClearlyLower
  };

  /** @param heap  workspace */
  EdgeFront(const TriangleMesh& mesh, const ClosedTriangles& closed, const SolveOptions& options,
    StopLimit& limit, DistanceField& field, std::vector<EdgeTrial>& heap, Counts counts);

  /** Sets a distance that counts and is within the limit. */
  void propose(Index vertex, Index seed, double distance);
  /** Proposes to each neighbour of a vertex its distance and the edge between. */
  void proposeToNeighbours(Index vertex);

  /** See MarchControl. */
  double raisedGain() const { return this->Control.raisedGain(); }

  void advance(double limit, std::vector<Index>* taken) override;
  double nextDistance() const override;
  double meanLongestEdge() const override;
  std::size_t numberOfUpdates() const override { return this->Control.count(); }
  bool isCancelled() const override { return this->Control.isCancelled(); }
  void visitValues(Index vertex, const Visit& visit) const override;
  void lower(Index vertex, Index label, double value) override;

private:
  bool counts(Index vertex, Index seed, double distance) const;
  double costOf(Index vertex) const;

  const TriangleMesh& Mesh;
  const ClosedTriangles& Closed;
  const SolveOptions& Options;
  const StopLimit& Limit;
  DistanceField& Field;
  std::vector<EdgeTrial>& Heap;
  Counts WhatCounts;
  MarchControl Control;
};

}

#endif

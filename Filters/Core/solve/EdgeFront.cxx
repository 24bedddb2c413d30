// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/EdgeFront.h"

#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"
#include "solve/DistanceField.h"
#include "solve/SolveOptions.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>

namespace geodesic
{
namespace
{

/** The heap's order: the least bound first, of equal ones that of the smaller seed. */
bool isAfter(const EdgeTrial& a, const EdgeTrial& b)
{
  return std::tie(a.bound, a.seed) > std::tie(b.bound, b.seed);
}

}

EdgeFront::EdgeFront(const TriangleMesh& mesh, const ClosedTriangles& closed,
  const SolveOptions& options, StopLimit& limit, DistanceField& field, std::vector<EdgeTrial>& heap,
  Counts counts)
  : Mesh(mesh)
  , Closed(closed)
  , Options(options)
  , Limit(limit)
  , Field(field)
  , Heap(heap)
  , WhatCounts(counts)
  , Control(options, limit)
{
  this->Heap.clear();
}

void EdgeFront::propose(Index vertex, Index seed, double distance)
{
  if (this->counts(vertex, seed, distance) && distance <= this->Limit.exactly(vertex) &&
    !this->Options.isExcluded(vertex))
  {
    this->Field.setDistance(vertex, distance);
    this->Field.setNearestSeed(vertex, seed);
    this->Heap.push_back({ distance + this->Limit.leftFrom(vertex), distance, vertex, seed });
    std::push_heap(this->Heap.begin(), this->Heap.end(), isAfter);
  }
}

bool EdgeFront::counts(Index vertex, Index seed, double distance) const
{
  const double old = this->Field.distance(vertex);
  return this->WhatCounts == Counts::ClearlyLower
    ? distance < old * this->Control.keptFraction()
    : distance < old || (distance == old && seed < this->Field.nearestSeed(vertex));
}

void EdgeFront::proposeToNeighbours(Index vertex)
{
  const double own = this->Field.distance(vertex);
  const Index seed = this->Field.nearestSeed(vertex);
  const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    if (this->Closed.isOpenEdge(vertex, i))
    {
      const Index neighbour = ring[i].neighbour();
      const double length = norm(this->Mesh.toNeighbour(vertex, i));
      const double meanCost = 0.5 * (this->costOf(vertex) + this->costOf(neighbour));
      this->propose(neighbour, seed, own + length * meanCost);
    }
  }
}

void EdgeFront::advance(double limit, std::vector<Index>* taken)
{
  while (this->nextDistance() < limit && this->Control.mayGoOn(this->Field.reached().size()))
  {
    std::pop_heap(this->Heap.begin(), this->Heap.end(), isAfter);
    const EdgeTrial trial = this->Heap.back();
    this->Heap.pop_back();
    if (taken)
    {
      taken->push_back(trial.vertex);
    }
    // An item is out of date where a better one for its vertex was proposed after it.
    if (trial.distance == this->Field.distance(trial.vertex) &&
      trial.seed == this->Field.nearestSeed(trial.vertex))
    {
      this->proposeToNeighbours(trial.vertex);
    }
  }
}

double EdgeFront::nextDistance() const
{
  return this->Heap.empty() ? DistanceField::Unreached : this->Heap.front().bound;
}

double EdgeFront::meanLongestEdge() const
{
  const std::span<const double> cost = this->Options.cost;
  const double sum = std::accumulate(cost.begin(), cost.end(), 0.0);
  const double mean = cost.empty() ? 1.0 : sum / static_cast<double>(cost.size());
  return mean * this->Mesh.meanLongestEdge();
}

void EdgeFront::visitValues(Index vertex, const Visit& visit) const
{
  if (this->Field.isReached(vertex))
  {
    visit(this->Field.nearestSeed(vertex), this->Field.distance(vertex));
  }
}

void EdgeFront::lower(Index vertex, Index label, double value)
{
  this->propose(vertex, label, value);
}

double EdgeFront::costOf(Index vertex) const
{
  return this->Options.cost.empty() ? 1.0 : this->Options.cost[vertex];
}

}

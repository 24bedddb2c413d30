// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleCost_h
#define geodesic_TriangleCost_h

#include "base/Platform.h"
#include "mesh/TriangleMesh.h"
#include "solve/Partition.h"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

namespace geodesic
{

/** Cost 1 everywhere: distances are lengths. */
class UnitCost
{
public:
  static constexpr bool isUnit = true;

  /** @param margins of the vertices, see UpdateBounds; must live as long as this */
  UnitCost(const TriangleMesh& mesh, std::span<const float> margins, const Partition& partition)
    : LongestSides(partition.isDivided() ? partition.longestSides() : mesh.rings().longestSides())
    , Margins(margins)
  {
  }

  constexpr double ofTriangle(Index, Index, Index) const { return 1.0; }
  /** The most that two vertices of the triangles round a vertex can differ by. */
  double reach(Index vertex) const { return this->LongestSides[vertex]; }
  /** See labelMargin(). */
  double margin(Index vertex) const { return this->Margins[vertex]; }
  /** Has the processor fetch a margin that is soon to be read. */
  GEODESIC_INLINED void prefetchMargin(Index vertex) const
  {
    prefetchToRead(&this->Margins[vertex]);
  }
  double mean() const { return 1.0; }
  double smallest() const { return 1.0; }
  double largest() const { return 1.0; }

private:
  std::span<const float> LongestSides;
  std::span<const float> Margins;
};

/** A cost at each vertex; that of a triangle is the mean of its corners'. Set up in O(n). */
class VertexCost
{
public:
  static constexpr bool isUnit = false;

  VertexCost(const TriangleMesh& mesh, std::span<const double> cost, std::span<const float> margins,
    Partition& partition)
    : Cost(cost)
    , Length(mesh, margins, partition)
    , Dearest(cost.size())
  {
    for (Index v = 0; v < cost.size(); ++v)
    {
      double dearest = cost[v];
      for (const RingEntry& entry : mesh.ring(v))
      {
        dearest = std::max(dearest, cost[entry.neighbour()]);
      }
      this->Dearest[v] = dearest;
      this->Sum += cost[v];
      this->Smallest = std::min(this->Smallest, cost[v]);
      this->Largest = std::max(this->Largest, cost[v]);
    }
    this->agree(partition);
  }

  double ofTriangle(Index a, Index b, Index c) const
  {
    return (this->Cost[a] + this->Cost[b] + this->Cost[c]) / 3.0;
  }
  double reach(Index vertex) const { return this->Dearest[vertex] * this->Length.reach(vertex); }
  double margin(Index vertex) const { return this->Dearest[vertex] * this->Length.margin(vertex); }
  GEODESIC_INLINED void prefetchMargin(Index vertex) const
  {
    prefetchToRead(&this->Dearest[vertex]);
    this->Length.prefetchMargin(vertex);
  }
  /** 1 on a piece without vertices. */
  double mean() const
  {
    return this->Cost.empty() ? 1.0 : this->Sum / static_cast<double>(this->Cost.size());
  }
  /** On all pieces of the surface; the mean and the largest are those of this one. */
  double smallest() const { return this->Smallest; }
  double largest() const { return this->Largest; }

private:
  /** Takes the dearest neighbours of shared vertices, and the smallest cost, over all pieces. */
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
    for (double smallest : partition.gather({ &this->Smallest, 1 }))
    {
      this->Smallest = std::min(this->Smallest, smallest);
    }
  }

  std::span<const double> Cost;
  UnitCost Length;
  /** The largest cost among a vertex and its neighbours. */
  std::vector<double> Dearest;
  double Sum = 0.0;
  double Smallest = std::numeric_limits<double>::infinity();
  double Largest = 0.0;
};

}

#endif

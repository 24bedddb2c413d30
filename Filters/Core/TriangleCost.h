#ifndef geodesic_TriangleCost_h
#define geodesic_TriangleCost_h

#include "TriangleMesh.h"

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

  explicit UnitCost(const TriangleMesh& mesh)
    : Mesh(mesh)
  {
  }

  constexpr double ofTriangle(Index, Index, Index) const { return 1.0; }
  /** The most that two vertices of the triangles round a vertex can differ by. */
  double reach(Index vertex) const { return this->Mesh.longestEdgeAround(vertex); }
  double mean() const { return 1.0; }
  double smallest() const { return 1.0; }
  double largest() const { return 1.0; }

private:
  const TriangleMesh& Mesh;
};

/** A cost at each vertex; that of a triangle is the mean of its corners'. Set up in O(n). */
class VertexCost
{
public:
  static constexpr bool isUnit = false;

  VertexCost(const TriangleMesh& mesh, std::span<const double> cost)
    : Cost(cost)
    , Reaches(cost.size())
  {
    for (Index v = 0; v < cost.size(); ++v)
    {
      double dearest = cost[v];
      for (const RingEntry& entry : mesh.ring(v))
      {
        dearest = std::max(dearest, cost[entry.neighbour()]);
      }
      this->Reaches[v] = dearest * mesh.longestEdgeAround(v);
      this->Sum += cost[v];
      this->Smallest = std::min(this->Smallest, cost[v]);
      this->Largest = std::max(this->Largest, cost[v]);
    }
  }

  double ofTriangle(Index a, Index b, Index c) const
  {
    return (this->Cost[a] + this->Cost[b] + this->Cost[c]) / 3.0;
  }
  double reach(Index vertex) const { return this->Reaches[vertex]; }
  double mean() const { return this->Sum / static_cast<double>(this->Cost.size()); }
  double smallest() const { return this->Smallest; }
  double largest() const { return this->Largest; }

private:
  std::span<const double> Cost;
  std::vector<double> Reaches;
  double Sum = 0.0;
  double Smallest = std::numeric_limits<double>::infinity();
  double Largest = 0.0;
};

}

#endif

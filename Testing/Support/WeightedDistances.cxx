// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WeightedDistances.h"

#include "solve/DistanceField.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <queue>
#include <utility>

namespace geodesic::testing
{
namespace
{

/** The nodes of a graph, the vertices first, and the triangles in which each of them lies. */
class PointsOnEdges
{
public:
  PointsOnEdges(const TriangleMesh& mesh, int pointsOnEdge)
    : Positions(mesh.positions().begin(), mesh.positions().end())
    , Triangles(mesh.numberOfVertices())
    , InTriangle(mesh.numberOfTriangles())
  {
    for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
    {
      const Triangle& corners = mesh.triangle(t);
      for (int i = 0; i < 3; ++i)
      {
        this->add(t, corners[i]);
        const auto ends = std::minmax(corners[i], corners[(i + 1) % 3]);
        const auto [first, isNew] = this->Firsts.try_emplace(ends, this->numberOfNodes());
        for (int j = 0; j < pointsOnEdge; ++j)
        {
          if (isNew)
          {
            const double part = (j + 1.0) / (pointsOnEdge + 1.0);
            this->Positions.push_back(
              (1.0 - part) * mesh.position(ends.first) + part * mesh.position(ends.second));
            this->Triangles.emplace_back();
          }
          this->add(t, first->second + static_cast<Index>(j));
        }
      }
    }
  }

  Index numberOfNodes() const { return static_cast<Index>(this->Positions.size()); }
  const Vector3& position(Index node) const { return this->Positions[node]; }
  const std::vector<Index>& trianglesAt(Index node) const { return this->Triangles[node]; }
  const std::vector<Index>& nodesOf(Index triangle) const { return this->InTriangle[triangle]; }

private:
  void add(Index triangle, Index node)
  {
    this->Triangles[node].push_back(triangle);
    this->InTriangle[triangle].push_back(node);
  }

  std::vector<Vector3> Positions;
  std::vector<std::vector<Index>> Triangles;
  std::vector<std::vector<Index>> InTriangle;
  /** By the ends of an edge, the first of its points. */
  std::map<std::pair<Index, Index>, Index> Firsts;
};

}

std::vector<double> weightedDistances(
  const TriangleMesh& mesh, std::span<const double> cost, Index source, int pointsOnEdge)
{
  const PointsOnEdges graph(mesh, pointsOnEdge);
  std::vector<double> distances(graph.numberOfNodes(), DistanceField::Unreached);
  using Waiting = std::pair<double, Index>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> queue;
  distances[source] = 0.0;
  queue.emplace(0.0, source);
  while (!queue.empty())
  {
    const auto [distance, node] = queue.top();
    queue.pop();
    if (distance > distances[node])
    {
      continue;
    }
    for (const Index triangle : graph.trianglesAt(node))
    {
      const Triangle& corners = mesh.triangle(triangle);
      const double costHere = (cost[corners[0]] + cost[corners[1]] + cost[corners[2]]) / 3.0;
      for (const Index other : graph.nodesOf(triangle))
      {
        const double through =
          distance + costHere * norm(graph.position(other) - graph.position(node));
        if (through < distances[other])
        {
          distances[other] = through;
          queue.emplace(through, other);
        }
      }
    }
  }
  distances.resize(mesh.numberOfVertices());
  return distances;
}

}

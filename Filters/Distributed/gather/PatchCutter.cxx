// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gather/PatchCutter.h"

#include "base/SortUnique.h"
#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace geodesic::distributed
{
namespace
{

/** The number of consecutive vertices that share one bounding box. */
constexpr Index BlockSize = 256;

/** A ball that is a little larger: copies of a point with one global id may differ by rounding. */
Ball widened(const Ball& ball)
{
  constexpr double rounding = 1e-6;
  const Vector3& c = ball.centre;
  return { c, ball.radius + rounding * (std::abs(c.x) + std::abs(c.y) + std::abs(c.z)) };
}

}

PatchCutter::PatchCutter(const DividedMesh& mesh, const SolveOptions& options)
  : Mesh(mesh)
  , Options(options)
{
  const std::span<const Vector3> positions = mesh.mesh().positions();
  for (std::size_t first = 0; first < positions.size(); first += BlockSize)
  {
    BoundingBox& box = this->Boxes.emplace_back();
    for (const Vector3& p :
      positions.subspan(first, std::min<std::size_t>(BlockSize, positions.size() - first)))
    {
      box.add(p);
    }
  }
}

SurfacePatch PatchCutter::cut(std::span<const Ball> balls, const DistanceField* field) const
{
  const std::vector<Inner> inner = this->verticesIn(balls);
  std::vector<Index> vertices;
  std::unordered_map<GlobalVertex, float, HashOfVertex> depths;
  for (const Inner& each : inner)
  {
    vertices.push_back(each.vertex);
    depths.emplace(this->Mesh.shared().globalOf(each.vertex), each.depth);
  }
  SurfacePatch patch = this->cutRound(vertices, field);
  for (PatchVertex& vertex : patch.vertices)
  {
    const auto known = depths.find(vertex.vertex);
    vertex.depth = known == depths.end() ? PatchVertex::Outside : known->second;
  }
  return patch;
}

SurfacePatch PatchCutter::cutRound(
  std::span<const Index> vertices, const DistanceField* field) const
{
  const TriangleMesh& mesh = this->Mesh.mesh();
  SurfacePatch patch;
  std::unordered_map<Index, std::uint32_t> places;
  for (const Index t : this->trianglesRound(vertices))
  {
    PatchTriangle triangle{ {}, this->Options.isClosed(t) ? 1u : 0u };
    for (int c = 0; c < 3; ++c)
    {
      const Index vertex = mesh.triangle(t)[c];
      const auto [place, isNew] =
        places.emplace(vertex, static_cast<std::uint32_t>(patch.vertices.size()));
      if (isNew)
      {
        patch.vertices.push_back(this->patchVertex(vertex, field));
      }
      triangle.corners[c] = place->second;
    }
    patch.triangles.push_back(triangle);
  }
  return patch;
}

template <class Visit>
void PatchCutter::visitIn(const Ball& exact, const Visit& visit) const
{
  const TriangleMesh& mesh = this->Mesh.mesh();
  const Ball ball = widened(exact);
  for (std::size_t block = 0; block < this->Boxes.size(); ++block)
  {
    if (ball.contains(this->Boxes[block].nearestTo(ball.centre)))
    {
      const auto first = static_cast<Index>(block * BlockSize);
      const Index last = std::min(first + BlockSize, mesh.numberOfVertices());
      for (Index v = first; v < last; ++v)
      {
        if (ball.contains(mesh.position(v)) && !visit(v))
        {
          return;
        }
      }
    }
  }
}

std::size_t PatchCutter::count(std::span<const Ball> balls, std::size_t most) const
{
  std::size_t found = 0;
  for (std::size_t i = 0; i < balls.size() && found <= most; ++i)
  {
    this->visitIn(balls[i], [&](Index) { return ++found <= most; });
  }
  return found;
}

std::vector<PatchCutter::Inner> PatchCutter::verticesIn(std::span<const Ball> balls) const
{
  const TriangleMesh& mesh = this->Mesh.mesh();
  std::vector<Inner> vertices;
  for (const Ball& ball : balls)
  {
    this->visitIn(ball,
      [&](Index vertex)
      {
        vertices.push_back({ vertex, ball.depthOf(mesh.position(vertex)) });
        return true;
      });
  }
  std::sort(vertices.begin(), vertices.end(),
    [](const Inner& a, const Inner& b)
    { return a.vertex < b.vertex || (a.vertex == b.vertex && a.depth > b.depth); });
  const auto rest = std::unique(vertices.begin(), vertices.end(),
    [](const Inner& a, const Inner& b) { return a.vertex == b.vertex; });
  vertices.erase(rest, vertices.end());
  return vertices;
}

std::vector<Index> PatchCutter::trianglesRound(std::span<const Index> vertices) const
{
  const TriangleMesh& mesh = this->Mesh.mesh();
  std::vector<Index> triangles;
  for (const Index vertex : vertices)
  {
    const std::span<const RingEntry> ring = mesh.ring(vertex);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      if (ring[i].opensTriangle())
      {
        const std::array corners{ vertex, ring[i].neighbour(), ring[i + 1].neighbour() };
        const std::vector<Index> same = mesh.trianglesWith(corners);
        triangles.insert(triangles.end(), same.begin(), same.end());
      }
    }
  }
  sortUnique(triangles);
  return triangles;
}

PatchVertex PatchCutter::patchVertex(Index vertex, const DistanceField* field) const
{
  return { this->Mesh.shared().globalOf(vertex), this->Mesh.mesh().position(vertex),
    this->Mesh.longestSides()[vertex],
    this->Options.cost.empty() ? 1.0 : this->Options.cost[vertex],
    field ? field->distance(vertex) : DistanceField::Unreached,
    field ? field->nearestSeed(vertex) : NoIndex, this->Options.isExcluded(vertex) ? 1u : 0u };
}

}

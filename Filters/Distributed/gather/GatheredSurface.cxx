// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gather/GatheredSurface.h"

#include "gather/PatchCutter.h"
#include "mesh/TriangleMesh.h"
#include "pieces/PointKeys.h"
#include "split/SplitMesh.h"

#include <algorithm>
#include <set>

namespace geodesic::distributed
{
namespace
{

/**
 * Returns the vertices that carry the points of the first rank's paths, on all ranks. Collective.
 */
std::vector<GlobalVertex> verticesOfPaths(RankGroup& ranks, std::span<const GlobalPath> paths)
{
  std::set<GlobalVertex> carriers;
  for (const GlobalPath& path : paths)
  {
    for (const GlobalPathPoint& point : path)
    {
      for (int c = 0; c < 3; ++c)
      {
        if (point.weights[c] > 0.0)
        {
          carriers.insert(point.corners[c]);
        }
      }
    }
  }
  RankGroup::Message message;
  for (const GlobalVertex& carrier : carriers)
  {
    append(message, carrier);
  }
  return valuesIn<GlobalVertex>(ranks.fromFirst(message));
}

}

GatheredSurface::GatheredSurface(RankGroup& ranks, const DistributedSurface& surface,
  std::span<const GlobalPath> lines, const bridge::Barriers& barriers,
  const std::vector<double>& cost)
  : Surface(surface)
  , Mesh(surface.sharedPiece()->mesh())
  , Barriers(barriers)
  , Cost(cost)
{
  SolveOptions options;
  options.cost = cost;
  options.excluded = barriers.excluded;
  options.closedTriangles = barriers.closed;
  const PatchCutter cutter(surface.divided(), options);
  std::vector<Index> local;
  for (const GlobalVertex& carrier : verticesOfPaths(ranks, lines))
  {
    if (const Index vertex = surface.shared().find(carrier); vertex != NoIndex)
    {
      local.push_back(vertex);
    }
  }
  const bool hasCost = ranks.isAny(!cost.empty());
  const auto patches = patchesOfAll(ranks, [&] { return cutter.cutRound(local, nullptr); });
  ranks.together(
    [&]
    {
      if (ranks.rank() > 0)
      {
        this->leaveOut(cutter.trianglesRound(local));
        return;
      }
      Corridor moved;
      moved.add(patches, {});
      this->takeIn(moved, barriers, cost, hasCost);
    });
}

void GatheredSurface::leaveOut(const std::vector<Index>& moved)
{
  std::vector<bool> hasMoved(this->Mesh->numberOfTriangles(), false);
  for (const Index triangle : moved)
  {
    hasMoved[triangle] = true;
  }
  std::vector<std::uint8_t> closed;
  for (Index triangle = 0; triangle < this->Barriers.closed.size(); ++triangle)
  {
    if (!hasMoved[triangle])
    {
      closed.push_back(this->Barriers.closed[triangle]);
    }
  }
  this->Barriers.closed = std::move(closed);
  this->Mesh = std::make_shared<const TriangleMesh>(this->Mesh->without(hasMoved));
}

void GatheredSurface::takeIn(const Corridor& moved, const bridge::Barriers& barriers,
  const std::vector<double>& cost, bool hasCost)
{
  const TriangleMesh& piece = this->Surface.mesh();
  const SharedPoints& shared = this->Surface.shared();
  std::vector<Vector3> points(piece.numberOfPoints());
  std::vector<Index> kinds(piece.numberOfPoints());
  for (Index point = 0; point < piece.numberOfPoints(); ++point)
  {
    const Index vertex = piece.vertexOfPoint(point);
    kinds[point] = vertex == NoIndex ? point : piece.pointOfVertex(vertex);
    points[point] = vertex == NoIndex ? Vector3{} : piece.position(vertex);
  }
  std::vector<Triangle> triangles;
  for (const Triangle& t : piece.triangles())
  {
    triangles.push_back(
      { piece.pointOfVertex(t[0]), piece.pointOfVertex(t[1]), piece.pointOfVertex(t[2]) });
  }
  std::vector<std::uint8_t> closed = barriers.closed;
  closed.resize(piece.numberOfTriangles(), 0);

  std::vector<Index> pointOf;
  std::vector<const PatchVertex*> added;
  for (const PatchVertex& vertex : moved.vertices())
  {
    const Index known = shared.find(vertex.vertex);
    if (known != NoIndex)
    {
      pointOf.push_back(piece.pointOfVertex(known));
      continue;
    }
    const auto number = static_cast<Index>(points.size());
    pointOf.push_back(number);
    points.push_back(vertex.position);
    kinds.push_back(number);
    this->Added.push_back(vertex.vertex);
    this->PointOfAdded.emplace(vertex.vertex, number);
    added.push_back(&vertex);
  }
  for (const PatchTriangle& triangle : moved.triangles())
  {
    const Triangle corners{ pointOf[triangle.corners[0]], pointOf[triangle.corners[1]],
      pointOf[triangle.corners[2]] };
    const bool mayBeOwn = std::all_of(
      corners.begin(), corners.end(), [&](Index point) { return point < piece.numberOfPoints(); });
    if (mayBeOwn &&
      piece.hasTriangleWith(std::array{ piece.vertexOfPoint(corners[0]),
        piece.vertexOfPoint(corners[1]), piece.vertexOfPoint(corners[2]) }))
    {
      continue;
    }
    triangles.push_back(corners);
    closed.push_back(triangle.isClosed ? 1 : 0);
  }
  this->Mesh =
    std::make_shared<const TriangleMesh>(points, triangles, kinds, ThreadTeam(), piece.measurer());

  this->Barriers.closed.clear();
  for (Index t = 0; t < this->Mesh->numberOfTriangles(); ++t)
  {
    this->Barriers.closed.push_back(closed[this->Mesh->sourceOfTriangle(t)]);
  }
  this->Barriers.excluded.clear();
  this->Cost.clear();
  for (Index v = 0; v < this->Mesh->numberOfVertices(); ++v)
  {
    const Index point = this->Mesh->pointOfVertex(v);
    const bool isAdded = point >= piece.numberOfPoints();
    const Index old = isAdded ? NoIndex : piece.vertexOfPoint(point);
    const PatchVertex* from = isAdded ? added[point - piece.numberOfPoints()] : nullptr;
    const bool isExcluded =
      isAdded ? from->isExcluded != 0 : !barriers.excluded.empty() && barriers.excluded[old];
    this->Barriers.excluded.push_back(isExcluded ? 1 : 0);
    if (hasCost)
    {
      this->Cost.push_back(isAdded ? from->cost : cost[old]);
    }
  }
}

GlobalVertex GatheredSurface::globalOf(Index vertex) const
{
  const TriangleMesh& piece = this->Surface.mesh();
  const Index point = this->Mesh->pointOfVertex(vertex);
  return point < piece.numberOfPoints()
    ? this->Surface.shared().globalOf(piece.vertexOfPoint(point))
    : this->Added[point - piece.numberOfPoints()];
}

Index GatheredSurface::find(const GlobalVertex& vertex) const
{
  const Index ofPiece = this->Surface.shared().find(vertex);
  if (ofPiece != NoIndex)
  {
    return this->Mesh->vertexOfPoint(this->Surface.mesh().pointOfVertex(ofPiece));
  }
  const auto added = this->PointOfAdded.find(vertex);
  return added == this->PointOfAdded.end() ? NoIndex : this->Mesh->vertexOfPoint(added->second);
}

std::vector<SurfacePath> GatheredSurface::pathsOf(std::span<const GlobalPath> paths) const
{
  std::vector<SurfacePath> localPaths;
  for (const GlobalPath& path : paths)
  {
    SurfacePath& local = localPaths.emplace_back();
    for (const GlobalPathPoint& point : path)
    {
      PathPoint& at = local.emplace_back(PathPoint{ {}, point.weights });
      for (int c = 0; c < 3; ++c)
      {
        at.corners[c] = point.weights[c] > 0.0 ? this->find(point.corners[c]) : NoIndex;
      }
      // A corner without a weight does not matter, but it must exist.
      std::replace(at.corners.begin(), at.corners.end(), NoIndex, at.carriers()[0]);
    }
  }
  return localPaths;
}

void GatheredSurface::relocate(GlobalPoint& point) const
{
  PathPoint at{ {}, point.weights };
  bool isHere = true;
  for (int c = 0; c < 3; ++c)
  {
    at.corners[c] = this->find(point.corners[c]);
    isHere = isHere && (at.corners[c] != NoIndex || point.weights[c] == 0.0);
  }
  point.local.clear();
  if (!isHere)
  {
    return;
  }
  const Carriers carriers = at.carriers();
  const Index triangle = this->Mesh->firstTriangleWith({ carriers.begin(), carriers.end() });
  if (triangle != NoIndex)
  {
    SurfacePoint& local = point.local.emplace_back(SurfacePoint{ triangle, {} });
    for (int c = 0; c < 3; ++c)
    {
      local.weights[c] = weightOf(at, this->Mesh->triangle(local.triangle)[c]);
    }
  }
}

void GatheredSurface::relocateRegions(
  RankGroup& ranks, const DividedMesh& mesh, const SplitMesh* split, std::vector<Seed>& seeds) const
{
  std::vector<StartValue> own;
  for (Index s = 0; s < seeds.size(); ++s)
  {
    for (Index& vertex : seeds[s].vertices)
    {
      vertex = this->Mesh->vertexOfPoint(this->Surface.mesh().pointOfVertex(vertex));
      if (ranks.rank() > 0)
      {
        own.push_back({ vertex, s, 0.0, false });
      }
    }
  }
  // Vertices that moved to the first rank can be in a region of which the first rank's piece has no
  // vertex.
  for (const StartValue& other : mesh.shared().exchange(ranks, own))
  {
    if (ranks.rank() == 0)
    {
      seeds[other.label].vertices.push_back(
        split ? split->origin(other.vertex).carriers()[0] : other.vertex);
    }
  }
}

GlobalPathPoint GatheredSurface::originOf(const GlobalVertex& vertex, const SplitMesh* split) const
{
  if (vertex.rank > 0)
  {
    // The first rank has no triangle with this vertex, and vertices keep their numbers on the other
    // ranks.
    return { { vertex, vertex, vertex }, { 1.0, 0.0, 0.0 } };
  }
  const PathPoint at = split ? split->origin(vertex.vertex) : PathPoint::atVertex(vertex.vertex);
  return { { this->globalOf(at.corners[0]), this->globalOf(at.corners[1]),
             this->globalOf(at.corners[2]) },
    at.weights };
}

std::vector<Key> GatheredSurface::keysOf(const TriangleMesh& mesh, const SplitMesh* split) const
{
  std::vector<Key> keys;
  for (Index v = 0; v < mesh.numberOfVertices(); ++v)
  {
    if (split && !isVertex(split->origin(v)))
    {
      keys.push_back(NoKey);
      continue;
    }
    const GlobalVertex vertex = this->globalOf(split ? split->origin(v).carriers()[0] : v);
    keys.push_back({ static_cast<std::uint64_t>(vertex.rank), vertex.vertex, 0, 0 });
  }
  return keys;
}

}

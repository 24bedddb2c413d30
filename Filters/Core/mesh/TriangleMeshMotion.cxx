// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The functions of TriangleMesh that serve surfaces whose points move.

#include "base/BoundingBox.h"
#include "mesh/DistinctPositions.h"
#include "mesh/MotionTable.h"
#include "mesh/SpatialOrder.h"
#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace geodesic
{

std::optional<TriangleMesh> TriangleMesh::withPositions(
  std::span<const Vector3> points, CoincidentPoints coincident, const ThreadTeam& team) const
{
  auto positions = this->movedPositions(points, team);
  const bool areSame = positions &&
    (coincident == CoincidentPoints::Separate ||
      (this->Motion->of(*this).areMergedTogether(points, *positions) &&
        areDistinct(*positions, team)));
  if (!areSame)
  {
    return {};
  }
  return this->moved(std::move(*positions), team);
}

std::optional<TriangleMesh> TriangleMesh::withPositions(
  std::span<const Vector3> points, std::span<const Index> kinds, const ThreadTeam& team) const
{
  const std::vector<Index> vertices = this->verticesOfAllPoints();
  std::vector<Index> firstOfKind(points.size(), NoIndex);
  for (Index point = 0; point < points.size(); ++point)
  {
    if (vertices[point] != NoIndex)
    {
      Index& first = firstOfKind[kinds[point]];
      first = std::min(first, point);
      if (this->PointOfVertex[vertices[point]] != first || !isFinite(points[point]))
      {
        return {};
      }
    }
  }
  auto positions = this->movedPositions(points, team);
  if (!positions)
  {
    return {};
  }
  return this->moved(std::move(*positions), team);
}

std::optional<BulkVector<Vector3>> TriangleMesh::movedPositions(
  std::span<const Vector3> points, const ThreadTeam& team) const
{
  BulkVector<Vector3> positions(this->Positions.size());
  std::vector<BoundingBox> boxes(team.numberOfRanges(positions.size()));
  std::vector<std::uint8_t> areFinite(boxes.size());
  team.run(positions.size(),
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      BoundingBox box;
      bool isWhole = true;
      for (std::size_t v = first; v < last; ++v)
      {
        const Vector3 position = points[this->PointOfVertex[v]];
        isWhole = isWhole && isFinite(position);
        box.add(position);
        positions[v] = position;
      }
      boxes[range] = box;
      areFinite[range] = isWhole ? 1 : 0;
    });
  if (std::find(areFinite.begin(), areFinite.end(), 0) != areFinite.end())
  {
    return {};
  }
  BoundingBox whole;
  for (const BoundingBox& box : boxes)
  {
    whole.add(box.low, box.high);
  }
  checkMagnitude(whole);
  return positions;
}

TriangleMesh TriangleMesh::moved(BulkVector<Vector3> positions, const ThreadTeam& team) const
{
  MotionTable::Measured measured = this->Motion->of(*this).measure(*this, positions, team);
  TriangleMesh mesh;
  mesh.Positions = std::move(positions);
  mesh.Triangles = this->Triangles;
  mesh.SourceOfTriangle = this->SourceOfTriangle;
  mesh.Rings = this->Rings.withLongestSides(std::move(measured.longestSides));
  mesh.Numbers = std::move(measured.numbers);
  mesh.VertexOfPoint = this->VertexOfPoint;
  mesh.PointOfVertex = this->PointOfVertex;
  mesh.BarePoints = this->BarePoints;
  mesh.NumberOfSources = this->NumberOfSources;
  mesh.Motion = this->Motion;
  mesh.measureEdges();
  return mesh;
}

bool TriangleMesh::isMadeOf(std::span<const Triangle> triangles) const
{
  if (triangles.size() != this->NumberOfSources ||
    std::any_of(triangles.begin(), triangles.end(),
      [&](const Triangle& t) { return highestCorner(t) >= this->numberOfPoints(); }))
  {
    return false;
  }
  for (Index t = 0; t < this->numberOfTriangles(); ++t)
  {
    const Triangle& input = triangles[this->SourceOfTriangle[t]];
    const auto [a, b, c] = this->Triangles[t];
    if (this->VertexOfPoint[input[0]] != a || this->VertexOfPoint[input[1]] != b ||
      this->VertexOfPoint[input[2]] != c)
    {
      return false;
    }
  }
  return this->usesPointsOf(triangles);
}

bool TriangleMesh::usesPointsOf(std::span<const Triangle> triangles) const
{
  if (this->numberOfTriangles() == triangles.size() && !this->Motion->of(*this).hasMergedPoints())
  {
    return true;
  }
  const std::vector<Index> vertices = this->verticesOfAllPoints();
  std::vector<std::uint8_t> used(vertices.size(), 0);
  std::size_t leftOut = 0;
  for (const Triangle& t : triangles)
  {
    const auto [a, b, c] = t;
    used[a] = used[b] = used[c] = 1;
    leftOut +=
      vertices[a] == vertices[b] || vertices[b] == vertices[c] || vertices[c] == vertices[a];
  }
  return leftOut == triangles.size() - this->numberOfTriangles() &&
    std::equal(used.begin(), used.end(), vertices.begin(),
      [](std::uint8_t isUsed, Index vertex) { return (isUsed != 0) == (vertex != NoIndex); });
}

std::vector<Index> TriangleMesh::verticesOfAllPoints() const
{
  std::vector<Index> vertices(this->VertexOfPoint.begin(), this->VertexOfPoint.end());
  for (const BarePoint& bare : this->BarePoints)
  {
    vertices[bare.point] = bare.vertex;
  }
  return vertices;
}

}

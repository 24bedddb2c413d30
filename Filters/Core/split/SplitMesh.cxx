// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "split/SplitMesh.h"

#include "base/Interruption.h"
#include "split/MeshSplitter.h"
#include "split/PieceWeights.h"

#include <algorithm>

namespace geodesic
{

SplitMesh::SplitMesh(std::shared_ptr<const TriangleMesh> base, std::span<const SurfacePath> curves,
  std::span<const SurfacePath> cuts)
  : Base(std::move(base))
{
  MeshSplitter splitter(*this->Base);
  std::vector<std::size_t> cutNumbers;
  for (const SurfacePath& curve : curves)
  {
    splitter.add(curve);
  }
  for (const SurfacePath& cut : cuts)
  {
    cutNumbers.push_back(splitter.add(cut));
  }
  splitter.split();
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    this->Curves.push_back(splitter.curve(i));
  }
  splitter.cutAlong(cutNumbers);

  std::vector<Triangle> triangles;
  triangles.reserve(this->Base->numberOfTriangles() + splitter.pieces().size());
  this->BaseTriangles.reserve(triangles.capacity());
  auto nextSplit = splitter.splitTriangles().begin();
  for (Index triangle = 0; triangle < this->Base->numberOfTriangles(); ++triangle)
  {
    Interruption::checkAt(triangle);
    if (nextSplit != splitter.splitTriangles().end() && *nextSplit == triangle)
    {
      ++nextSplit;
    }
    else
    {
      triangles.push_back(this->Base->triangle(triangle));
      this->BaseTriangles.push_back(triangle);
    }
  }
  triangles.insert(triangles.end(), splitter.pieces().begin(), splitter.pieces().end());
  this->BaseTriangles.insert(
    this->BaseTriangles.end(), splitter.baseTriangles().begin(), splitter.baseTriangles().end());
  this->CutEdges = splitter.cutEdges();
  std::vector<Vector3> positions;
  positions.reserve(splitter.numberOfPoints());
  this->Origins.reserve(splitter.numberOfPoints());
  this->OnCut.reserve(splitter.numberOfPoints());
  for (Index point = 0; point < splitter.numberOfPoints(); ++point)
  {
    Interruption::checkAt(point);
    this->Origins.push_back(splitter.origin(point));
    positions.push_back(this->Origins[point].position(*this->Base));
    this->OnCut.push_back(splitter.isOnCut(point) ? 1 : 0);
  }
  this->Mesh = std::make_shared<const TriangleMesh>(
    positions, triangles, CoincidentPoints::Separate, ThreadTeam(), this->Base->measurer());

  std::vector<Index> pieces(this->Base->numberOfTriangles(), 0);
  for (Index triangle : this->BaseTriangles)
  {
    Interruption::checkAt(triangle);
    ++pieces[triangle];
  }
  for (Index triangle = 0; triangle < this->Mesh->numberOfTriangles(); ++triangle)
  {
    Interruption::checkAt(triangle);
    const Index baseTriangle = this->baseTriangleOf(triangle);
    if (pieces[baseTriangle] > 1)
    {
      this->PiecesOfSplit.emplace_back(baseTriangle, triangle);
    }
  }
  std::sort(this->PiecesOfSplit.begin(), this->PiecesOfSplit.end());
}

bool SplitMesh::splits(const SurfacePath& path)
{
  return std::any_of(
    path.begin(), path.end(), [](const PathPoint& point) { return !isVertex(point); });
}

SurfacePoint SplitMesh::pointOf(const SurfacePoint& basePoint) const
{
  const Triangle& corners = this->Base->triangle(basePoint.triangle);
  const PathPoint point{ corners, basePoint.weights };
  if (isVertex(point))
  {
    return this->Mesh->pointAtVertex(this->vertexOf(point.carriers()[0]));
  }
  SurfacePoint best;
  double depth = -std::numeric_limits<double>::infinity();
  const auto tryIn = [&](Index triangle)
  {
    const Triangle& inner = this->Mesh->triangle(triangle);
    const std::array<double, 3> weights =
      weightsIn({ this->origin(inner[0]), this->origin(inner[1]), this->origin(inner[2]) }, corners,
        basePoint.weights);
    const double least = *std::min_element(weights.begin(), weights.end());
    if (least > depth)
    {
      best = { triangle, weights };
      depth = least;
    }
  };
  auto piece = std::lower_bound(this->PiecesOfSplit.begin(), this->PiecesOfSplit.end(),
    std::pair<Index, Index>{ basePoint.triangle, 0 });
  for (; piece != this->PiecesOfSplit.end() && piece->first == basePoint.triangle; ++piece)
  {
    tryIn(piece->second);
  }
  if (best.triangle == NoIndex)
  {
    const std::array<Index, 3> vertices{ this->vertexOf(corners[0]), this->vertexOf(corners[1]),
      this->vertexOf(corners[2]) };
    tryIn(this->Mesh->firstTriangleWith(vertices));
  }
  return snapped(best);
}

std::vector<SurfacePoint> SplitMesh::curve(std::size_t number) const
{
  std::vector<SurfacePoint> points;
  for (Index point : this->Curves[number])
  {
    points.push_back(this->Mesh->pointAtVertex(this->Mesh->vertexOfPoint(point)));
  }
  return points;
}

bool SplitMesh::isOnCut(const SurfacePoint& point) const
{
  const Carriers carriers = PathPoint::at(*this->Mesh, point).carriers();
  const Index first = this->Mesh->pointOfVertex(carriers[0]);
  if (carriers.size() == 1)
  {
    return this->OnCut[first] != 0;
  }
  return carriers.size() == 2 &&
    this->CutEdges.count(std::minmax(first, this->Mesh->pointOfVertex(carriers[1]))) > 0;
}

std::vector<std::uint8_t> SplitMesh::excluded(std::span<const std::uint8_t> baseExcluded) const
{
  std::vector<std::uint8_t> flags(this->Mesh->numberOfVertices(), 0);
  for (Index baseVertex = 0; baseVertex < this->Base->numberOfVertices(); ++baseVertex)
  {
    const Index vertex = this->vertexOf(baseVertex);
    const bool isExcluded = !baseExcluded.empty() && baseExcluded[baseVertex] != 0;
    if (vertex != NoIndex && (isExcluded || this->OnCut[baseVertex] != 0))
    {
      flags[vertex] = 1;
    }
  }
  return flags;
}

std::vector<std::uint8_t> SplitMesh::excludedForEdges(
  std::span<const std::uint8_t> baseExcluded) const
{
  std::vector<std::uint8_t> flags = this->excluded(baseExcluded);
  for (Index vertex = 0; vertex < flags.size(); ++vertex)
  {
    flags[vertex] |= this->OnCut[this->Mesh->pointOfVertex(vertex)];
  }
  return flags;
}

std::vector<double> SplitMesh::cost(std::span<const double> baseCost) const
{
  std::vector<double> cost;
  cost.reserve(this->Mesh->numberOfVertices());
  for (Index vertex = 0; vertex < this->Mesh->numberOfVertices(); ++vertex)
  {
    const PathPoint& origin = this->origin(vertex);
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      sum += origin.weights[i] * baseCost[origin.corners[i]];
    }
    cost.push_back(sum);
  }
  return cost;
}

std::vector<std::uint8_t> SplitMesh::closed(std::span<const std::uint8_t> baseClosed) const
{
  std::vector<std::uint8_t> flags;
  flags.reserve(this->Mesh->numberOfTriangles());
  for (Index triangle = 0; triangle < this->Mesh->numberOfTriangles(); ++triangle)
  {
    flags.push_back(baseClosed[this->baseTriangleOf(triangle)]);
  }
  return flags;
}

std::vector<Index> SplitMesh::region(const std::vector<Index>& baseVertices) const
{
  std::vector<std::uint8_t> isInside(this->Base->numberOfVertices(), 0);
  for (Index baseVertex : baseVertices)
  {
    isInside[baseVertex] = 1;
  }
  std::vector<Index> vertices;
  for (Index vertex = 0; vertex < this->Mesh->numberOfVertices(); ++vertex)
  {
    const Carriers carriers = this->origin(vertex).carriers();
    if (std::all_of(
          carriers.begin(), carriers.end(), [&](Index carrier) { return isInside[carrier] != 0; }))
    {
      vertices.push_back(vertex);
    }
  }
  return vertices;
}

}

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "split/SplitMesh.h"

#include "split/MeshSplitter.h"

#include <algorithm>

namespace geodesic
{
namespace
{

/**
 * The weights of a point of a triangle with respect to a smaller triangle inside it.
 * @param inner    corners of the smaller triangle
 * @param outer    corners of the larger one
 * @param weights  of the point in the larger one
 * @return some of them are negative if the point is outside the smaller one; -1 each if that has no
 *         area
 */
std::array<double, 3> weightsIn(const std::array<PathPoint, 3>& inner, const Triangle& outer,
  const std::array<double, 3>& weights)
{
  // Two of the barycentric weights are affine coordinates in the triangle.
  const auto x = [&](int i) { return weightOf(inner[i], outer[1]); };
  const auto y = [&](int i) { return weightOf(inner[i], outer[2]); };
  const double determinant = (x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0));
  if (determinant == 0.0)
  {
    return { -1.0, -1.0, -1.0 };
  }
  const double px = weights[1] - x(0);
  const double py = weights[2] - y(0);
  const double second = (px * (y(2) - y(0)) - (x(2) - x(0)) * py) / determinant;
  const double third = ((x(1) - x(0)) * py - px * (y(1) - y(0))) / determinant;
  return { 1.0 - second - third, second, third };
}

}

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

  this->Origins = splitter.origins();
  this->BaseTriangles = splitter.baseTriangles();
  this->CutEdges = splitter.cutEdges();
  std::vector<Vector3> positions;
  positions.reserve(this->Origins.size());
  for (Index point = 0; point < this->Origins.size(); ++point)
  {
    positions.push_back(this->Origins[point].position(*this->Base));
    this->OnCut.push_back(splitter.isOnCut(point) ? 1 : 0);
  }
  this->Mesh = std::make_shared<const TriangleMesh>(positions, splitter.triangles(),
    CoincidentPoints::Separate, ThreadTeam(), this->Base->measurer());

  std::vector<Index> pieces(this->Base->numberOfTriangles(), 0);
  for (Index triangle : this->BaseTriangles)
  {
    ++pieces[triangle];
  }
  for (Index triangle = 0; triangle < this->Mesh->numberOfTriangles(); ++triangle)
  {
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
    tryIn(this->Mesh->trianglesWith(vertices).front());
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

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedSurface.h"

#include "TriangleMesh.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <string>

namespace geodesic::distributed
{
namespace
{

std::vector<PointKey> keysOfIds(const TriangleMesh& mesh, vtkDataArray* ids)
{
  constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();
  std::vector<PointKey> keys(mesh.numberOfVertices(), PointKey{ none, 0, 0 });
  for (Index point = 0; point < mesh.numberOfPoints(); ++point)
  {
    if (const Index vertex = mesh.vertexOfPoint(point); vertex != NoIndex)
    {
      const auto id = static_cast<std::uint64_t>(ids->GetComponent(point, 0));
      keys[vertex][0] = std::min(keys[vertex][0], id);
    }
  }
  return keys;
}

std::vector<PointKey> keysOfPositions(const TriangleMesh& mesh)
{
  std::vector<PointKey> keys;
  keys.reserve(mesh.numberOfVertices());
  // Adding 0 makes -0 one with 0.
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x + 0.0); };
  for (const Vector3& p : mesh.positions())
  {
    keys.push_back({ bits(p.x), bits(p.y), bits(p.z) });
  }
  return keys;
}

struct Known
{
  std::weak_ptr<const bridge::InputSurface> piece;
  /** When the ids were modified, which happens at no two times; 0: no ids. */
  vtkMTimeType idsTime;
  /** Equal for what ranks built together. */
  double number;
  std::weak_ptr<const DistributedSurface> surface;
};

}

std::shared_ptr<const DistributedSurface> DistributedSurface::of(RankGroup& ranks,
  const std::shared_ptr<const bridge::InputSurface>& surface, vtkDataArray* ids,
  CoincidentPoints coincident)
{
  static std::vector<Known> known;
  static double lastNumber = 0.0;
  const vtkMTimeType idsTime = ids ? ids->GetMTime() : 0;
  std::erase_if(known, [](const Known& k) { return k.surface.expired(); });
  const auto found = std::find_if(known.begin(), known.end(),
    [&](const Known& k) { return k.piece.lock() == surface && k.idsTime == idsTime; });
  const double number = found == known.end() ? 0.0 : found->number;
  const std::vector<double> numbers = ranks.gather({ &number, 1 });
  if (number > 0.0 &&
    std::all_of(numbers.begin(), numbers.end(), [&](double n) { return n == number; }))
  {
    return found->surface.lock();
  }
  auto built = std::make_shared<const DistributedSurface>(ranks, surface, ids, coincident);
  const std::vector<double> lasts = ranks.gather({ &lastNumber, 1 });
  lastNumber = *std::max_element(lasts.begin(), lasts.end()) + 1.0;
  known.push_back({ surface, idsTime, lastNumber, built });
  return built;
}

DistributedSurface::DistributedSurface(RankGroup& ranks,
  std::shared_ptr<const bridge::InputSurface> surface, vtkDataArray* ids,
  CoincidentPoints coincident)
  : Piece(std::move(surface))
{
  const TriangleMesh& mesh = this->mesh();
  // A piece without triangles has ids of all its points.
  std::array least{ ids || mesh.numberOfTriangles() == 0 ? 1.0 : 0.0,
    mesh.numberOfTriangles() == 0 ? 0.0 : -1.0, -static_cast<double>(mesh.numberOfPoints()) };
  ranks.takeLeast(least);
  const bool allHaveIds = least[0] > 0.0;
  this->MostPoints = static_cast<vtkIdType>(-least[2]);
  if (least[1] == 0.0)
  {
    throw std::runtime_error("The input has no surface: no triangle, polygon or strip with an area "
                             "on any rank. Give a surface, for example by Extract Surface.");
  }
  if (ranks.size() > 1 && !allHaveIds && coincident == CoincidentPoints::Separate)
  {
    throw std::runtime_error("The surface is spread over " + std::to_string(ranks.size()) +
      " ranks and nothing tells which points of the pieces are the same. Turn "
      "MergeCoincidentPoints on, or give the points global ids by Generate Global Ids.");
  }
  this->Shared = std::make_unique<const SharedPoints>(
    ranks, mesh, allHaveIds && ids ? keysOfIds(mesh, ids) : keysOfPositions(mesh));
  if (ranks.size() > 1)
  {
    this->agreeOnLongestEdges(ranks);
  }
  this->chooseStep(ranks);
}

void DistributedSurface::agreeOnLongestEdges(RankGroup& ranks)
{
  this->LongestEdges.resize(this->mesh().numberOfVertices());
  for (Index v = 0; v < this->LongestEdges.size(); ++v)
  {
    this->LongestEdges[v] = static_cast<float>(this->mesh().longestEdgeAround(v));
  }
  this->Shared->takeLargest<float>(ranks, this->LongestEdges);
}

void DistributedSurface::chooseStep(RankGroup& ranks)
{
  const auto vertices = static_cast<double>(this->mesh().numberOfVertices());
  const auto shared = static_cast<double>(this->Shared->vertices().size());
  constexpr double atSharedVertex = 0.1;
  constexpr double least = 0.5;
  this->StepInEdges = std::max(least, atSharedVertex * ranks.sum(vertices) / ranks.sum(shared));
}

}

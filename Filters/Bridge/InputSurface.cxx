// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputSurface.h"

#include "PolyDataTriangles.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace geodesic::bridge
{
namespace
{

/** Tells inputs apart: modification times are never used twice, so a reused address does not
 * matter. */
using Identity =
  std::tuple<void*, vtkMTimeType, void*, vtkMTimeType, void*, vtkMTimeType, CoincidentPoints>;

Identity identityOf(vtkPolyData* input, CoincidentPoints coincident)
{
  vtkPoints* points = input->GetPoints();
  vtkCellArray* polygons = input->GetPolys();
  vtkCellArray* strips = input->GetStrips();
  return { points, points ? points->GetMTime() : 0, polygons, polygons->GetMTime(), strips,
    strips->GetMTime(), coincident };
}

struct Known
{
  Identity identity;
  std::weak_ptr<const InputSurface> surface;
};

}

std::shared_ptr<const InputSurface> InputSurface::of(
  vtkPolyData* input, CoincidentPoints coincident)
{
  auto surface = pieceOf(input, coincident);
  if (surface->mesh()->numberOfTriangles() == 0)
  {
    throw std::invalid_argument(
      "The input has no surface: " + std::to_string(input->GetNumberOfPoints()) +
      " points, and no triangle, polygon or strip with an area among its " +
      std::to_string(input->GetNumberOfCells()) +
      " cells. Give a surface, for example by "
      "Extract Surface.");
  }
  return surface;
}

std::shared_ptr<const InputSurface> InputSurface::pieceOf(
  vtkPolyData* input, CoincidentPoints coincident)
{
  static std::mutex mutex;
  static std::vector<Known> known;
  const Identity identity = identityOf(input, coincident);
  const std::lock_guard lock(mutex);
  std::erase_if(known, [](const Known& k) { return k.surface.expired(); });
  for (const Known& k : known)
  {
    const auto surface = k.surface.lock();
    if (k.identity == identity && surface)
    {
      return surface;
    }
  }
  auto surface = std::make_shared<const InputSurface>(input, coincident);
  known.push_back({ identity, surface });
  return surface;
}

InputSurface::InputSurface(vtkPolyData* input, CoincidentPoints coincident)
{
  const std::vector<Vector3> points = pointsOf(input);
  SurfaceTriangles triangles = trianglesOf(input, points);
  this->Mesh = std::make_shared<const TriangleMesh>(points, triangles.corners, coincident);
  if (triangles.cells.empty())
  {
    return;
  }
  this->FirstCell = triangles.cells.front();
  const bool isConsecutive = triangles.cells.back() - this->FirstCell + 1 == triangles.cells.size();
  if (!isConsecutive || static_cast<vtkIdType>(triangles.cells.size()) != input->GetNumberOfPolys())
  {
    this->CellOfSource = std::move(triangles.cells);
  }
}

Index InputSurface::cellOfTriangle(Index triangle) const
{
  const Index source = this->Mesh->sourceOfTriangle(triangle);
  return this->CellOfSource.empty() ? this->FirstCell + source : this->CellOfSource[source];
}

const ClosestPointTree& InputSurface::closestPoints() const
{
  std::call_once(this->ClosestPointsBuilt,
    [this] { this->ClosestPoints = std::make_unique<ClosestPointTree>(this->Mesh); });
  return *this->ClosestPoints;
}

}

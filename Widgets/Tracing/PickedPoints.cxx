// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PickedPoints.h"

#include "vtkContourRepresentation.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataCollection.h"
#include "vtkPolygonalSurfacePointPlacer.h"

#include "input/InputBlocks.h"
#include "input/PointIdentity.h"

#include <algorithm>
#include <limits>

namespace geodesic::bridge
{
namespace
{

std::vector<vtkPolyData*> surfacesIn(vtkPolyDataCollection* polys)
{
  std::vector<vtkPolyData*> surfaces;
  vtkCollectionSimpleIterator cookie;
  polys->InitTraversal(cookie);
  while (vtkPolyData* surface = polys->GetNextPolyData(cookie))
  {
    surfaces.push_back(surface);
  }
  return surfaces;
}

/**
 * Returns the picked point, or the corner of the picked face that is nearest to the picked place.
 */
vtkIdType pickedId(const vtkPolygonalSurfacePointPlacerNode& record)
{
  if (record.CellId < 0)
  {
    return record.PointId;
  }
  vtkIdType nearest = -1;
  if (record.CellId < record.PolyData->GetNumberOfCells())
  {
    vtkNew<vtkIdList> corners;
    record.PolyData->GetCellPoints(record.CellId, corners);
    double least = std::numeric_limits<double>::infinity();
    for (vtkIdType corner : *corners)
    {
      double position[3];
      record.PolyData->GetPoint(corner, position);
      const double distance =
        vtkMath::Distance2BetweenPoints(position, record.SurfaceWorldPosition);
      nearest = distance < least ? corner : nearest;
      least = std::min(distance, least);
    }
  }
  return nearest;
}

}

PickedPoint PickedPoints::at(
  vtkContourRepresentation* contour, int node, vtkPolyDataCollection* polys)
{
  auto* placer = vtkPolygonalSurfacePointPlacer::SafeDownCast(contour->GetPointPlacer());
  Position position;
  if (!placer || !contour->GetNthNodeWorldPosition(node, position.data()))
  {
    return {};
  }
  std::vector<vtkPolyData*> surfaces = surfacesIn(polys);
  const auto counts = [&](vtkPolyData* surface)
  {
    return surface &&
      (surfaces.empty() || std::find(surfaces.begin(), surfaces.end(), surface) != surfaces.end());
  };
  const vtkPolygonalSurfacePointPlacerNode* record =
    placer->GetNodeAtWorldPosition(position.data());
  const bool isRecorded = record && counts(record->PolyData);
  if (isRecorded && std::equal(position.begin(), position.end(), record->WorldPosition))
  {
    const PickedPoint point{ record->PolyData, pickedId(*record) };
    this->remember(position, point);
    return point;
  }
  const auto memory = this->Memories.find(position);
  if (memory != this->Memories.end() && counts(memory->second.surface))
  {
    return { memory->second.surface, memory->second.id };
  }
  if (!isRecorded)
  {
    return {};
  }
  if (surfaces.empty())
  {
    surfaces.push_back(record->PolyData);
  }
  const PickedPoint point = this->nearestTo({ position[0], position[1], position[2] }, surfaces);
  this->remember(position, point);
  return point;
}

void PickedPoints::remember(const Position& position, const PickedPoint& point)
{
  // A node that is dragged adds one entry at each step.
  constexpr std::size_t most = 100000;
  if (this->Memories.size() >= most)
  {
    this->Memories.clear();
  }
  this->Memories[position] = { point.surface, point.id };
}

PickedPoint PickedPoints::nearestTo(
  const Vector3& position, const std::vector<vtkPolyData*>& surfaces)
{
  PickedPoint nearest;
  double least = std::numeric_limits<double>::infinity();
  for (vtkPolyData* surface : surfaces)
  {
    const PickedSurface::NearPoint point = this->surfaceOf(surface).nearestPoint(position);
    if (point.distance < least)
    {
      nearest = { surface, point.id };
      least = point.distance;
    }
  }
  return nearest;
}

PickedSurface& PickedPoints::surfaceOf(vtkPolyData* input)
{
  auto surface = InputSurface::of(InputBlocks(input), PointIdentity());
  const auto known = std::find_if(this->Known.begin(), this->Known.end(),
    [&](const KnownSurface& k) { return k.surface->surface() == surface; });
  if (known != this->Known.end())
  {
    return *known->surface;
  }
  std::erase_if(this->Known, [&](const KnownSurface& k) { return !k.input || k.input == input; });
  this->Known.push_back({ input, std::make_unique<PickedSurface>(std::move(surface)) });
  return *this->Known.back().surface;
}

}

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfacePointPicker.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "ErrorMessage.h"
#include "InputSurface.h"

#include <algorithm>
#include <limits>
#include <vector>

using geodesic::Vector3;

namespace
{

/** The answer of one rank, which the ranks compare. */
struct Hit
{
  double distance = std::numeric_limits<double>::infinity();
  Vector3 position;
};

bool hasFaces(vtkPolyData* surface)
{
  return surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0;
}

/** The surfaces of a data set or of each of its blocks. */
std::vector<vtkSmartPointer<vtkPolyData>> surfacesOf(vtkDataObject* data)
{
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto block = vtk::TakeSmartPointer(blocks->NewIterator());
    for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
    {
      const auto ofBlock = surfacesOf(block->GetCurrentDataObject());
      surfaces.insert(surfaces.end(), ofBlock.begin(), ofBlock.end());
    }
    return surfaces;
  }
  vtkSmartPointer<vtkPolyData> surface = vtkPolyData::SafeDownCast(data);
  if (!surface && vtkDataSet::SafeDownCast(data))
  {
    vtkNew<vtkDataSetSurfaceFilter> toSurface;
    toSurface->SetInputDataObject(data);
    toSurface->Update();
    surface = toSurface->GetOutput();
  }
  if (surface && hasFaces(surface))
  {
    surfaces.push_back(surface);
  }
  return surfaces;
}

Vector3 nearestCorner(
  const geodesic::TriangleMesh& mesh, const geodesic::ClosestPointTree::Result& hit)
{
  const auto& corners = mesh.triangle(hit.point.triangle);
  const auto distanceTo = [&](geodesic::Index corner)
  { return norm(mesh.position(corner) - hit.position); };
  return mesh.position(*std::min_element(
    corners.begin(), corners.end(), [&](auto a, auto b) { return distanceTo(a) < distanceTo(b); }));
}

/** The nearest hit of all ranks, on the first rank. */
Hit nearestOfAllRanks(const Hit& mine)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  const int ranks = controller ? controller->GetNumberOfProcesses() : 1;
  if (ranks == 1)
  {
    return mine;
  }
  const std::vector<double> sent{ mine.distance, mine.position.x, mine.position.y,
    mine.position.z };
  std::vector<double> received(4 * ranks);
  controller->Gather(sent.data(), received.data(), 4, 0);
  Hit nearest = mine;
  for (auto rank = received.begin(); rank != received.end(); rank += 4)
  {
    if (controller->GetLocalProcessId() == 0 && rank[0] < nearest.distance)
    {
      nearest = { rank[0], { rank[1], rank[2], rank[3] } };
    }
  }
  return nearest;
}

}

struct vtkSurfacePointPicker::Internals
{
  vtkSmartPointer<vtkAlgorithmOutput> Input;
  vtkDataObject* Data = nullptr;
  vtkMTimeType DataTime = 0;
  std::vector<std::shared_ptr<const geodesic::bridge::InputSurface>> Surfaces;

  /** Builds what is needed for the input's present data, unless it is there. */
  void prepare()
  {
    vtkDataObject* data = this->Input
      ? this->Input->GetProducer()->GetOutputDataObject(this->Input->GetIndex())
      : nullptr;
    const vtkMTimeType time = data ? data->GetMTime() : 0;
    if (data == this->Data && time == this->DataTime)
    {
      return;
    }
    this->Surfaces.clear();
    this->Data = data;
    this->DataTime = time;
    for (vtkPolyData* surface : surfacesOf(data))
    {
      this->Surfaces.push_back(
        geodesic::bridge::InputSurface::of(surface, geodesic::CoincidentPoints::Merge));
    }
  }
};

vtkStandardNewMacro(vtkSurfacePointPicker);

vtkSurfacePointPicker::vtkSurfacePointPicker()
  : Internal(std::make_unique<Internals>())
{
}

vtkSurfacePointPicker::~vtkSurfacePointPicker() = default;

void vtkSurfacePointPicker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SnapToPoint: " << this->SnapToPoint << "\n";
  os << indent << "Met a surface: " << this->Answer[0] << "\n";
}

void vtkSurfacePointPicker::SetInputConnection(vtkAlgorithmOutput* input)
{
  if (input != this->Internal->Input)
  {
    this->Internal->Input = input;
    this->Modified();
  }
}

void vtkSurfacePointPicker::Pick()
{
  const Vector3 origin{ this->Origin[0], this->Origin[1], this->Origin[2] };
  const Vector3 direction{ this->Direction[0], this->Direction[1], this->Direction[2] };
  Hit nearest;
  try
  {
    this->Internal->prepare();
    for (const auto& surface : this->Internal->Surfaces)
    {
      const auto hit = surface->closestPoints().firstOnRay(origin, direction);
      if (hit && hit->distance < nearest.distance)
      {
        nearest = { hit->distance,
          this->SnapToPoint ? nearestCorner(*surface->mesh(), *hit) : hit->position };
      }
    }
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< geodesic::bridge::messageOf(error));
    this->Internal->Surfaces.clear();
  }
  nearest = nearestOfAllRanks(nearest);
  const bool isHit = nearest.distance < std::numeric_limits<double>::infinity();
  this->Answer[0] = isHit ? 1.0 : 0.0;
  this->Answer[1] = nearest.position.x;
  this->Answer[2] = nearest.position.y;
  this->Answer[3] = nearest.position.z;
}

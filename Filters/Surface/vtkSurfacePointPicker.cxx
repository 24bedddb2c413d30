// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfacePointPicker.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkDataObject.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkWeakPointer.h"

#include "filter/ErrorMessage.h"
#include "input/ArrayValues.h"
#include "input/InputBlocks.h"
#include "input/InputSurface.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

using geodesic::Vector3;

namespace
{

/** The point that a ray meets on one rank's piece; the ranks compare the distances. */
struct Hit
{
  double distance = std::numeric_limits<double>::infinity();
  Vector3 position;
  double value = std::numeric_limits<double>::quiet_NaN();
};

/** The value of an array of points at a point of the mesh. */
double valueAt(const geodesic::TriangleMesh& mesh, std::span<const double> values,
  const geodesic::SurfacePoint& point)
{
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    // A corner without weight may have no value.
    if (point.weights[i] > 0.0)
    {
      sum += point.weights[i] * values[mesh.pointOfVertex(mesh.triangle(point.triangle)[i])];
    }
  }
  return sum;
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

/** Returns the nearest hit of all ranks, on the first rank. */
Hit nearestOfAllRanks(const Hit& mine)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  const int ranks = controller ? controller->GetNumberOfProcesses() : 1;
  if (ranks == 1)
  {
    return mine;
  }
  const std::vector<double> sent{ mine.distance, mine.position.x, mine.position.y, mine.position.z,
    mine.value };
  std::vector<double> received(5 * ranks);
  controller->Gather(sent.data(), received.data(), 5, 0);
  Hit nearest = mine;
  for (auto rank = received.begin(); rank != received.end(); rank += 5)
  {
    if (controller->GetLocalProcessId() == 0 && rank[0] < nearest.distance)
    {
      nearest = { rank[0], { rank[1], rank[2], rank[3] }, rank[4] };
    }
  }
  return nearest;
}

}

struct vtkSurfacePointPicker::Internals
{
  vtkSmartPointer<vtkAlgorithmOutput> Input;
  /** Null where it was deleted, which the output does not tell. */
  vtkWeakPointer<vtkAlgorithm> Producer;
  vtkDataObject* Data = nullptr;
  vtkMTimeType DataTime = 0;
  /** Null if the data have no faces. */
  std::shared_ptr<const geodesic::bridge::InputSurface> Surface;
  std::string ArrayName;
  /** The array's value at each point of all blocks; empty if no array of that name is there. */
  std::vector<double> Values;

  /** Builds the surface of the input's present data, unless it is there already. */
  void prepare(const std::string& arrayName)
  {
    vtkDataObject* data =
      this->Producer ? this->Producer->GetOutputDataObject(this->Input->GetIndex()) : nullptr;
    const vtkMTimeType time = data ? data->GetMTime() : 0;
    if (data == this->Data && time == this->DataTime && arrayName == this->ArrayName)
    {
      return;
    }
    this->Surface = nullptr;
    this->Data = data;
    this->DataTime = time;
    this->ArrayName = arrayName;
    this->Values.clear();
    const geodesic::bridge::InputBlocks blocks(data);
    if (blocks.numberWithFaces() > 0)
    {
      // The same defaults as those of this module's filters, so that they share the surface.
      this->Surface = geodesic::bridge::InputSurface::of(
        blocks, geodesic::bridge::identityOf(blocks, true, true));
      if (!arrayName.empty())
      {
        this->Values = geodesic::bridge::chosenArray(blocks, "ArrayName", arrayName, false).values;
      }
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
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "Value: " << this->Value << "\n";
}

void vtkSurfacePointPicker::SetInputConnection(vtkAlgorithmOutput* input)
{
  if (input != this->Internal->Input)
  {
    this->Internal->Input = input;
    this->Internal->Producer = input ? input->GetProducer() : nullptr;
    this->Modified();
  }
}

void vtkSurfacePointPicker::SetArrayName(const char* name)
{
  this->ArrayName = name ? name : "";
  this->Modified();
}

void vtkSurfacePointPicker::Pick()
{
  const Vector3 origin{ this->Origin[0], this->Origin[1], this->Origin[2] };
  const Vector3 direction{ this->Direction[0], this->Direction[1], this->Direction[2] };
  Hit nearest;
  try
  {
    this->Internal->prepare(this->ArrayName);
    const auto& surface = this->Internal->Surface;
    const auto hit =
      surface ? surface->closestPoints().tree().firstOnRay(origin, direction) : std::nullopt;
    if (hit)
    {
      nearest = { hit->distance,
        this->SnapToPoint ? nearestCorner(*surface->mesh(), *hit) : hit->position };
      if (!this->Internal->Values.empty())
      {
        nearest.value = valueAt(*surface->mesh(), this->Internal->Values, hit->point);
      }
    }
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< geodesic::bridge::messageOf(error));
    // So that the next one looks again, and says the same if it must.
    this->Internal->Data = nullptr;
    this->Internal->Surface = nullptr;
  }
  nearest = nearestOfAllRanks(nearest);
  const bool isHit = nearest.distance < std::numeric_limits<double>::infinity();
  this->Answer[0] = isHit ? 1.0 : 0.0;
  this->Answer[1] = nearest.position.x;
  this->Answer[2] = nearest.position.y;
  this->Answer[3] = nearest.position.z;
  this->Value = nearest.value;
}

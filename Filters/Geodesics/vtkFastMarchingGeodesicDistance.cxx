// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFastMarchingGeodesicDistance.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "FastMarchingRequest.h"
#include "FastMarchingWorkspace.h"
#include "filter/ErrorMessage.h"
#include "filter/SetUpReporter.h"
#include "filter/SettlingNotice.h"
#include "filter/VtkVersions.h"
#include "output/FieldArray.h"

#include <algorithm>

struct vtkFastMarchingGeodesicDistance::Internals
{
  geodesic::bridge::FastMarchingWorkspace Workspace;
};

vtkStandardNewMacro(vtkFastMarchingGeodesicDistance);
vtkCxxSetSmartPointerMacro(
  vtkFastMarchingGeodesicDistance, DestinationVertexStopCriterion, vtkIdList);
vtkCxxSetSmartPointerMacro(vtkFastMarchingGeodesicDistance, ExclusionPointIds, vtkIdList);
vtkCxxSetSmartPointerMacro(vtkFastMarchingGeodesicDistance, PropagationWeights, vtkDataArray);

//------------------------------------------------------------------------------
vtkFastMarchingGeodesicDistance::vtkFastMarchingGeodesicDistance()
  : Internal(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkFastMarchingGeodesicDistance::~vtkFastMarchingGeodesicDistance() = default;

//------------------------------------------------------------------------------
void vtkFastMarchingGeodesicDistance::SetNearestSeedArrayName(const char* name)
{
  const std::string newName = name ? name : "";
  if (this->NearestSeedArrayName != newName)
  {
    this->NearestSeedArrayName = newName;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkFastMarchingGeodesicDistance::GetNearestSeedArrayName()
{
  return this->NearestSeedArrayName.empty() ? nullptr : this->NearestSeedArrayName.c_str();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkFastMarchingGeodesicDistance::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(),
    this->DestinationsWatch.TimeOf(this->DestinationVertexStopCriterion),
    this->ExclusionWatch.TimeOf(this->ExclusionPointIds),
    this->PropagationWeights ? this->PropagationWeights->GetMTime() : 0 });
}

//------------------------------------------------------------------------------
int vtkFastMarchingGeodesicDistance::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->MaximumDistance = 0.0;
  this->NumberOfVisitedPoints = 0;
  try
  {
    const geodesic::bridge::SetUpReporter setUp(*this, 0.2);
    geodesic::FastMarchingSolver& solver = this->Internal->Workspace.solverFor(input);
    const geodesic::TriangleMesh& mesh = solver.mesh();
    const geodesic::bridge::FastMarchingRequest request(
      *this, this->Internal->Workspace.surface(), *this);
    const geodesic::DistanceField& field = solver.solve(request.seeds(), request.options());
    this->MaximumDistance = field.largestDistance();
    this->NumberOfVisitedPoints = geodesic::bridge::numberOfReachedPoints({ mesh, field });
    if (!geodesic::bridge::isAborted(*this))
    {
      if (field.raisedGain() > 0.0)
      {
        vtkWarningMacro(<< geodesic::bridge::settlingNotice(
                          field.raisedGain(), "FastMarching", "Clean or remesh the surface."));
      }
      output->ShallowCopy(input);
      this->AttachArrays(mesh, field, output);
    }
    return 1;
  }
  catch (const geodesic::Interrupted&)
  {
    this->Internal->Workspace.forget();
    geodesic::bridge::setAborted(*this);
    output->Initialize();
    return 1;
  }
  catch (const std::exception& error)
  {
    this->Internal->Workspace.forget();
    output->Initialize();
    vtkErrorMacro(<< geodesic::bridge::messageOf(error));
    return 0;
  }
}

//------------------------------------------------------------------------------
void vtkFastMarchingGeodesicDistance::AttachArrays(const geodesic::TriangleMesh& mesh,
  const geodesic::DistanceField& field, vtkPolyData* output) const
{
  vtkPointData* pointData = output->GetPointData();
  if (!this->FieldDataName.empty())
  {
    const bool hadScalars = pointData->GetScalars() != nullptr;
    pointData->AddArray(geodesic::bridge::distanceArray(
      { mesh, field }, this->NotVisitedValue, this->FieldDataName.c_str()));
    if (!hadScalars)
    {
      pointData->SetActiveScalars(this->FieldDataName.c_str());
    }
  }
  if (!this->NearestSeedArrayName.empty())
  {
    pointData->AddArray(
      geodesic::bridge::nearestSeedArray({ mesh, field }, this->NearestSeedArrayName.c_str()));
  }
}

//------------------------------------------------------------------------------
void vtkFastMarchingGeodesicDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "NumberOfVisitedPoints: " << this->NumberOfVisitedPoints << "\n";
  os << indent << "NotVisitedValue: " << this->NotVisitedValue << "\n";
  os << indent << "DistanceStopCriterion: " << this->DistanceStopCriterion << "\n";
  os << indent << "DestinationVertexStopCriterion: " << this->DestinationVertexStopCriterion
     << "\n";
  os << indent
     << "DestinationStopMode: " << (this->DestinationStopMode == ANY_DESTINATION ? "Any" : "All")
     << "\n";
  os << indent << "ExclusionPointIds: " << this->ExclusionPointIds << "\n";
  os << indent << "PropagationWeights: " << this->PropagationWeights << "\n";
  os << indent << "IterationEventResolution: " << this->IterationEventResolution << "\n";
  os << indent << "NearestSeedArrayName: " << this->NearestSeedArrayName << "\n";
}

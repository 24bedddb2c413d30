// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFastMarchingGeodesicDistance.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "ErrorMessage.h"
#include "FastMarchingSolver.h"
#include "FieldArray.h"
#include "GuideResolver.h"
#include "InputSurface.h"
#include "ProgressReporter.h"
#include "SeedResolver.h"

#include <algorithm>
#include <vector>

/** What is kept from run to run, so that only what changed is computed again. */
struct vtkFastMarchingGeodesicDistance::Internals
{
  std::shared_ptr<const geodesic::bridge::InputSurface> Surface;
  std::unique_ptr<geodesic::FastMarchingSolver> Solver;
  const geodesic::DistanceField* Field = nullptr;

  void prepare(vtkPolyData* input)
  {
    auto surface = geodesic::bridge::InputSurface::of(input, geodesic::CoincidentPoints::Separate);
    if (surface != this->Surface)
    {
      this->Solver = std::make_unique<geodesic::FastMarchingSolver>(surface->mesh());
      this->Surface = std::move(surface);
    }
  }

  void forget() { *this = Internals(); }
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
    this->Solve(input);
    if (!this->GetAbortOutput())
    {
      output->ShallowCopy(input);
      this->AttachArrays(output);
    }
    return 1;
  }
  catch (const std::exception& error)
  {
    this->Internal->forget();
    output->Initialize();
    vtkErrorMacro(<< geodesic::bridge::messageOf(error));
    return 0;
  }
}

//------------------------------------------------------------------------------
void vtkFastMarchingGeodesicDistance::Solve(vtkPolyData* input)
{
  Internals& internal = *this->Internal;
  internal.prepare(input);
  const geodesic::TriangleMesh& mesh = *internal.Surface->mesh();
  const auto seeds = geodesic::bridge::seedsAtPoints(mesh, this->Seeds);
  std::vector<geodesic::Triangle> targets;
  for (geodesic::Index vertex :
    geodesic::bridge::verticesAtPoints(mesh, this->DestinationVertexStopCriterion, "Destination"))
  {
    targets.push_back(geodesic::bridge::targetAt(vertex));
  }
  geodesic::bridge::Barriers barriers;
  geodesic::bridge::excludePoints(mesh, this->ExclusionPointIds, barriers);
  std::vector<double> cost;
  if (this->PropagationWeights)
  {
    cost = geodesic::bridge::costOfArray(mesh, this->PropagationWeights,
      geodesic::bridge::CostMeaning::Cost, "The propagation weight");
  }

  geodesic::SolveOptions options;
  options.cost = cost;
  options.excluded = barriers.excluded;
  options.targets = targets;
  options.targetMode = this->DestinationStopMode == ANY_DESTINATION ? geodesic::TargetMode::Any
                                                                    : geodesic::TargetMode::All;
  if (!(this->DistanceStopCriterion < 0.0))
  {
    options.maximumDistance = this->DistanceStopCriterion;
  }
  geodesic::bridge::ProgressReporter reporter(*this, mesh.numberOfVertices());
  options.progressInterval = static_cast<std::size_t>(this->IterationEventResolution);
  options.onProgress = [&](std::size_t taken)
  {
    this->InvokeEvent(IterationEvent);
    return reporter.report(taken);
  };
  internal.Field = &internal.Solver->solve(seeds, options);
  this->MaximumDistance = internal.Field->largestDistance();
  this->NumberOfVisitedPoints = geodesic::bridge::numberOfReachedPoints({ mesh, *internal.Field });
}

//------------------------------------------------------------------------------
void vtkFastMarchingGeodesicDistance::AttachArrays(vtkPolyData* output)
{
  const Internals& internal = *this->Internal;
  const geodesic::TriangleMesh& mesh = *internal.Surface->mesh();
  vtkPointData* pointData = output->GetPointData();
  if (!this->FieldDataName.empty())
  {
    const bool hadScalars = pointData->GetScalars() != nullptr;
    pointData->AddArray(geodesic::bridge::distanceArray(
      { mesh, *internal.Field }, this->NotVisitedValue, this->FieldDataName.c_str()));
    if (!hadScalars)
    {
      pointData->SetActiveScalars(this->FieldDataName.c_str());
    }
  }
  if (!this->NearestSeedArrayName.empty())
  {
    pointData->AddArray(geodesic::bridge::nearestSeedArray(
      { mesh, *internal.Field }, this->NearestSeedArrayName.c_str()));
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

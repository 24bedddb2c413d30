// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FastMarchingRequest.h"

#include "filter/VtkVersions.h"
#include "mesh/TriangleMesh.h"
#include "request/PointResolver.h"
#include "request/SeedResolver.h"

namespace geodesic::bridge
{

FastMarchingRequest::FastMarchingRequest(
  vtkFastMarchingGeodesicDistance& filter, const InputSurface& surface, vtkAlgorithm& runner)
  : Filter(filter)
  , Runner(runner)
  , Reporter(runner, surface.mesh()->numberOfVertices())
  , Seeds(seedsAtVertices(
      *surface.mesh(), verticesAtPoints(*surface.mesh(), filter.GetSeeds(), "Seed")))
{
  const TriangleMesh& mesh = *surface.mesh();
  for (Index vertex :
    verticesAtPoints(mesh, filter.GetDestinationVertexStopCriterion(), "Destination"))
  {
    this->Targets.push_back(targetAt(vertex));
  }
  excludePoints(mesh, filter.GetExclusionPointIds(), this->Excluded);
  if (vtkDataArray* weights = filter.GetPropagationWeights())
  {
    const std::string role = "The propagation weight";
    std::vector<double> values;
    appendValues(weights, static_cast<vtkIdType>(mesh.numberOfPoints()), role, values);
    this->Cost = costOfValues(surface, values, CostMeaning::Cost, role);
  }

  this->Options.cost = this->Cost;
  this->Options.excluded = this->Excluded.excluded;
  this->Options.targets = this->Targets;
  this->Options.targetMode =
    filter.GetDestinationStopMode() == vtkFastMarchingGeodesicDistance::ANY_DESTINATION
    ? TargetMode::Any
    : TargetMode::All;
  if (!(filter.GetDistanceStopCriterion() < 0.0))
  {
    this->Options.maximumDistance = filter.GetDistanceStopCriterion();
  }
  this->Options.progressInterval = static_cast<std::size_t>(filter.GetIterationEventResolution());
  this->Options.onProgress = [this](std::size_t taken) { return this->mayGoOn(taken); };
}

bool FastMarchingRequest::mayGoOn(std::size_t taken)
{
  this->Filter.InvokeEvent(vtkFastMarchingGeodesicDistance::IterationEvent);
  const bool isAborted = !this->Reporter.report(taken) || this->Filter.GetAbortExecute();
  if (isAborted)
  {
    setAborted(this->Runner);
  }
  return !isAborted;
}

}

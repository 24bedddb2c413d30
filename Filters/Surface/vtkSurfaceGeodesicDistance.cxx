// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceGeodesicDistance.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "DijkstraSolver.h"
#include "ErrorMessage.h"
#include "FastMarchingSolver.h"
#include "FieldArray.h"
#include "InputSurface.h"
#include "ProgressReporter.h"
#include "SeedResolver.h"

#include <limits>
#include <stdexcept>

/** What is kept from run to run, so that only what changed is computed again. */
struct vtkSurfaceGeodesicDistance::Internals
{
  std::shared_ptr<const geodesic::bridge::InputSurface> Surface;
  int Method = FAST_MARCHING;
  std::unique_ptr<geodesic::DistanceSolver> Solver;
  const geodesic::DistanceField* Field = nullptr;

  void prepare(vtkPolyData* input, geodesic::CoincidentPoints coincident, int method)
  {
    auto surface = geodesic::bridge::InputSurface::of(input, coincident);
    if (surface != this->Surface || method != this->Method)
    {
      this->Field = nullptr;
      if (method == DIJKSTRA)
      {
        this->Solver = std::make_unique<geodesic::DijkstraSolver>(surface->mesh());
      }
      else
      {
        this->Solver = std::make_unique<geodesic::FastMarchingSolver>(surface->mesh());
      }
      this->Surface = std::move(surface);
      this->Method = method;
    }
  }

  void forget() { *this = Internals(); }
};

vtkStandardNewMacro(vtkSurfaceGeodesicDistance);

//------------------------------------------------------------------------------
vtkSurfaceGeodesicDistance::vtkSurfaceGeodesicDistance()
  : Internal(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkSurfaceGeodesicDistance::~vtkSurfaceGeodesicDistance() = default;

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::ClearSeedPositions()
{
  this->SeedCoordinates.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::AddSeedPosition(double x, double y, double z)
{
  this->SeedCoordinates.insert(this->SeedCoordinates.end(), { x, y, z });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::AddSeedCoordinate(double coordinate)
{
  this->SeedCoordinates.push_back(coordinate);
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicDistance::GetNumberOfSeedCoordinates()
{
  return static_cast<int>(this->SeedCoordinates.size());
}

//------------------------------------------------------------------------------
double vtkSurfaceGeodesicDistance::GetSeedCoordinate(int index)
{
  return this->SeedCoordinates.at(index);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::SetDistanceArrayName(const char* name)
{
  const std::string newName = name ? name : "";
  if (this->DistanceArrayName != newName)
  {
    this->DistanceArrayName = newName;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkSurfaceGeodesicDistance::GetDistanceArrayName()
{
  return this->DistanceArrayName.c_str();
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicDistance::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  // With composite data among the types the executive hands the blocks over whole.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicDistance::RequestDataObject(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  if (!vtkPolyData::GetData(outputVector))
  {
    vtkNew<vtkPolyData> output;
    outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), output);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicDistance::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->MaximumDistanceReached = 0.0;
  this->NumberOfVisitedPoints = 0;
  try
  {
    vtkPolyData* input = this->GetSurface(inputVector[0]);
    this->Solve(input);
    if (!this->GetAbortOutput())
    {
      output->ShallowCopy(input);
      this->AttachArray(output);
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
vtkPolyData* vtkSurfaceGeodesicDistance::GetSurface(vtkInformationVector* inputVector)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const int ranks = controller ? controller->GetNumberOfProcesses() : 1;
  if (ranks > 1)
  {
    throw std::invalid_argument("The surface is spread over " + std::to_string(ranks) +
      " ranks; this version measures on one rank only. Run it on one.");
  }
  vtkDataObject* input = vtkDataObject::GetData(inputVector);
  vtkPolyData* surface = vtkPolyData::SafeDownCast(input);
  if (!surface)
  {
    throw std::invalid_argument(std::string("The input is a ") + input->GetClassName() +
      ", whose blocks this version does not join to one surface. Merge them first: in ParaView, "
      "Merge Blocks and then Extract Surface.");
  }
  return surface;
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::Solve(vtkPolyData* input)
{
  if (this->SeedCoordinates.empty())
  {
    throw std::invalid_argument("There is no seed to measure from. Set SeedPositions to x, y and z "
                                "of one or more points on or near the surface.");
  }
  Internals& internal = *this->Internal;
  internal.prepare(input,
    this->MergeCoincidentPoints ? geodesic::CoincidentPoints::Merge
                                : geodesic::CoincidentPoints::Separate,
    this->Method);
  const auto seeds = geodesic::bridge::seedsAtPositions(*internal.Surface, this->SeedCoordinates);

  const geodesic::TriangleMesh& mesh = *internal.Surface->mesh();
  geodesic::SolveOptions options;
  if (this->UseMaximumDistance)
  {
    options.maximumDistance = this->MaximumDistance;
  }
  geodesic::bridge::ProgressReporter reporter(*this, mesh.numberOfVertices());
  options.onProgress = [&](std::size_t taken) { return reporter.report(taken); };
  internal.Field = &internal.Solver->solve(seeds, options);
  this->MaximumDistanceReached = internal.Field->largestDistance();
  this->NumberOfVisitedPoints = geodesic::bridge::numberOfReachedPoints(mesh, *internal.Field);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::AttachArray(vtkPolyData* output)
{
  if (this->DistanceArrayName.empty())
  {
    return;
  }
  const double unreached = this->UnreachedAs == UNREACHED_AS_NAN
    ? std::numeric_limits<double>::quiet_NaN()
    : this->UnreachedValue;
  const char* name = this->DistanceArrayName.c_str();
  output->GetPointData()->AddArray(geodesic::bridge::distanceArray(
    *this->Internal->Surface->mesh(), *this->Internal->Field, unreached, name));
  output->GetPointData()->SetActiveScalars(name);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SeedPositions:";
  for (const double coordinate : this->SeedCoordinates)
  {
    os << " " << coordinate;
  }
  os << "\n";
  os << indent << "Method: " << (this->Method == FAST_MARCHING ? "FastMarching" : "Dijkstra")
     << "\n";
  os << indent << "UseMaximumDistance: " << this->UseMaximumDistance << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "DistanceArrayName: " << this->DistanceArrayName << "\n";
  os << indent << "UnreachedAs: " << (this->UnreachedAs == UNREACHED_AS_NAN ? "NaN" : "Value")
     << "\n";
  os << indent << "UnreachedValue: " << this->UnreachedValue << "\n";
  os << indent << "MergeCoincidentPoints: " << this->MergeCoincidentPoints << "\n";
  os << indent << "MaximumDistanceReached: " << this->MaximumDistanceReached << "\n";
  os << indent << "NumberOfVisitedPoints: " << this->NumberOfVisitedPoints << "\n";
}

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceGeodesicDistance.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkConvertSelection.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"

#include "DijkstraSolver.h"
#include "ErrorMessage.h"
#include "FastMarchingSolver.h"
#include "FieldArray.h"
#include "GuideResolver.h"
#include "InputSurface.h"
#include "ProgressReporter.h"
#include "SeedResolver.h"

#include <iterator>
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

/** What the inputs and properties ask the solver for. */
struct vtkSurfaceGeodesicDistance::Guides
{
  std::vector<geodesic::Seed> Seeds;
  std::vector<geodesic::Triangle> Targets;
  geodesic::bridge::Barriers Barriers;
  std::vector<double> Cost;
};

namespace
{

/** The data set on an optional port, null where there is none. */
vtkPointSet* optionalPointSet(vtkInformationVector* inputVector, const char* property)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector);
  vtkPointSet* source = vtkPointSet::SafeDownCast(input);
  if (input && !source)
  {
    throw std::invalid_argument(std::string(property) + " is a " + input->GetClassName() +
      " of several blocks. Merge them first: in ParaView, by Merge Blocks.");
  }
  return source;
}

}

//------------------------------------------------------------------------------
vtkSurfaceGeodesicDistance::vtkSurfaceGeodesicDistance()
  : Internal(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(NUMBER_OF_PORTS);
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
void vtkSurfaceGeodesicDistance::ClearSeedPointIds()
{
  this->SeedPointIds->Reset();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::AddSeedPointId(vtkIdType id)
{
  this->SeedPointIds->InsertNextId(id);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::SetSeedSourceConnection(vtkAlgorithmOutput* source)
{
  this->SetInputConnection(SEED_SOURCE_PORT, source);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::SetSeedSelectionConnection(vtkAlgorithmOutput* selection)
{
  this->SetInputConnection(SEED_SELECTION_PORT, selection);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::SetBarrierSourceConnection(vtkAlgorithmOutput* source)
{
  this->SetInputConnection(BARRIER_SOURCE_PORT, source);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::ClearDestinationPositions()
{
  this->DestinationCoordinates.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::AddDestinationCoordinate(double coordinate)
{
  this->DestinationCoordinates.push_back(coordinate);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::ClearDestinationPointIds()
{
  this->DestinationPointIds->Reset();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::AddDestinationPointId(vtkIdType id)
{
  this->DestinationPointIds->InsertNextId(id);
  this->Modified();
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
int vtkSurfaceGeodesicDistance::FillInputPortInformation(int port, vtkInformation* info)
{
  static const char* const types[NUMBER_OF_PORTS] = { "vtkPolyData", "vtkPointSet", "vtkPointSet",
    "vtkSelection" };
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), types[port]);
  if (port != SEED_SELECTION_PORT)
  {
    // With composite data among the types the executive hands the blocks over whole.
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  if (port != SURFACE_PORT)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
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
    this->Solve(inputVector);
    if (!this->GetAbortOutput())
    {
      output->ShallowCopy(this->GetSurface(inputVector[0]));
      this->AttachArrays(output);
    }
    return 1;
  }
  catch (const std::exception& error)
  {
    // Not 0: after a request that failed ParaView no longer updates the view, and what it shows is
    // stale.
    this->Internal->forget();
    output->Initialize();
    vtkErrorMacro(<< geodesic::bridge::messageOf(error));
    return 1;
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
vtkDataArray* vtkSurfaceGeodesicDistance::GetChosenArray(
  int number, vtkInformationVector** inputVector, bool& isOfCells)
{
  vtkInformation* choice = this->GetInputArrayInformation(number);
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  const std::string wanted = name ? name : "";
  isOfCells = choice->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::CELL;
  if (wanted.empty())
  {
    return nullptr;
  }
  vtkPolyData* input = this->GetSurface(inputVector[0]);
  vtkDataSetAttributes* attributes = isOfCells
    ? static_cast<vtkDataSetAttributes*>(input->GetCellData())
    : static_cast<vtkDataSetAttributes*>(input->GetPointData());
  vtkDataArray* array = attributes->GetArray(wanted.c_str());
  // ParaView's choice of no array is the name None.
  if (!array && wanted != "None")
  {
    static const char* const roles[] = { "SeedArray", "CostArray", "BarrierArray" };
    throw std::invalid_argument(std::string(roles[number]) + " \"" + wanted + "\" is no " +
      (isOfCells ? "cell" : "point") + " array of the input. Choose one that is, or None.");
  }
  return array;
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::Solve(vtkInformationVector** inputVector)
{
  Internals& internal = *this->Internal;
  internal.prepare(this->GetSurface(inputVector[0]),
    this->MergeCoincidentPoints ? geodesic::CoincidentPoints::Merge
                                : geodesic::CoincidentPoints::Separate,
    this->Method);
  Guides guides;
  this->GatherSeeds(inputVector, guides);
  this->GatherTargets(guides);
  this->GatherBarriersAndCost(inputVector, guides);

  const geodesic::TriangleMesh& mesh = *internal.Surface->mesh();
  geodesic::SolveOptions options;
  options.cost = guides.Cost;
  options.excluded = guides.Barriers.excluded;
  options.closedTriangles = guides.Barriers.closed;
  options.targets = guides.Targets;
  options.targetMode = this->DestinationMode == ANY_DESTINATION ? geodesic::TargetMode::Any
                                                                : geodesic::TargetMode::All;
  if (this->UseMaximumDistance)
  {
    options.maximumDistance = this->MaximumDistance;
  }
  geodesic::bridge::ProgressReporter reporter(*this, mesh.numberOfVertices());
  options.onProgress = [&](std::size_t taken) { return reporter.report(taken); };
  internal.Field = &internal.Solver->solve(guides.Seeds, options);
  this->MaximumDistanceReached = internal.Field->largestDistance();
  this->NumberOfVisitedPoints = geodesic::bridge::numberOfReachedPoints(mesh, *internal.Field);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::GatherSeeds(vtkInformationVector** inputVector, Guides& guides)
{
  const geodesic::bridge::InputSurface& surface = *this->Internal->Surface;
  const auto add = [&](std::vector<geodesic::Seed> seeds)
  {
    guides.Seeds.insert(guides.Seeds.end(), std::make_move_iterator(seeds.begin()),
      std::make_move_iterator(seeds.end()));
  };
  add(geodesic::bridge::seedsAtPositions(surface, this->SeedCoordinates));
  add(geodesic::bridge::seedsAtPoints(*surface.mesh(), this->SeedPointIds));
  if (vtkPointSet* source = optionalPointSet(inputVector[SEED_SOURCE_PORT], "SeedSource"))
  {
    add(geodesic::bridge::seedsOfSource(surface, source));
  }
  bool isOfCells = false;
  if (vtkDataArray* array = this->GetChosenArray(SEED_ARRAY, inputVector, isOfCells))
  {
    add(geodesic::bridge::seedsOfArray(surface, array, isOfCells));
  }
  if (vtkSelection* selection = vtkSelection::GetData(inputVector[SEED_SELECTION_PORT]))
  {
    vtkPolyData* input = this->GetSurface(inputVector[SURFACE_PORT]);
    vtkNew<vtkIdTypeArray> points;
    vtkNew<vtkIdTypeArray> cells;
    vtkConvertSelection::GetSelectedPoints(selection, input, points);
    vtkConvertSelection::GetSelectedCells(selection, input, cells);
    add(geodesic::bridge::seedOfIds(surface, points, false));
    add(geodesic::bridge::seedOfIds(surface, cells, true));
  }
  if (guides.Seeds.empty())
  {
    throw std::invalid_argument("There is no seed to measure from. Set SeedPositions to x, y and z "
                                "of one or more points on or near the surface, or give "
                                "SeedPointIds, SeedSource, SeedArray or SeedSelection.");
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::GatherTargets(Guides& guides)
{
  const geodesic::bridge::InputSurface& surface = *this->Internal->Surface;
  for (const geodesic::SurfacePoint& point : geodesic::bridge::surfacePointsAt(
         surface, this->DestinationCoordinates, "DestinationPositions"))
  {
    guides.Targets.push_back(geodesic::bridge::targetAt(*surface.mesh(), point));
  }
  for (geodesic::Index vertex :
    geodesic::bridge::verticesAtPoints(*surface.mesh(), this->DestinationPointIds, "Destination"))
  {
    guides.Targets.push_back(geodesic::bridge::targetAt(vertex));
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::GatherBarriersAndCost(
  vtkInformationVector** inputVector, Guides& guides)
{
  const geodesic::bridge::InputSurface& surface = *this->Internal->Surface;
  bool isOfCells = false;
  if (vtkDataArray* array = this->GetChosenArray(BARRIER_ARRAY, inputVector, isOfCells))
  {
    geodesic::bridge::addBarrierArray(surface, array, isOfCells, guides.Barriers);
  }
  if (vtkPointSet* source = optionalPointSet(inputVector[BARRIER_SOURCE_PORT], "BarrierSource"))
  {
    geodesic::bridge::addBarrierLines(surface, source, guides.Barriers);
  }
  if (vtkDataArray* array = this->GetChosenArray(COST_ARRAY, inputVector, isOfCells))
  {
    if (isOfCells)
    {
      throw std::invalid_argument(std::string("CostArray \"") + array->GetName() +
        "\" is a cell array; give a point array, for example by Cell Data to Point Data.");
    }
    guides.Cost = geodesic::bridge::costOfArray(*surface.mesh(), array,
      this->CostMode == COST ? geodesic::bridge::CostMeaning::Cost
                             : geodesic::bridge::CostMeaning::Speed,
      std::string("CostArray \"") + array->GetName() + "\"");
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::AttachArrays(vtkPolyData* output)
{
  const geodesic::TriangleMesh& mesh = *this->Internal->Surface->mesh();
  const geodesic::DistanceField& field = *this->Internal->Field;
  vtkPointData* pointData = output->GetPointData();
  if (this->ComputeNearestSeed)
  {
    pointData->AddArray(geodesic::bridge::nearestSeedArray(mesh, field, "NearestSeed"));
  }
  if (!this->DistanceArrayName.empty())
  {
    const double unreached = this->UnreachedAs == UNREACHED_AS_NAN
      ? std::numeric_limits<double>::quiet_NaN()
      : this->UnreachedValue;
    const char* name = this->DistanceArrayName.c_str();
    pointData->AddArray(geodesic::bridge::distanceArray(mesh, field, unreached, name));
    pointData->SetActiveScalars(name);
  }
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
  os << indent << "SeedPointIds: " << this->SeedPointIds->GetNumberOfIds() << " ids\n";
  os << indent << "DestinationPositions: " << this->DestinationCoordinates.size() / 3 << "\n";
  os << indent << "DestinationPointIds: " << this->DestinationPointIds->GetNumberOfIds()
     << " ids\n";
  os << indent << "DestinationMode: " << (this->DestinationMode == ANY_DESTINATION ? "Any" : "All")
     << "\n";
  os << indent << "CostMode: " << (this->CostMode == COST ? "Cost" : "Speed") << "\n";
  os << indent << "ComputeNearestSeed: " << this->ComputeNearestSeed << "\n";
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

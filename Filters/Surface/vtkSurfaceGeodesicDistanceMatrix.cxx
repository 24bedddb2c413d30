// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceGeodesicDistanceMatrix.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include "algorithm/LandmarkDistances.h"
#include "algorithm/PathSearches.h"
#include "base/MachineMemory.h"
#include "base/NumberText.h"
#include "base/ThreadTeam.h"
#include "filter/ProgressReporter.h"
#include "filter/VtkVersions.h"
#include "global/GlobalPoints.h"
#include "global/PointsOrSource.h"
#include "input/ArrayValues.h"
#include "input/InputBlocks.h"
#include "input/InputSurface.h"
#include "lines/GlobalLines.h"
#include "lines/LinedSurface.h"
#include "methods/SolverTable.h"
#include "methods/SolverTeam.h"
#include "output/PathAttributes.h"
#include "path/PathFinder.h"
#include "pieces/DistributedSurface.h"
#include "ranks/RankGroup.h"
#include "request/CostAndBarriers.h"
#include "request/SolveSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

/** The state that is kept from run to run, so that only what changed is made again. */
struct vtkSurfaceGeodesicDistanceMatrix::Internals
{
  std::shared_ptr<const geodesic::distributed::DistributedSurface> Surface;
  geodesic::distributed::LinedSurface Lined;
  std::optional<geodesic::bridge::SolveSurface> Solved;
  geodesic::SolverTeam Solvers;
};

/** Both sets of landmarks; all paths lead among the first if there is no second one. */
struct vtkSurfaceGeodesicDistanceMatrix::Landmarks
{
  std::vector<geodesic::distributed::GlobalPoint> First;
  std::vector<geodesic::distributed::GlobalPoint> Second;
  bool HasSecond = false;

  std::size_t numberOfColumns() const
  {
    return this->HasSecond ? this->Second.size() : this->First.size();
  }
};

vtkStandardNewMacro(vtkSurfaceGeodesicDistanceMatrix);

//------------------------------------------------------------------------------
vtkSurfaceGeodesicDistanceMatrix::vtkSurfaceGeodesicDistanceMatrix()
  : Internal(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(NUMBER_OF_PORTS);
}

//------------------------------------------------------------------------------
vtkSurfaceGeodesicDistanceMatrix::~vtkSurfaceGeodesicDistanceMatrix() = default;

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistanceMatrix::ClearLandmarkPositions()
{
  this->LandmarkCoordinates.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistanceMatrix::AddLandmarkCoordinate(double coordinate)
{
  this->LandmarkCoordinates.push_back(coordinate);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistanceMatrix::ClearSecondLandmarkPositions()
{
  this->SecondLandmarkCoordinates.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistanceMatrix::AddSecondLandmarkCoordinate(double coordinate)
{
  this->SecondLandmarkCoordinates.push_back(coordinate);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistanceMatrix::SetLandmarkSourceConnection(vtkAlgorithmOutput* source)
{
  this->SetInputConnection(LANDMARK_SOURCE_PORT, source);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistanceMatrix::SetSecondLandmarkSourceConnection(vtkAlgorithmOutput* source)
{
  this->SetInputConnection(SECOND_LANDMARK_SOURCE_PORT, source);
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicDistanceMatrix::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == SURFACE_PORT ? "vtkDataSet" : "vtkPointSet");
  // The executive passes composite data whole, and not block by block, only if they are among these
  // types.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  if (port != SURFACE_PORT)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicDistanceMatrix::RequestDataObject(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  SetOutputClass(outputVector, "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistanceMatrix::DescribeRequest(std::vector<double>& numbers)
{
  this->Superclass::DescribeRequest(numbers);
  for (const auto* coordinates : { &this->LandmarkCoordinates, &this->SecondLandmarkCoordinates })
  {
    numbers.push_back(static_cast<double>(coordinates->size()));
    numbers.insert(numbers.end(), coordinates->begin(), coordinates->end());
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistanceMatrix::Forget()
{
  *this->Internal = Internals();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistanceMatrix::Compute(geodesic::distributed::RankGroup& ranks,
  const geodesic::bridge::InputBlocks& blocks, vtkInformationVector** inputVector,
  vtkDataObject* output)
{
  this->NumberOfUnjoinedPairs = 0;
  Internals& internal = *this->Internal;
  internal.Surface = this->FindSurface(ranks, blocks);
  Landmarks landmarks = this->GatherLandmarks(ranks, inputVector);
  this->CheckLandmarks(landmarks);
  geodesic::bridge::Barriers barriers;
  std::vector<double> cost;
  const auto barrierLines = geodesic::distributed::globalLinesOf(ranks, *internal.Surface,
    vtkDataObject::GetData(inputVector[BARRIER_SOURCE_PORT]), "BarrierSource");
  this->GatherCostAndBarriers(ranks, blocks, *internal.Surface, barriers, cost);
  if (ranks.isAny(!cost.empty()))
  {
    throw std::invalid_argument(
      "A cost array is set, but Geodesic Distance Matrix does not support costs. Set none, or use "
      "Geodesic Distance from each landmark, which does.");
  }
  const geodesic::bridge::InputPathAttributes attributes(internal.Surface->piece(), blocks);
  const geodesic::SolverTraits& method = this->GetSolver();
  internal.Solved.emplace(internal.Lined.update(ranks,
    { internal.Surface, attributes, {}, barrierLines, barriers, cost, !method.crossesFaces }));
  const auto& mesh = internal.Solved->mesh();
  geodesic::SolveOptions options = internal.Solved->options();
  options.memoryLimit = this->GetMemoryLimitInBytes();
  options.tolerance = this->GetCheckedTolerance();
  ranks.together(
    [&] { geodesic::checkServes(method, geodesic::SolverDemands::of(options, ranks.size())); });
  internal.Solvers.prepare(method, mesh, this->GetThreadsOfRun(ranks));
  this->Open(ranks, landmarks);

  const std::size_t marches = landmarks.HasSecond
    ? std::min(landmarks.First.size(), landmarks.Second.size())
    : landmarks.First.size();
  // With more steps than an index holds, the progress only comes near to 1 more slowly.
  const double steps = std::min<double>(static_cast<double>(marches) * mesh->numberOfVertices(),
    std::numeric_limits<geodesic::Index>::max());
  geodesic::bridge::ProgressReporter reporter(*this, static_cast<geodesic::Index>(steps));
  options.onProgress = [&](std::size_t taken) { return reporter.report(taken); };
  const auto isAborted = [&] { return ranks.isAny(geodesic::bridge::isAborted(*this)); };
  const geodesic::PathStyle style{ method.crossesFaces ? geodesic::PathOrder::Edges
                                                       : geodesic::PathOrder::Vertices,
    method.crossesFaces };
  const geodesic::distributed::PathRequest request{ ranks, *internal.Surface,
    internal.Lined.gathered(), internal.Lined.split(), internal.Lined.divided(),
    internal.Solvers.first(), options, style, attributes };
  geodesic::distributed::PathSearches searches(request, internal.Solvers, isAborted);
  const auto lengths = landmarks.HasSecond
    ? geodesic::distributed::distancesBetween(searches, landmarks.First, landmarks.Second)
    : geodesic::distributed::distancesAmong(searches, landmarks.First);
  if (lengths)
  {
    const auto unjoined = std::count_if(
      lengths->begin(), lengths->end(), [](double length) { return std::isnan(length); });
    this->NumberOfUnjoinedPairs = landmarks.HasSecond ? unjoined : unjoined / 2;
    if (ranks.rank() == 0)
    {
      this->WriteTable(*lengths, landmarks.numberOfColumns(), vtkTable::SafeDownCast(output));
    }
  }
}

//------------------------------------------------------------------------------
vtkSurfaceGeodesicDistanceMatrix::Landmarks vtkSurfaceGeodesicDistanceMatrix::GatherLandmarks(
  geodesic::distributed::RankGroup& ranks, vtkInformationVector** inputVector) const
{
  const geodesic::distributed::DistributedSurface& surface = *this->Internal->Surface;
  vtkDataObject* second = vtkDataObject::GetData(inputVector[SECOND_LANDMARK_SOURCE_PORT]);
  const geodesic::ThreadTeam team = this->GetTeamOfRun(ranks);
  Landmarks landmarks;
  landmarks.First = geodesic::distributed::pointsOrSource(ranks, surface, this->LandmarkCoordinates,
    "LandmarkPositions", vtkDataObject::GetData(inputVector[LANDMARK_SOURCE_PORT]),
    "LandmarkSource", team);
  landmarks.Second =
    geodesic::distributed::pointsOrSource(ranks, surface, this->SecondLandmarkCoordinates,
      "SecondLandmarkPositions", second, "SecondLandmarkSource", team);
  landmarks.HasSecond = ranks.isAny(second != nullptr) || !this->SecondLandmarkCoordinates.empty();
  return landmarks;
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistanceMatrix::CheckLandmarks(const Landmarks& landmarks) const
{
  if (landmarks.First.empty())
  {
    throw std::invalid_argument("There is no landmark. Pick one or more points on the surface, set "
                                "LandmarkPositions to their "
                                "x, y and z, or give a LandmarkSource.");
  }
  if (landmarks.HasSecond && landmarks.Second.empty())
  {
    throw std::invalid_argument(
      "SecondLandmarkSource has no point. Choose one with points, or none "
      "for the distances between the landmarks themselves.");
  }
  constexpr double share = 0.75;
  // The lengths are held twice: by rows, and by columns in the table.
  constexpr double bytesPerLength = 2 * sizeof(double);
  const std::size_t given = this->GetMemoryLimitInBytes();
  const double limit =
    given > 0 ? static_cast<double>(given) : share * static_cast<double>(geodesic::machineMemory());
  const double needed = bytesPerLength * static_cast<double>(landmarks.First.size()) *
    static_cast<double>(landmarks.numberOfColumns());
  if (needed > limit)
  {
    constexpr double gigabyte = 1e9;
    throw std::invalid_argument("A matrix of " + std::to_string(landmarks.First.size()) + " by " +
      std::to_string(landmarks.numberOfColumns()) + " landmarks needs " +
      geodesic::textOf(needed / gigabyte) + " gigabytes, and the limit is " +
      geodesic::textOf(limit / gigabyte) + ". Give fewer landmarks, or a larger MemoryLimit.");
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistanceMatrix::Open(
  geodesic::distributed::RankGroup& ranks, Landmarks& landmarks) const
{
  const Internals& internal = *this->Internal;
  const auto open =
    [&](std::vector<geodesic::distributed::GlobalPoint>& points, const std::string& role)
  {
    points = internal.Lined.relocated(std::move(points));
    ranks.together(
      [&]
      {
        for (std::size_t i = 0; i < points.size(); ++i)
        {
          for (geodesic::SurfacePoint& local : points[i].local)
          {
            local = internal.Solved->openPointOf(local, role + std::to_string(i));
          }
        }
      });
    if (internal.Lined.gathered())
    {
      geodesic::distributed::restate(ranks, internal.Lined.divided(), points);
    }
  };
  open(landmarks.First, "Landmark ");
  open(landmarks.Second, "Second landmark ");
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistanceMatrix::WriteTable(
  const std::vector<double>& lengths, std::size_t numberOfColumns, vtkTable* table)
{
  const auto numberOfRows = static_cast<vtkIdType>(lengths.size() / numberOfColumns);
  vtkNew<vtkIdTypeArray> from;
  from->SetName("From");
  from->SetNumberOfValues(numberOfRows);
  for (vtkIdType row = 0; row < numberOfRows; ++row)
  {
    from->SetValue(row, row);
  }
  table->AddColumn(from);
  for (std::size_t column = 0; column < numberOfColumns; ++column)
  {
    vtkNew<vtkDoubleArray> to;
    to->SetName(("To " + std::to_string(column)).c_str());
    to->SetNumberOfValues(numberOfRows);
    for (vtkIdType row = 0; row < numberOfRows; ++row)
    {
      to->SetValue(row, lengths[row * numberOfColumns + column]);
    }
    table->AddColumn(to);
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistanceMatrix::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LandmarkPositions: " << this->LandmarkCoordinates.size() / 3 << "\n";
  os << indent << "SecondLandmarkPositions: " << this->SecondLandmarkCoordinates.size() / 3 << "\n";
  os << indent << "NumberOfUnjoinedPairs: " << this->NumberOfUnjoinedPairs << "\n";
}

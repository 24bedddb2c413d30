// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceGeodesicSamples.h"

#include "vtkCellArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include "algorithm/DistributedSolver.h"
#include "base/NumberText.h"
#include "filter/ProgressReporter.h"
#include "global/GlobalPoints.h"
#include "global/GlobalSeeds.h"
#include "input/InputBlocks.h"
#include "input/InputSurface.h"
#include "lines/GlobalLines.h"
#include "lines/LinedSurface.h"
#include "methods/SolverTable.h"
#include "methods/SolverTeam.h"
#include "output/BlockOutput.h"
#include "output/FieldArray.h"
#include "output/PathAttributes.h"
#include "pieces/DistributedSurface.h"
#include "ranks/RankGroup.h"
#include "request/CostAndBarriers.h"
#include "request/SolveSurface.h"
#include "split/SplitMesh.h"
#include "survey/FarthestPointSampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace
{

/** The sample's point in the input, as its rank sends it. */
struct Origin
{
  vtkIdType sample;
  vtkIdType id;
  vtkIdType block;
};

/** Whether a vertex of a split mesh was made by splitting it. */
std::vector<std::uint8_t> madeBySplitting(const geodesic::SplitMesh* split)
{
  std::vector<std::uint8_t> isMade;
  if (split)
  {
    isMade.resize(split->mesh()->numberOfVertices());
    for (geodesic::Index vertex = 0; vertex < isMade.size(); ++vertex)
    {
      isMade[vertex] = geodesic::isVertex(split->origin(vertex)) ? 0 : 1;
    }
  }
  return isMade;
}

/** The points without those whose place another one before has. */
std::vector<geodesic::distributed::GlobalPoint> differentOf(
  std::vector<geodesic::distributed::GlobalPoint> points)
{
  std::set<std::array<double, 3>> places;
  std::erase_if(points,
    [&](const geodesic::distributed::GlobalPoint& point) {
      return !places.insert({ point.position.x, point.position.y, point.position.z }).second;
    });
  return points;
}

vtkSmartPointer<vtkIdTypeArray> idArray(const char* name, std::size_t size)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(size));
  array->FillValue(-1);
  return array;
}

}

/** The state that is kept from run to run, so that only what changed is made again. */
struct vtkSurfaceGeodesicSamples::Internals
{
  std::shared_ptr<const geodesic::distributed::DistributedSurface> Surface;
  geodesic::distributed::LinedSurface Lined;
  geodesic::SolverTeam Solvers;
};

vtkStandardNewMacro(vtkSurfaceGeodesicSamples);

//------------------------------------------------------------------------------
vtkSurfaceGeodesicSamples::vtkSurfaceGeodesicSamples()
  : Internal(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(BARRIER_SOURCE_PORT + 1);
  this->SetNumberOfOutputPorts(REGIONS_PORT + 1);
}

//------------------------------------------------------------------------------
vtkSurfaceGeodesicSamples::~vtkSurfaceGeodesicSamples() = default;

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicSamples::ClearFirstPositions()
{
  this->FirstCoordinates.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicSamples::AddFirstCoordinate(double coordinate)
{
  this->FirstCoordinates.push_back(coordinate);
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicSamples::FillInputPortInformation(int port, vtkInformation* info)
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
int vtkSurfaceGeodesicSamples::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkDataObject::DATA_TYPE_NAME(), port == SAMPLES_PORT ? "vtkPolyData" : "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicSamples::RequestDataObject(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Superclass::RequestDataObject(request, inputVector, outputVector);
  vtkDataObject* tree = vtkDataObjectTree::GetData(inputVector[SURFACE_PORT]);
  SetOutputClass(outputVector, tree ? tree->GetClassName() : "vtkPolyData", REGIONS_PORT);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicSamples::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->SamplesTaken = 0;
  this->CoveringRadius = 0.0;
  this->NumberOfUnreachedPoints = 0;
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  if (!this->ErrorText.empty())
  {
    vtkDataObject::GetData(outputVector, REGIONS_PORT)->Initialize();
  }
  return result;
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicSamples::DescribeRequest(std::vector<double>& numbers)
{
  this->Superclass::DescribeRequest(numbers);
  numbers.insert(numbers.end(),
    { static_cast<double>(this->NumberOfSamples), this->Spacing,
      static_cast<double>(this->FirstCoordinates.size()) });
  numbers.insert(numbers.end(), this->FirstCoordinates.begin(), this->FirstCoordinates.end());
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicSamples::Forget()
{
  *this->Internal = Internals();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicSamples::CheckProperties() const
{
  if (!(this->Spacing >= 0.0 && std::isfinite(this->Spacing)))
  {
    throw std::invalid_argument("Spacing is " + geodesic::textOf(this->Spacing) +
      "; give a distance above 0, or 0 to take NumberOfSamples samples.");
  }
  constexpr vtkIdType most = std::numeric_limits<geodesic::Index>::max() - 1;
  if (this->Spacing == 0.0 && (this->NumberOfSamples < 1 || this->NumberOfSamples > most))
  {
    throw std::invalid_argument("NumberOfSamples is " + std::to_string(this->NumberOfSamples) +
      "; give a number from 1 to that of the surface's points, or a Spacing above 0.");
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicSamples::Compute(geodesic::distributed::RankGroup& ranks,
  const geodesic::bridge::InputBlocks& blocks, vtkInformationVector** inputVector,
  vtkDataObject* output)
{
  this->CheckProperties();
  Internals& internal = *this->Internal;
  const geodesic::SolverTraits& method = this->GetSolver();
  internal.Surface = this->FindSurface(ranks, blocks);
  auto first = geodesic::distributed::globalPointsAt(
    ranks, *internal.Surface, this->FirstCoordinates, "FirstPositions");
  const auto barrierLines = geodesic::distributed::globalLinesOf(ranks, *internal.Surface,
    vtkDataObject::GetData(inputVector[BARRIER_SOURCE_PORT]), "BarrierSource");
  if (ranks.size() > 1 && ranks.isAny(barrierLines.size() > 0))
  {
    throw std::invalid_argument(
      "BarrierSource needs the surface on one rank, but it is spread over " +
      std::to_string(ranks.size()) +
      " ranks. Bring it to one rank by Aggregate Dataset, or give a BarrierArray.");
  }
  geodesic::bridge::Barriers barriers;
  std::vector<double> cost;
  this->GatherCostAndBarriers(ranks, blocks, *internal.Surface, barriers, cost);
  const geodesic::bridge::InputPathAttributes attributes(internal.Surface->piece(), blocks);
  const geodesic::bridge::SolveSurface surface = internal.Lined.update(ranks,
    { internal.Surface, attributes, {}, barrierLines, barriers, cost, !method.crossesFaces });
  geodesic::distributed::DistributedSolver partition(ranks, internal.Lined.divided());
  geodesic::SamplingRequest request;
  request.options = surface.options();
  request.options.partition = &partition;
  request.options.memoryLimit = this->GetMemoryLimitInBytes();
  request.options.tolerance = this->GetCheckedTolerance();
  first = differentOf(internal.Lined.relocated(std::move(first)));
  ranks.together(
    [&]
    {
      geodesic::checkServes(method, geodesic::SolverDemands::of(request.options, ranks.size()));
      for (std::size_t i = 0; i < first.size(); ++i)
      {
        for (geodesic::SurfacePoint& local : first[i].local)
        {
          local = surface.openPointOf(local, "First position " + std::to_string(i));
        }
      }
    });
  internal.Solvers.prepare(
    method, surface.mesh(), ranks.size() > 1 ? 1 : this->GetThreadsOfRun(ranks));
  const std::vector<geodesic::Seed> firstPoints = geodesic::distributed::seedsAt(std::move(first));
  const std::vector<std::uint8_t> isMade = madeBySplitting(internal.Lined.split());
  request.firstPoints = firstPoints;
  request.count = this->Spacing > 0.0 ? 0 : static_cast<std::size_t>(this->NumberOfSamples);
  request.spacing = this->Spacing;
  request.neverSamples = isMade;
  constexpr geodesic::Index steps = 1000000;
  geodesic::bridge::ProgressReporter reporter(*this, steps);
  request.onProgress = [&](double part)
  { return reporter.report(static_cast<std::size_t>(part * steps)); };
  const geodesic::Sampling sampling = geodesic::sampleFarthest(internal.Solvers, request);
  if (sampling.isCancelled)
  {
    return;
  }
  this->Measure(ranks, sampling);
  this->WriteSamples(ranks, blocks, sampling, output);
  this->WriteRegions(blocks, sampling, vtkDataObject::GetData(inputVector[SURFACE_PORT]),
    this->GetOutputDataObject(REGIONS_PORT));
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicSamples::Measure(
  geodesic::distributed::RankGroup& ranks, const geodesic::Sampling& sampling)
{
  this->SamplesTaken = static_cast<vtkIdType>(sampling.samples.size());
  this->CoveringRadius = sampling.coveringRadius;
  this->NumberOfUnreachedPoints =
    static_cast<vtkIdType>(ranks.sum(static_cast<double>(sampling.numberOfUnreached)));
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicSamples::WriteSamples(geodesic::distributed::RankGroup& ranks,
  const geodesic::bridge::InputBlocks& blocks, const geodesic::Sampling& sampling,
  vtkDataObject* output) const
{
  const Internals& internal = *this->Internal;
  const geodesic::bridge::InputSurface& piece = internal.Surface->piece();
  const geodesic::bridge::InputPathAttributes attributes(piece, blocks);
  const geodesic::SplitMesh* split = internal.Lined.split();
  geodesic::distributed::RankGroup::Message own;
  for (std::size_t i = 0; i < sampling.samples.size(); ++i)
  {
    if (const geodesic::Index vertex = sampling.samples[i].vertex; vertex != geodesic::NoIndex)
    {
      const geodesic::Index base = split ? split->origin(vertex).carriers()[0] : vertex;
      geodesic::distributed::append(
        own, Origin{ static_cast<vtkIdType>(i), attributes.idOf(base), attributes.blockOf(base) });
    }
  }
  const auto origins = ranks.toFirst(own);
  const bool namesBlocks = ranks.isAny(!piece.numbering().hasUniqueIds());
  if (ranks.rank() != 0)
  {
    return;
  }
  const std::size_t count = sampling.samples.size();
  const auto ids = idArray("OriginalPointIds", count);
  const auto originalBlocks = idArray("OriginalBlocks", count);
  const auto originalRanks = idArray("OriginalRanks", count);
  for (std::size_t rank = 0; rank < origins.size(); ++rank)
  {
    for (const Origin& origin : geodesic::distributed::valuesIn<Origin>(origins[rank]))
    {
      ids->SetValue(origin.sample, origin.id);
      originalBlocks->SetValue(origin.sample, origin.block);
      originalRanks->SetValue(origin.sample, static_cast<vtkIdType>(rank));
    }
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> distances;
  distances->SetName("GeodesicDistance");
  vtkNew<vtkCellArray> vertices;
  for (const geodesic::Sample& sample : sampling.samples)
  {
    const vtkIdType point =
      points->InsertNextPoint(sample.position.x, sample.position.y, sample.position.z);
    vertices->InsertNextCell(1, &point);
    distances->InsertNextValue(std::isfinite(sample.distance) ? sample.distance : -1.0);
  }
  auto* samples = vtkPolyData::SafeDownCast(output);
  samples->SetPoints(points);
  samples->SetVerts(vertices);
  vtkPointData* pointData = samples->GetPointData();
  pointData->SetScalars(distances);
  pointData->AddArray(ids);
  if (namesBlocks)
  {
    pointData->AddArray(originalBlocks);
  }
  if (ranks.size() > 1)
  {
    pointData->AddArray(originalRanks);
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicSamples::WriteRegions(const geodesic::bridge::InputBlocks& blocks,
  const geodesic::Sampling& sampling, vtkDataObject* input, vtkDataObject* output) const
{
  const geodesic::distributed::LinedSurface& lined = this->Internal->Lined;
  const auto& numbering = this->Internal->Surface->piece().numbering();
  geodesic::bridge::writeBlocks(blocks, input, output,
    [&](std::size_t block, vtkPolyData* surface)
    {
      const geodesic::bridge::FieldOnInput field{ *lined.mesh(), sampling.field, lined.split(),
        numbering.firstPointOf(block), static_cast<geodesic::Index>(surface->GetNumberOfPoints()) };
      vtkPointData* pointData = surface->GetPointData();
      pointData->AddArray(geodesic::bridge::distanceArray(field, -1.0, "GeodesicDistance"));
      pointData->AddArray(geodesic::bridge::nearestSeedArray(field, "NearestSeed"));
      pointData->SetActiveScalars("NearestSeed");
    });
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicSamples::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "FirstPositions: " << this->FirstCoordinates.size() / 3 << "\n";
  os << indent << "SamplesTaken: " << this->SamplesTaken << "\n";
  os << indent << "CoveringRadius: " << this->CoveringRadius << "\n";
  os << indent << "NumberOfUnreachedPoints: " << this->NumberOfUnreachedPoints << "\n";
}

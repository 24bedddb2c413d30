// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceGeodesicDistance.h"

#include "vtkDataObjectTree.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationStringKey.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"

#include "algorithm/DealtField.h"
#include "algorithm/DealtRequest.h"
#include "algorithm/DistributedSolver.h"
#include "base/NumberText.h"
#include "base/ThreadTeam.h"
#include "filter/ProgressReporter.h"
#include "filter/SettlingNotice.h"
#include "global/GlobalPoints.h"
#include "global/GlobalSeeds.h"
#include "input/InputBlocks.h"
#include "input/InputSurface.h"
#include "lines/GlobalLines.h"
#include "lines/LinedSurface.h"
#include "lines/SidesOfSeeds.h"
#include "methods/KeptSolver.h"
#include "methods/SolverTable.h"
#include "output/BlockOutput.h"
#include "output/FieldArray.h"
#include "output/PathAttributes.h"
#include "pieces/DistributedSurface.h"
#include "pieces/ThinTriangleNotice.h"
#include "ranks/RankGroup.h"
#include "request/CostAndBarriers.h"
#include "request/SolveSurface.h"

#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

/** The state that is kept from run to run, so that only what changed is computed again. */
struct vtkSurfaceGeodesicDistance::Internals
{
  std::shared_ptr<const geodesic::distributed::DistributedSurface> Surface;
  geodesic::distributed::LinedSurface Lined;
  geodesic::KeptSolver Solver;
  const geodesic::DistanceField* Field = nullptr;
  /** With SpreadWork or GatherForExact on several ranks. */
  geodesic::distributed::DealtField Dealt;
  /** With Signed. */
  geodesic::distributed::SidesOfSeeds Sides;
  /** Of Field; empty if it has no costs. */
  std::string CostArrayName;
  /** With fast marching. */
  geodesic::distributed::ThinTriangleNotice Thin;
  /** Whether there are costs on any rank. */
  bool HasCost = false;
  /** Whether fast marching is to go over intrinsic triangles. */
  bool IsIntrinsic = false;
};

vtkStandardNewMacro(vtkSurfaceGeodesicDistance);
vtkInformationKeyMacro(vtkSurfaceGeodesicDistance, COST_ARRAY_NAME, String);
vtkInformationKeyMacro(vtkSurfaceGeodesicDistance, COST_ARRAY_MODE, Integer);

//------------------------------------------------------------------------------
vtkSurfaceGeodesicDistance::vtkSurfaceGeodesicDistance()
  : Internal(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(NUMBER_OF_PORTS);
}

//------------------------------------------------------------------------------
vtkSurfaceGeodesicDistance::~vtkSurfaceGeodesicDistance() = default;

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
  static const char* const types[NUMBER_OF_PORTS] = { "vtkDataSet", "vtkPointSet", "vtkPointSet",
    "vtkSelection" };
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), types[port]);
  if (port != SEED_SELECTION_PORT)
  {
    // The executive passes composite data whole, and not block by block, only if they are among
    // these types.
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
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* tree = vtkDataObjectTree::GetData(inputVector[SURFACE_PORT]);
  SetOutputClass(outputVector, tree ? tree->GetClassName() : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::Compute(geodesic::distributed::RankGroup& ranks,
  const geodesic::bridge::InputBlocks& blocks, vtkInformationVector** inputVector,
  vtkDataObject* output)
{
  this->MaximumDistanceReached = 0.0;
  this->NumberOfVisitedPoints = 0;
  this->ThinTriangles = 0;
  this->NoticeText.clear();
  this->Solve({ ranks, blocks, inputVector });
  this->CheckUnreachedValue();
  ranks.together(
    [&] { this->Internal->Sides.check(this->Internal->Lined, *this->Internal->Field); });
  if (this->Internal->Field->stopReason() != geodesic::StopReason::Cancelled)
  {
    geodesic::bridge::writeBlocks(blocks, vtkDataObject::GetData(inputVector[SURFACE_PORT]), output,
      [&](std::size_t block, vtkPolyData* surface) { this->AttachArrays(block, surface); });
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::DescribeRequest(std::vector<double>& numbers)
{
  this->Superclass::DescribeRequest(numbers);
  for (const auto* coordinates : { &this->SeedCoordinates, &this->DestinationCoordinates })
  {
    numbers.push_back(static_cast<double>(coordinates->size()));
    numbers.insert(numbers.end(), coordinates->begin(), coordinates->end());
  }
  for (vtkIdList* ids : { this->SeedPointIds.Get(), this->DestinationPointIds.Get() })
  {
    numbers.push_back(static_cast<double>(ids->GetNumberOfIds()));
    for (const vtkIdType id : *ids)
    {
      // A double does not hold all ids.
      numbers.push_back(static_cast<double>(id / (vtkIdType{ 1 } << 32)));
      numbers.push_back(static_cast<double>(id % (vtkIdType{ 1 } << 32)));
    }
  }
  numbers.insert(numbers.end(),
    { static_cast<double>(this->DestinationMode), static_cast<double>(this->UseMaximumDistance),
      this->MaximumDistance, static_cast<double>(this->ComputeNearestSeed),
      static_cast<double>(std::hash<std::string>{}(this->DistanceArrayName)),
      static_cast<double>(this->UnreachedAs), this->UnreachedValue,
      static_cast<double>(this->SpreadWork), static_cast<double>(this->GatherForExact),
      static_cast<double>(this->Signed) });
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::Forget()
{
  *this->Internal = Internals();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::Solve(const Run& run)
{
  Internals& internal = *this->Internal;
  const geodesic::SolverTraits& method = this->GetSolver();
  geodesic::distributed::RankGroup& ranks = run.ranks;
  internal.Surface = this->FindSurface(ranks, run.blocks);
  const auto seedLines = geodesic::distributed::globalLinesOf(ranks, *internal.Surface,
    vtkDataObject::GetData(run.inputVector[SEED_SOURCE_PORT]), "SeedSource");
  const auto barrierLines = geodesic::distributed::globalLinesOf(ranks, *internal.Surface,
    vtkDataObject::GetData(run.inputVector[BARRIER_SOURCE_PORT]), "BarrierSource");
  geodesic::bridge::Barriers barriers;
  std::vector<double> cost;
  this->GatherCostAndBarriers(ranks, run.blocks, *internal.Surface, barriers, cost);
  const char* costArray =
    this->GetInputArrayInformation(COST_ARRAY)->Get(vtkDataObject::FIELD_NAME());
  internal.CostArrayName = cost.empty() || !costArray ? "" : costArray;
  internal.HasCost = ranks.isAny(!cost.empty());
  if (this->Method == FAST_MARCHING)
  {
    internal.Thin.update(ranks, internal.Surface, run.blocks);
    this->ThinTriangles = static_cast<vtkIdType>(internal.Thin.count().thin);
  }
  const geodesic::bridge::InputPathAttributes input(internal.Surface->piece(), run.blocks);
  const geodesic::bridge::SolveSurface surface = internal.Lined.update(ranks,
    { internal.Surface, input, seedLines, barrierLines, barriers, cost, !method.crossesFaces });
  std::vector<geodesic::Seed> seeds = this->GatherSeeds(run, seedLines.size());
  internal.IsIntrinsic = this->Method == FAST_MARCHING &&
    internal.Thin.needOthers(ranks, seeds, internal.HasCost,
      internal.Lined.mesh()->numberOfVertices(), this->GetMemoryLimitInBytes());
  if (this->Signed)
  {
    internal.Sides.update(ranks, internal.Lined, seeds);
  }
  else
  {
    internal.Sides.clear();
  }

  std::vector<geodesic::Triangle> targets;
  geodesic::distributed::DealtSurface::Places destinations;
  for (geodesic::distributed::GlobalPoint& point : this->GatherDestinations(run))
  {
    for (geodesic::SurfacePoint& local : point.local)
    {
      local = surface.pointOf(local);
    }
    targets.push_back(geodesic::distributed::targetAt(*surface.mesh(), point.local));
    destinations.push_back(std::move(point.local));
  }
  geodesic::distributed::DistributedSolver partition(ranks, internal.Lined.divided());
  geodesic::SolveOptions options = surface.options();
  options.partition = &partition;
  options.memoryLimit = this->GetMemoryLimitInBytes();
  options.isIntrinsic = internal.IsIntrinsic;
  options.threads =
    this->GetThreadsOfField(ranks, internal.Thin.count().areMany() && !internal.IsIntrinsic);
  options.tolerance = this->GetCheckedTolerance();
  options.numbersSeeds = this->ComputeNearestSeed;
  options.targets = targets;
  options.targetMode = this->DestinationMode == ANY_DESTINATION ? geodesic::TargetMode::Any
                                                                : geodesic::TargetMode::All;
  if (this->UseMaximumDistance)
  {
    options.maximumDistance = this->MaximumDistance;
  }
  geodesic::bridge::ProgressReporter reporter(*this, surface.mesh()->numberOfVertices());
  options.onProgress = [&](std::size_t taken) { return reporter.report(taken); };

  std::vector<geodesic::Seed> openSeeds;
  ranks.together(
    [&]
    {
      geodesic::checkServes(
        method, geodesic::SolverDemands::of(options, this->Gathers(ranks) ? 1 : ranks.size()));
      openSeeds = surface.seedsOf(seeds);
    });
  if ((this->SpreadWork && ranks.size() > 1) || this->Gathers(ranks))
  {
    this->SolveDealt(run, std::move(openSeeds), options, destinations);
    return;
  }
  internal.Dealt.clear();
  internal.Field = &internal.Solver.get(method, surface.mesh()).solve(openSeeds, options);
  this->ReportWork(run, partition, *internal.Field, internal.Lined.mesh()->numberOfPoints());
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::CheckUnreachedValue() const
{
  const double value = this->UnreachedValue;
  const bool isDistance = value == -1.0 || (value < 0.0 && value >= -this->MaximumDistanceReached);
  if (this->Signed && this->UnreachedAs == UNREACHED_AS_VALUE && isDistance)
  {
    throw std::invalid_argument("UnreachedValue is " + geodesic::textOf(value) +
      ", which with Signed could be a distance on the minus side. The largest distance is " +
      geodesic::textOf(this->MaximumDistanceReached) +
      ". Set UnreachedAs to NaN, or give a value below minus that and other than -1.");
  }
}

//------------------------------------------------------------------------------
bool vtkSurfaceGeodesicDistance::Gathers(const geodesic::distributed::RankGroup& ranks) const
{
  return (this->GatherForExact && this->NeedsOneOf(ranks)) ||
    (this->Internal->IsIntrinsic && ranks.size() > 1);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::SolveDealt(const Run& run, std::vector<geodesic::Seed> seeds,
  const geodesic::SolveOptions& options,
  const std::vector<std::vector<geodesic::SurfacePoint>>& destinations)
{
  Internals& internal = *this->Internal;
  geodesic::distributed::RankGroup& ranks = run.ranks;
  const bool gathers = this->Gathers(ranks);
  if (internal.Lined.gathered() && !gathers)
  {
    throw std::invalid_argument(
      "SpreadWork can't be used with BarrierSource or with lines of SeedSource. Turn it off.");
  }
  geodesic::distributed::Dealing dealing{ gathers };
  // Where intrinsic triangles are depends on all of the surface.
  if (gathers && this->UseMaximumDistance && !internal.IsIntrinsic)
  {
    dealing.distance = this->MaximumDistance;
    dealing.box = geodesic::distributed::boxOf(ranks, internal.Lined.divided().mesh(), seeds);
  }
  internal.Dealt.deal(ranks, internal.Lined.sharedDivided(), dealing);
  const geodesic::distributed::DealtSurface& dealt = internal.Dealt.surface();
  geodesic::distributed::DealtRequest request(
    ranks, dealt, options, std::move(seeds), destinations);
  geodesic::distributed::DistributedSolver partition(ranks, dealt.divided());
  geodesic::DistanceSolver& solver =
    internal.Solver.get(this->GetSolver(), dealt.divided().sharedMesh());
  const geodesic::DistanceField* field = nullptr;
  geodesic::StopReason reason{};
  if (gathers)
  {
    std::tie(field, reason) = geodesic::distributed::solveOnFirst(ranks, request, solver);
  }
  else
  {
    request.options().partition = &partition;
    field = &solver.solve(request.seeds(), request.options());
    reason = field->stopReason();
  }
  internal.Field = &internal.Dealt.takeBack(ranks, field, reason);
  const geodesic::DistanceField none(0);
  this->ReportWork(run, partition, field ? *field : none,
    internal.Lined.mesh()->numberOfPoints() + dealt.mesh().numberOfPoints());
}

//------------------------------------------------------------------------------
const char* vtkSurfaceGeodesicDistance::GetNoticeText()
{
  return this->NoticeText.c_str();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::ReportWork(const Run& run,
  geodesic::distributed::DistributedSolver& partition, const geodesic::DistanceField& solved,
  vtkIdType numberOfPoints)
{
  geodesic::distributed::RankGroup& ranks = run.ranks;
  const Internals& internal = *this->Internal;
  this->MaximumDistanceReached = ranks.largest(solved.largestDistance());
  const vtkIdType visited = ranks.size() == 1
    ? geodesic::bridge::numberOfReachedPoints(
        { internal.Surface->mesh(), solved, internal.Lined.split() })
    : static_cast<vtkIdType>(internal.Lined.numberOfOwnReached(*internal.Field));
  this->NumberOfVisitedPoints = static_cast<vtkIdType>(ranks.sum(static_cast<double>(visited)));
  const geodesic::distributed::DistributedWork work = partition.work();
  this->NumberOfRounds = static_cast<vtkIdType>(work.rounds);
  this->NumberOfUpdates = static_cast<vtkIdType>(work.updates);
  this->LongestChainOfUpdates = static_cast<vtkIdType>(work.longestChain);
  this->BytesExchanged = static_cast<vtkIdType>(work.bytes);
  this->MostPointsOnARank =
    static_cast<vtkIdType>(ranks.largest(static_cast<double>(numberOfPoints)));
  if (this->Method == FAST_MARCHING)
  {
    this->NoticeText = internal.Thin.text(ranks.isAny(solved.isIntrinsic()), internal.HasCost);
  }
  this->NoteSettling(ranks, solved);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::NoteSettling(
  geodesic::distributed::RankGroup& ranks, const geodesic::DistanceField& solved)
{
  const bool isCancelled = solved.stopReason() == geodesic::StopReason::Cancelled;
  const double gain = ranks.largest(isCancelled ? 0.0 : solved.raisedGain());
  if (gain == 0.0)
  {
    return;
  }
  const std::string others =
    this->Method == FAST_MARCHING ? "Exact, Bounded or VirtualSources" : "Exact or Bounded";
  const std::string notice = geodesic::bridge::settlingNotice(gain, this->GetSolver().name,
    this->Internal->HasCost ? "Clean or remesh the surface."
                            : "Use the method " + others + ", or clean or remesh the surface.");
  this->NoticeText += (this->NoticeText.empty() ? "" : " ") + notice;
  vtkWarningMacro(<< notice);
}

//------------------------------------------------------------------------------
std::vector<geodesic::Seed> vtkSurfaceGeodesicDistance::GatherSeeds(
  const Run& run, std::size_t numberOfLines)
{
  const Internals& internal = *this->Internal;
  const geodesic::distributed::DistributedSurface& surface = *this->Internal->Surface;
  std::vector<geodesic::Seed> seeds;
  const auto add = [&](std::vector<geodesic::Seed> more)
  {
    seeds.insert(
      seeds.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  const auto addPoints = [&](std::vector<geodesic::distributed::GlobalPoint> points)
  { add(geodesic::distributed::seedsAt(internal.Lined.relocated(std::move(points)))); };
  addPoints(geodesic::distributed::globalPointsAt(run.ranks, surface, this->SeedCoordinates,
    "SeedPositions", geodesic::distributed::Precision::Double, this->GetTeamOfRun(run.ranks)));
  addPoints(geodesic::distributed::globalPointsWith(
    run.ranks, surface, run.blocks, this->SeedPointIds, "Seed"));
  addPoints(geodesic::distributed::loosePointsOf(
    run.ranks, surface, vtkDataObject::GetData(run.inputVector[SEED_SOURCE_PORT])));
  // SolveSurface::seedsOf() sets the points of these seeds to those of the joined lines.
  seeds.insert(seeds.end(), numberOfLines, geodesic::Seed::alongCurve({}));
  const char* array = this->GetInputArrayInformation(SEED_ARRAY)->Get(vtkDataObject::FIELD_NAME());
  add(geodesic::distributed::seedsOfArray(run.ranks, surface, array ? array : "",
    [&] { return this->GetChosenArray(SEED_ARRAY, run.blocks); }));
  add(geodesic::distributed::seedsOfSelection(run.ranks, surface,
    vtkSelection::GetData(run.inputVector[SEED_SELECTION_PORT]),
    vtkDataObject::GetData(run.inputVector[SURFACE_PORT]), run.blocks));
  if (const auto* gathered = internal.Lined.gathered())
  {
    gathered->relocateRegions(run.ranks, internal.Lined.divided(), internal.Lined.split(), seeds);
  }
  if (seeds.empty())
  {
    throw std::invalid_argument("There is no seed to measure from. Pick one or more points on the "
                                "surface, set SeedPositions to their x, y and z, or give "
                                "SeedPointIds, SeedSource, SeedArray or SeedSelection.");
  }
  return seeds;
}

//------------------------------------------------------------------------------
std::vector<geodesic::distributed::GlobalPoint> vtkSurfaceGeodesicDistance::GatherDestinations(
  const Run& run)
{
  const geodesic::distributed::DistributedSurface& surface = *this->Internal->Surface;
  auto points = geodesic::distributed::globalPointsAt(
    run.ranks, surface, this->DestinationCoordinates, "DestinationPositions");
  for (geodesic::distributed::GlobalPoint& point : geodesic::distributed::globalPointsWith(
         run.ranks, surface, run.blocks, this->DestinationPointIds, "Destination"))
  {
    points.push_back(std::move(point));
  }
  return this->Internal->Lined.relocated(std::move(points));
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicDistance::AttachArrays(std::size_t block, vtkPolyData* output) const
{
  const geodesic::bridge::InputSurface& surface = this->Internal->Surface->piece();
  const geodesic::bridge::FieldOnInput field{ *this->Internal->Lined.mesh(), *this->Internal->Field,
    this->Internal->Lined.split(), surface.numbering().firstPointOf(block),
    static_cast<geodesic::Index>(output->GetNumberOfPoints()), this->Internal->Sides.signs() };
  vtkPointData* pointData = output->GetPointData();
  if (this->ComputeNearestSeed)
  {
    pointData->AddArray(geodesic::bridge::nearestSeedArray(field, "NearestSeed"));
  }
  if (!this->DistanceArrayName.empty())
  {
    const double unreached = this->UnreachedAs == UNREACHED_AS_NAN
      ? std::numeric_limits<double>::quiet_NaN()
      : this->UnreachedValue;
    const char* name = this->DistanceArrayName.c_str();
    const auto distances = geodesic::bridge::distanceArray(field, unreached, name);
    if (!this->Internal->CostArrayName.empty())
    {
      distances->GetInformation()->Set(COST_ARRAY_NAME(), this->Internal->CostArrayName);
      distances->GetInformation()->Set(COST_ARRAY_MODE(), this->CostMode);
    }
    pointData->AddArray(distances);
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
  os << indent << "ComputeNearestSeed: " << this->ComputeNearestSeed << "\n";
  os << indent << "Signed: " << this->Signed << "\n";
  os << indent << "UseMaximumDistance: " << this->UseMaximumDistance << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "DistanceArrayName: " << this->DistanceArrayName << "\n";
  os << indent << "UnreachedAs: " << (this->UnreachedAs == UNREACHED_AS_NAN ? "NaN" : "Value")
     << "\n";
  os << indent << "UnreachedValue: " << this->UnreachedValue << "\n";
  os << indent << "SpreadWork: " << this->SpreadWork << "\n";
  os << indent << "GatherForExact: " << this->GatherForExact << "\n";
  os << indent << "MaximumDistanceReached: " << this->MaximumDistanceReached << "\n";
  os << indent << "NumberOfVisitedPoints: " << this->NumberOfVisitedPoints << "\n";
  os << indent << "ThinTriangles: " << this->ThinTriangles << "\n";
  os << indent << "NoticeText: " << this->NoticeText << "\n";
  os << indent << "NumberOfRounds: " << this->NumberOfRounds << "\n";
  os << indent << "NumberOfUpdates: " << this->NumberOfUpdates << "\n";
  os << indent << "LongestChainOfUpdates: " << this->LongestChainOfUpdates << "\n";
  os << indent << "BytesExchanged: " << this->BytesExchanged << "\n";
  os << indent << "MostPointsOnARank: " << this->MostPointsOnARank << "\n";
}

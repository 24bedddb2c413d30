// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceGeodesicPath.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "algorithm/DistributedPathFinder.h"
#include "algorithm/PathSearches.h"
#include "algorithm/WholeSurface.h"
#include "base/NumberText.h"
#include "base/ThreadTeam.h"
#include "filter/ProgressReporter.h"
#include "filter/VtkVersions.h"
#include "global/GlobalPoints.h"
#include "global/PointsOrSource.h"
#include "input/InputBlocks.h"
#include "input/InputSurface.h"
#include "lines/GlobalLines.h"
#include "lines/LinedSurface.h"
#include "mesh/TriangleMesh.h"
#include "methods/SolverTable.h"
#include "methods/SolverTeam.h"
#include "output/MissingSegments.h"
#include "output/PathAttributes.h"
#include "output/PathOutput.h"
#include "output/SegmentMeasures.h"
#include "path/PathFinder.h"
#include "pieces/DistributedSurface.h"
#include "ranks/RankGroup.h"
#include "request/CostAndBarriers.h"
#include "request/SolveSurface.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

namespace
{

/** The steps of some searches. With more than an index holds, the progress only comes near to 1
 * more slowly. */
geodesic::Index stepsOf(const geodesic::TriangleMesh& mesh, std::size_t searches)
{
  const double steps = static_cast<double>(mesh.numberOfVertices()) * static_cast<double>(searches);
  return static_cast<geodesic::Index>(
    std::min<double>(steps, std::numeric_limits<geodesic::Index>::max()));
}

}

/** The input of a run. */
struct vtkSurfaceGeodesicPath::Run
{
  geodesic::distributed::RankGroup& ranks;
  vtkInformationVector** inputVector;
  geodesic::bridge::InputPathAttributes input;
};

/** A path from one point to another, on the input's own mesh or on a corridor. */
struct vtkSurfaceGeodesicPath::Segment
{
  geodesic::distributed::GlobalPoint From;
  geodesic::distributed::GlobalPoint To;
  /** None if no path joins the points. */
  std::optional<geodesic::distributed::TracedPath> Path;
  /** The waypoint that a start's path leads to. */
  vtkIdType NearestSeed = -1;
  /** Whether it was found as well as can be, and not in a hurry. */
  bool IsFinal = true;
};

/** The state that is kept from run to run, so that only what changed is computed again. */
struct vtkSurfaceGeodesicPath::Internals
{
  std::shared_ptr<const geodesic::distributed::DistributedSurface> Surface;
  geodesic::distributed::LinedSurface Lined;
  geodesic::SolverTeam Solvers;
  // The segments below stay valid as long as these five stay the same on all ranks.
  std::optional<geodesic::bridge::SolveSurface> Solved;
  /** What the corridors of segments hold ids and normals of. On several ranks only. */
  std::vector<geodesic::bridge::ObjectVersion> Attributes;
  int Method = FAST_MARCHING;
  double Tolerance = 0.0;
  geodesic::PathStyle Style;
  std::vector<Segment> Segments;
  /** If the surface is gathered. It stays valid as long as the segments. */
  std::unique_ptr<const geodesic::distributed::WholeSurface> Whole;

  /**
   * Sets what segments depend on, and drops the segments if any of it changed on any rank.
   * Collective.
   */
  void setSurface(const Run& run, geodesic::bridge::SolveSurface solved, int method,
    double tolerance, const geodesic::PathStyle& style)
  {
    std::vector<geodesic::bridge::ObjectVersion> attributes;
    if (run.ranks.size() > 1)
    {
      attributes = run.input.versions();
    }
    const bool isSame = this->Solved && this->Solved->isLike(solved) &&
      this->Attributes == attributes && this->Method == method && this->Tolerance == tolerance &&
      this->Style == style;
    if (run.ranks.isAny(!isSame))
    {
      this->Segments.clear();
      this->Whole.reset();
    }
    this->Solved.emplace(std::move(solved));
    this->Attributes = std::move(attributes);
    this->Method = method;
    this->Tolerance = tolerance;
    this->Style = style;
  }

  /** Converts a path to one on the input's own mesh, unless it is on a corridor. */
  std::optional<geodesic::distributed::TracedPath> onInput(
    std::optional<geodesic::distributed::TracedPath> path) const
  {
    if (path && !path->corridor)
    {
      path->path = this->Solved->basePathOf(path->path);
    }
    return path;
  }

  using Place =
    std::pair<std::array<geodesic::distributed::GlobalVertex, 3>, std::array<double, 3>>;
  /** The places at which a segment begins and ends. */
  using Ends = std::pair<Place, Place>;

  static Ends endsOf(
    const geodesic::distributed::GlobalPoint& from, const geodesic::distributed::GlobalPoint& to)
  {
    return { { from.corners, from.weights }, { to.corners, to.weights } };
  }

  /** The segments of the last run by their ends. */
  std::map<Ends, const Segment*> segmentsByEnds() const
  {
    std::map<Ends, const Segment*> segments;
    for (const Segment& segment : this->Segments)
    {
      segments.emplace(endsOf(segment.From, segment.To), &segment);
    }
    return segments;
  }
};

vtkStandardNewMacro(vtkSurfaceGeodesicPath);

//------------------------------------------------------------------------------
vtkSurfaceGeodesicPath::vtkSurfaceGeodesicPath()
  : Internal(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(NUMBER_OF_PORTS);
}

//------------------------------------------------------------------------------
vtkSurfaceGeodesicPath::~vtkSurfaceGeodesicPath() = default;

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicPath::ClearWaypointPositions()
{
  this->WaypointCoordinates.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicPath::AddWaypointCoordinate(double coordinate)
{
  this->WaypointCoordinates.push_back(coordinate);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicPath::SetWaypointSourceConnection(vtkAlgorithmOutput* source)
{
  this->SetInputConnection(WAYPOINT_SOURCE_PORT, source);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicPath::ClearStartPositions()
{
  this->StartCoordinates.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicPath::AddStartCoordinate(double coordinate)
{
  this->StartCoordinates.push_back(coordinate);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicPath::SetStartSourceConnection(vtkAlgorithmOutput* source)
{
  this->SetInputConnection(START_SOURCE_PORT, source);
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesicPath::FillInputPortInformation(int port, vtkInformation* info)
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
void vtkSurfaceGeodesicPath::DescribeRequest(std::vector<double>& numbers)
{
  this->Superclass::DescribeRequest(numbers);
  for (const auto* coordinates : { &this->WaypointCoordinates, &this->StartCoordinates })
  {
    numbers.push_back(static_cast<double>(coordinates->size()));
    numbers.insert(numbers.end(), coordinates->begin(), coordinates->end());
  }
  numbers.insert(numbers.end(),
    { static_cast<double>(this->Closed), static_cast<double>(this->PathMode),
      static_cast<double>(this->InterpolationOrder), static_cast<double>(this->Straighten),
      static_cast<double>(this->UseMaximumPathLength), this->MaximumPathLength, this->HeightOffset,
      static_cast<double>(this->Dragged), static_cast<double>(this->GatherForExact) });
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicPath::Forget()
{
  *this->Internal = Internals();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicPath::Compute(geodesic::distributed::RankGroup& ranks,
  const geodesic::bridge::InputBlocks& blocks, vtkInformationVector** inputVector,
  vtkDataObject* output)
{
  this->TotalLength = 0.0;
  this->ProvenShortest = 0;
  this->NumberOfSearches = 0;
  this->SegmentLengths->Initialize();
  this->SegmentMiddles->Initialize();
  ranks.together([this] { this->CheckRequest(); });
  Internals& internal = *this->Internal;
  internal.Surface = this->FindSurface(ranks, blocks);
  const Run run{ ranks, inputVector,
    geodesic::bridge::InputPathAttributes(internal.Surface->piece(), blocks) };
  this->MostPointsOnARank = internal.Surface->mostPointsOnARank();
  const Points waypoints = this->GatherPoints(
    run, WAYPOINT_SOURCE_PORT, this->WaypointCoordinates, "WaypointPositions", "WaypointSource");
  const Points starts = this->GatherPoints(
    run, START_SOURCE_PORT, this->StartCoordinates, "StartPositions", "StartSource");
  geodesic::bridge::Barriers barriers;
  std::vector<double> cost;
  const auto barrierLines = geodesic::distributed::globalLinesOf(ranks, *internal.Surface,
    vtkDataObject::GetData(inputVector[BARRIER_SOURCE_PORT]), "BarrierSource");
  this->GatherCostAndBarriers(ranks, blocks, *internal.Surface, barriers, cost);
  const bool hasCost = ranks.isAny(!cost.empty());
  const geodesic::PathStyle style{ this->InterpolationOrder == 0 ? geodesic::PathOrder::Vertices
                                                                 : geodesic::PathOrder::Edges,
    this->Straighten == STRAIGHTEN_AUTO && this->InterpolationOrder == 1 && !hasCost };
  const geodesic::SolverTraits& method = this->GetSolver();
  internal.setSurface(run,
    internal.Lined.update(ranks,
      { internal.Surface, run.input, {}, barrierLines, barriers, cost, !method.crossesFaces }),
    method.number, this->GetCheckedTolerance(), style);
  const auto& mesh = internal.Solved->mesh();
  ranks.together(
    [&]
    {
      geodesic::checkServes(method,
        geodesic::SolverDemands::of(
          internal.Solved->options(), this->Gathers(ranks) ? 1 : ranks.size()));
    });
  internal.Solvers.prepare(method, mesh, this->GetThreadsOfRun(ranks));
  if (!this->Gathers(ranks))
  {
    internal.Whole.reset();
  }
  else if (ranks.isAny(!internal.Whole))
  {
    internal.Whole = std::make_unique<const geodesic::distributed::WholeSurface>(
      ranks, internal.Lined.divided(), internal.Solved->options(), method);
  }
  internal.Segments = this->PathMode == THROUGH_WAYPOINTS
    ? this->TraceThroughWaypoints(run, waypoints)
    : this->TraceToNearest(run, waypoints, starts);
  if (!this->IsAborted(run))
  {
    this->WriteOutput(run, vtkPolyData::SafeDownCast(output));
  }
}

//------------------------------------------------------------------------------
vtkSurfaceGeodesicPath::Points vtkSurfaceGeodesicPath::GatherPoints(const Run& run, int sourcePort,
  const std::vector<double>& coordinates, const char* positions, const char* source) const
{
  return geodesic::distributed::pointsOrSource(run.ranks, *this->Internal->Surface, coordinates,
    positions, vtkDataObject::GetData(run.inputVector[sourcePort]), source,
    this->GetTeamOfRun(run.ranks));
}

//------------------------------------------------------------------------------
vtkSurfaceGeodesicPath::Points vtkSurfaceGeodesicPath::OpenPoints(
  const Run& run, const Points& points, const std::string& role) const
{
  Points openPoints = this->Internal->Lined.relocated(points);
  run.ranks.together(
    [&]
    {
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        for (geodesic::SurfacePoint& local : openPoints[i].local)
        {
          local = this->Internal->Solved->openPointOf(local, role + " " + std::to_string(i));
        }
      }
    });
  if (this->Internal->Lined.gathered())
  {
    geodesic::distributed::restate(run.ranks, this->Internal->Lined.divided(), openPoints);
  }
  return openPoints;
}

//------------------------------------------------------------------------------
geodesic::distributed::PathRequest vtkSurfaceGeodesicPath::MakeRequest(const Run& run)
{
  Internals& internal = *this->Internal;
  geodesic::SolveOptions options = internal.Solved->options();
  options.memoryLimit = this->GetMemoryLimitInBytes();
  options.tolerance = this->GetCheckedTolerance();
  return { run.ranks, *internal.Surface, internal.Lined.gathered(), internal.Lined.split(),
    internal.Lined.divided(), internal.Solvers.first(), options, internal.Style, run.input,
    internal.Whole.get() };
}

//------------------------------------------------------------------------------
bool vtkSurfaceGeodesicPath::Gathers(const geodesic::distributed::RankGroup& ranks) const
{
  return this->GatherForExact && this->NeedsOneOf(ranks);
}

//------------------------------------------------------------------------------
bool vtkSurfaceGeodesicPath::IsAborted(const Run& run)
{
  return run.ranks.isAny(geodesic::bridge::isAborted(*this));
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicPath::CheckRequest() const
{
  if (this->UseMaximumPathLength && !(this->MaximumPathLength >= 0.0))
  {
    throw std::invalid_argument("MaximumPathLength is " +
      geodesic::textOf(this->MaximumPathLength) + "; it must be at least 0.");
  }
}

//------------------------------------------------------------------------------
std::vector<vtkSurfaceGeodesicPath::Segment> vtkSurfaceGeodesicPath::TraceThroughWaypoints(
  const Run& run, const Points& waypoints)
{
  if (waypoints.size() < 2)
  {
    throw std::invalid_argument(
      "A path needs at least two waypoints, but the number of waypoints is " +
      std::to_string(waypoints.size()) +
      ". Pick two or more points on the surface, set WaypointPositions to their x, y and "
      "z, or give a WaypointSource.");
  }
  Internals& internal = *this->Internal;
  const Points points = this->OpenPoints(run, waypoints, "Waypoint");
  const auto knownSegments = internal.segmentsByEnds();
  const std::size_t count = this->Closed ? waypoints.size() : waypoints.size() - 1;
  std::vector<Segment> segments;
  std::vector<std::size_t> unknown;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t next = (i + 1) % waypoints.size();
    const auto known = knownSegments.find(Internals::endsOf(waypoints[i], waypoints[next]));
    if (known != knownSegments.end() && (known->second->IsFinal || this->Dragged))
    {
      segments.push_back(*known->second);
    }
    else
    {
      segments.push_back({ waypoints[i], waypoints[next], {} });
      unknown.push_back(i);
    }
  }
  geodesic::distributed::PathRequest request = this->MakeRequest(run);
  const bool gainsByBothEnds = this->Straighten == STRAIGHTEN_AUTO &&
    this->InterpolationOrder == 1 && this->GetSolver().crossesFaces;
  const bool fromBothEnds = gainsByBothEnds && !this->Dragged;
  geodesic::bridge::ProgressReporter reporter(*this,
    stepsOf(
      request.solver.mesh(), std::max<std::size_t>(unknown.size(), 1) * (fromBothEnds ? 2 : 1)));
  request.options.onProgress = [&](std::size_t taken) { return reporter.report(taken); };
  geodesic::distributed::PathSearches searches(
    request, internal.Solvers, [&] { return this->IsAborted(run); });
  std::vector<geodesic::distributed::PointPair> pairs;
  for (const std::size_t i : unknown)
  {
    pairs.push_back({ points[i], points[(i + 1) % waypoints.size()] });
  }
  auto outcomes = searches.betweenAll(pairs, fromBothEnds);
  std::vector<bool> areMade(count, true);
  for (std::size_t number = 0; number < unknown.size(); ++number)
  {
    Segment& segment = segments[unknown[number]];
    segment.Path = internal.onInput(std::move(outcomes[number].path));
    segment.IsFinal =
      fromBothEnds || !gainsByBothEnds || (segment.Path && segment.Path->isProvenShortest);
    areMade[unknown[number]] = outcomes[number].isMade;
  }
  const auto left = std::count(areMade.begin(), areMade.end(), false);
  this->NumberOfSearches = static_cast<vtkIdType>(unknown.size()) - left;
  if (!unknown.empty())
  {
    this->MostPointsOnARank = std::max(this->MostPointsOnARank, searches.mostPointsOnARank());
  }
  if (left > 0)
  {
    // An aborted search tells nothing about whether there is a path, so no later run may find it.
    std::vector<Segment> made;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (areMade[i])
      {
        made.push_back(std::move(segments[i]));
      }
    }
    return made;
  }
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!segments[i].Path)
    {
      missing.push_back("from waypoint " + std::to_string(i) + " to waypoint " +
        std::to_string((i + 1) % waypoints.size()));
    }
  }
  this->ReportMissing(missing, segments.size());
  return segments;
}

//------------------------------------------------------------------------------
std::vector<vtkSurfaceGeodesicPath::Segment> vtkSurfaceGeodesicPath::TraceToNearest(
  const Run& run, const Points& waypoints, const Points& starts)
{
  if (waypoints.empty() || starts.empty())
  {
    throw std::invalid_argument(
      "ToNearestSeed needs at least one waypoint and one start, but there are " +
      std::to_string(waypoints.size()) + " waypoints and " + std::to_string(starts.size()) +
      " starts. Pick them on the surface, set WaypointPositions and StartPositions, or give a "
      "WaypointSource and a StartSource.");
  }
  Internals& internal = *this->Internal;
  const Points ends = this->OpenPoints(run, waypoints, "Waypoint");
  const Points points = this->OpenPoints(run, starts, "Start");
  geodesic::distributed::PathRequest request = this->MakeRequest(run);
  geodesic::bridge::ProgressReporter reporter(*this, request.solver.mesh().numberOfVertices());
  request.options.onProgress = [&](std::size_t taken) { return reporter.report(taken); };
  geodesic::distributed::PathSearches searches(
    request, internal.Solvers, [&] { return this->IsAborted(run); });
  std::vector<Segment> segments;
  std::vector<std::string> missing;
  auto found = searches.fromStarts(points, ends);
  for (std::size_t i = 0; i < starts.size() && found[i].isMade; ++i)
  {
    ++this->NumberOfSearches;
    auto path = internal.onInput(std::move(found[i].path));
    if (path)
    {
      const geodesic::Index end = path->end;
      segments.push_back({ starts[i], waypoints[end], std::move(path), end });
    }
    else
    {
      segments.emplace_back();
      missing.push_back("from start " + std::to_string(i) + " to any waypoint");
    }
  }
  this->MostPointsOnARank = searches.mostPointsOnARank();
  this->ReportMissing(missing, segments.size());
  return segments;
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicPath::ReportMissing(
  const std::vector<std::string>& missing, std::size_t segments)
{
  if (!missing.empty())
  {
    this->Report(geodesic::bridge::messageOfMissing(missing, segments));
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicPath::WriteOutput(const Run& run, vtkPolyData* output)
{
  const Internals& internal = *this->Internal;
  // On several ranks, paths have global ids or none.
  const bool namesBlocks =
    run.ranks.size() == 1 && !internal.Surface->piece().numbering().hasUniqueIds();
  geodesic::bridge::PathOutput paths(this->HeightOffset, namesBlocks);
  if (this->UseMaximumPathLength)
  {
    paths.limitLength(this->MaximumPathLength, this->InterpolationOrder == 1);
  }
  const bool isChain = this->PathMode == THROUGH_WAYPOINTS;
  vtkNew<vtkIdTypeArray> nearestSeeds;
  nearestSeeds->SetName("NearestSeed");
  for (std::size_t i = 0; i < internal.Segments.size(); ++i)
  {
    const Segment& segment = internal.Segments[i];
    // The first of several ranks has all paths.
    if (segment.Path && run.ranks.rank() == 0)
    {
      const geodesic::distributed::TracedPath& path = *segment.Path;
      const geodesic::bridge::PathAttributes& attributes = path.corridor
        ? static_cast<const geodesic::bridge::PathAttributes&>(*path.corridor)
        : run.input;
      paths.add(attributes, path.path, static_cast<vtkIdType>(i));
      nearestSeeds->InsertNextValue(segment.NearestSeed);
    }
  }
  if (!paths.writeTo(output, isChain, this->GetTeamOfRun(run.ranks)))
  {
    return;
  }
  if (!isChain)
  {
    output->GetCellData()->AddArray(nearestSeeds);
  }
  this->TotalLength = run.ranks.sum(paths.totalLength());
  this->ProvenShortest =
    static_cast<int>(std::count_if(internal.Segments.begin(), internal.Segments.end(),
      [](const Segment& segment) { return segment.Path && segment.Path->isProvenShortest; }));
  if (isChain && run.ranks.rank() == 0)
  {
    geodesic::bridge::measureSegments(output, static_cast<vtkIdType>(internal.Segments.size()),
      this->SegmentLengths, this->SegmentMiddles);
  }
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkSurfaceGeodesicPath::GetSegmentLengths()
{
  return this->SegmentLengths;
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkSurfaceGeodesicPath::GetSegmentMiddles()
{
  return this->SegmentMiddles;
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicPath::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WaypointPositions: " << this->WaypointCoordinates.size() / 3 << "\n";
  os << indent << "Closed: " << this->Closed << "\n";
  os << indent
     << "PathMode: " << (this->PathMode == THROUGH_WAYPOINTS ? "ThroughWaypoints" : "ToNearestSeed")
     << "\n";
  os << indent << "StartPositions: " << this->StartCoordinates.size() / 3 << "\n";
  os << indent << "InterpolationOrder: " << this->InterpolationOrder << "\n";
  os << indent << "Straighten: " << (this->Straighten == STRAIGHTEN_AUTO ? "Auto" : "Off") << "\n";
  os << indent << "UseMaximumPathLength: " << this->UseMaximumPathLength << "\n";
  os << indent << "MaximumPathLength: " << this->MaximumPathLength << "\n";
  os << indent << "HeightOffset: " << this->HeightOffset << "\n";
  os << indent << "Dragged: " << this->Dragged << "\n";
  os << indent << "GatherForExact: " << this->GatherForExact << "\n";
  os << indent << "TotalLength: " << this->TotalLength << "\n";
  os << indent << "ProvenShortest: " << this->ProvenShortest << "\n";
  os << indent << "NumberOfSearches: " << this->NumberOfSearches << "\n";
  os << indent << "MostPointsOnARank: " << this->MostPointsOnARank << "\n";
}

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceGeodesicPath.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "Abort.h"
#include "DistanceSolver.h"
#include "GuideResolver.h"
#include "InputBlocks.h"
#include "InputSurface.h"
#include "NumberText.h"
#include "PathFinder.h"
#include "PathOutput.h"
#include "PointResolver.h"
#include "ProgressReporter.h"
#include "RankGroup.h"
#include "SolveSurface.h"
#include "SplitMesh.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>

/** A path on the input's own mesh, from one of its points to another. */
struct vtkSurfaceGeodesicPath::Segment
{
  geodesic::SurfacePoint From;
  geodesic::SurfacePoint To;
  /** None where there is no route. */
  std::optional<geodesic::SurfacePath> Path;
  /** The waypoint that a start's path leads to. */
  vtkIdType NearestSeed = -1;
};

/** What is kept from run to run, so that only what changed is computed again. */
struct vtkSurfaceGeodesicPath::Internals
{
  std::shared_ptr<const geodesic::bridge::InputSurface> Surface;
  geodesic::bridge::SurfaceLines Lines;
  std::unique_ptr<geodesic::DistanceSolver> Solver;
  // Segments are the same as long as all this is.
  std::optional<geodesic::bridge::SolveSurface> Ground;
  int Method = FAST_MARCHING;
  geodesic::PathStyle Style;
  std::vector<Segment> Segments;

  /** Takes on what segments depend on, and drops those that no longer hold. */
  void setGround(
    geodesic::bridge::SolveSurface ground, int method, const geodesic::PathStyle& style)
  {
    const bool isSame = this->Ground && this->Ground->isLike(ground) && this->Method == method &&
      this->Style == style;
    if (!isSame)
    {
      this->Segments.clear();
    }
    this->Ground.emplace(std::move(ground));
    this->Method = method;
    this->Style = style;
  }

  const Segment* find(const geodesic::SurfacePoint& from, const geodesic::SurfacePoint& to) const
  {
    const auto found = std::find_if(this->Segments.begin(), this->Segments.end(),
      [&](const Segment& segment) { return segment.From == from && segment.To == to; });
    return found == this->Segments.end() ? nullptr : &*found;
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
  // With composite data among the types the executive hands the blocks over whole.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  if (port != SURFACE_PORT)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
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
  if (ranks.size() > 1)
  {
    throw std::invalid_argument("The surface is spread over " + std::to_string(ranks.size()) +
      " ranks, where this version finds no paths. Run Geodesic Path on one rank.");
  }
  this->CheckRequest();
  Internals& internal = *this->Internal;
  internal.Surface = this->FindSurface(blocks);
  const auto waypoints = this->GatherPoints(inputVector[WAYPOINT_SOURCE_PORT],
    this->WaypointCoordinates, "WaypointPositions", "WaypointSource");
  const auto starts = this->GatherPoints(
    inputVector[START_SOURCE_PORT], this->StartCoordinates, "StartPositions", "StartSource");
  geodesic::bridge::Barriers barriers;
  this->GatherBarriers(blocks, inputVector, *internal.Surface, barriers);
  const std::vector<double> cost = this->GatherCost(blocks, *internal.Surface);
  internal.Lines.update(internal.Surface->mesh(), {}, std::move(barriers.lines));
  const geodesic::PathStyle style{ this->InterpolationOrder == 0 ? geodesic::PathOrder::Vertices
                                                                 : geodesic::PathOrder::Edges,
    this->Straighten == STRAIGHTEN_AUTO && this->InterpolationOrder == 1 && cost.empty() };
  const bool hadMethod = internal.Method == this->Method;
  internal.setGround(geodesic::bridge::SolveSurface(
                       internal.Surface, internal.Lines, barriers, cost, this->Method == DIJKSTRA),
    this->Method, style);
  const geodesic::bridge::SolveSurface& ground = *internal.Ground;
  if (!internal.Solver || &internal.Solver->mesh() != ground.mesh().get() || !hadMethod)
  {
    internal.Solver = this->MakeSolver(ground.mesh());
  }

  internal.Segments = this->PathMode == THROUGH_WAYPOINTS
    ? this->TraceThroughWaypoints(ground, waypoints)
    : this->TraceToNearest(ground, waypoints, starts);
  if (!geodesic::bridge::isAborted(*this))
  {
    this->WriteOutput(blocks, vtkPolyData::SafeDownCast(output));
  }
}

//------------------------------------------------------------------------------
std::vector<geodesic::SurfacePoint> vtkSurfaceGeodesicPath::GatherPoints(
  vtkInformationVector* sourceVector, const std::vector<double>& coordinates, const char* positions,
  const char* source) const
{
  const geodesic::bridge::InputSurface& surface = *this->Internal->Surface;
  vtkDataObject* points = vtkDataObject::GetData(sourceVector);
  if (points && !coordinates.empty())
  {
    throw std::invalid_argument(std::string(positions) + " has " +
      std::to_string(coordinates.size()) + " numbers, and " + source +
      " is set as well: take one of them away.");
  }
  return points
    ? geodesic::bridge::surfacePointsOf(surface, geodesic::bridge::PointSource(points), source)
    : geodesic::bridge::surfacePointsAt(surface, coordinates, positions);
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
  const geodesic::bridge::SolveSurface& ground,
  const std::vector<geodesic::SurfacePoint>& waypoints)
{
  if (waypoints.size() < 2)
  {
    throw std::invalid_argument("There are " + std::to_string(waypoints.size()) +
      " waypoints; a path needs two at least. Set WaypointPositions to x, y and z of two or more "
      "points on or near the surface, or give a WaypointSource.");
  }
  const Internals& internal = *this->Internal;
  std::vector<geodesic::SurfacePoint> points;
  for (const geodesic::SurfacePoint& waypoint : waypoints)
  {
    points.push_back(ground.openPointOf(waypoint, "Waypoint " + std::to_string(points.size())));
  }
  std::vector<Segment> segments;
  std::string missing;
  const std::size_t count = this->Closed ? waypoints.size() : waypoints.size() - 1;
  for (std::size_t i = 0; i < count && !geodesic::bridge::isAborted(*this); ++i)
  {
    const std::size_t next = (i + 1) % waypoints.size();
    const Segment* known = internal.find(waypoints[i], waypoints[next]);
    if (known)
    {
      segments.push_back(*known);
    }
    else
    {
      geodesic::bridge::ProgressReporter reporter(*this, ground.mesh()->numberOfVertices());
      geodesic::SolveOptions options = ground.options();
      options.onProgress = [&](std::size_t taken) { return reporter.report(taken); };
      const auto path =
        geodesic::shortestPath(*internal.Solver, points[i], points[next], options, internal.Style);
      segments.push_back({ waypoints[i], waypoints[next],
        path ? std::optional(ground.basePathOf(*path)) : std::nullopt });
    }
    if (!segments.back().Path && !geodesic::bridge::isAborted(*this))
    {
      missing += (missing.empty() ? "" : ", or ") + std::string("from waypoint ") +
        std::to_string(i) + " to waypoint " + std::to_string(next);
    }
  }
  this->ReportMissing(missing);
  return segments;
}

//------------------------------------------------------------------------------
std::vector<vtkSurfaceGeodesicPath::Segment> vtkSurfaceGeodesicPath::TraceToNearest(
  const geodesic::bridge::SolveSurface& ground,
  const std::vector<geodesic::SurfacePoint>& waypoints,
  const std::vector<geodesic::SurfacePoint>& starts)
{
  if (waypoints.empty() || starts.empty())
  {
    throw std::invalid_argument("There are " + std::to_string(waypoints.size()) +
      " waypoints and " + std::to_string(starts.size()) +
      " starts; ToNearestSeed needs one of each at least. Set WaypointPositions and "
      "StartPositions, or give a WaypointSource and a StartSource.");
  }
  const Internals& internal = *this->Internal;
  std::vector<geodesic::SurfacePoint> ends;
  for (const geodesic::SurfacePoint& waypoint : waypoints)
  {
    ends.push_back(ground.openPointOf(waypoint, "Waypoint " + std::to_string(ends.size())));
  }
  std::vector<geodesic::SurfacePoint> points;
  for (const geodesic::SurfacePoint& start : starts)
  {
    points.push_back(ground.openPointOf(start, "Start " + std::to_string(points.size())));
  }
  geodesic::bridge::ProgressReporter reporter(*this, ground.mesh()->numberOfVertices());
  geodesic::SolveOptions options = ground.options();
  options.onProgress = [&](std::size_t taken) { return reporter.report(taken); };
  geodesic::PathFinder finder(*internal.Solver, ends, options, internal.Style);
  if (!finder.march(points))
  {
    return {};
  }

  std::vector<Segment> segments;
  std::string missing;
  for (std::size_t i = 0; i < starts.size() && !geodesic::bridge::isAborted(*this); ++i)
  {
    const auto path = finder.pathFrom(points[i]);
    Segment& segment = segments.emplace_back();
    if (path)
    {
      const auto isEnd = [&](const geodesic::SurfacePoint& end)
      { return geodesic::PathPoint::at(*ground.mesh(), end) == path->back(); };
      const auto end = std::find_if(ends.begin(), ends.end(), isEnd) - ends.begin();
      segment = { starts[i], waypoints[end], ground.basePathOf(*path), end };
    }
    else
    {
      missing += (missing.empty() ? "" : ", or ") + std::string("from start ") + std::to_string(i) +
        " to any waypoint";
    }
  }
  this->ReportMissing(missing);
  return segments;
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicPath::ReportMissing(const std::string& missing)
{
  if (!missing.empty())
  {
    vtkErrorMacro(<< "No way over the surface leads " << missing
                  << ". All other segments are there. Connect the parts of the surface, open the "
                     "barriers, or move the points.");
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesicPath::WriteOutput(
  const geodesic::bridge::InputBlocks& blocks, vtkPolyData* output)
{
  const Internals& internal = *this->Internal;
  const geodesic::TriangleMesh& mesh = *internal.Surface->mesh();
  geodesic::bridge::PathOutput paths(*internal.Surface, blocks, this->HeightOffset);
  const double maximumLength =
    this->UseMaximumPathLength ? this->MaximumPathLength : std::numeric_limits<double>::infinity();
  const bool isChain = this->PathMode == THROUGH_WAYPOINTS;
  vtkNew<vtkIdTypeArray> nearestSeeds;
  nearestSeeds->SetName("NearestSeed");
  double arcLength = 0.0;
  for (std::size_t i = 0; i < internal.Segments.size(); ++i)
  {
    const Segment& segment = internal.Segments[i];
    if (segment.Path)
    {
      const double length =
        paths.add(geodesic::beginningOf(mesh, *segment.Path, maximumLength,
                    std::numeric_limits<std::size_t>::max(), this->InterpolationOrder == 1),
          static_cast<vtkIdType>(i), isChain ? arcLength : 0.0);
      arcLength += length;
      nearestSeeds->InsertNextValue(segment.NearestSeed);
    }
  }
  paths.writeTo(output);
  if (!isChain)
  {
    output->GetCellData()->AddArray(nearestSeeds);
  }
  this->TotalLength = paths.totalLength();
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
  os << indent << "TotalLength: " << this->TotalLength << "\n";
}

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFastMarchingGeodesicPath.h"

#include "vtkCellArray.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include "FastMarchingRequest.h"
#include "FastMarchingWorkspace.h"
#include "base/NumberText.h"
#include "filter/ErrorMessage.h"
#include "filter/SetUpReporter.h"
#include "filter/VtkVersions.h"
#include "path/PathFinder.h"
#include "request/PointResolver.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

using geodesic::Index;
using geodesic::PathPoint;
using geodesic::SurfacePath;
using geodesic::TriangleMesh;

namespace
{

/**
 * The largest distance from a vertex to its neighbours. A front with a stop goes on that much
 * farther, so that a path from just before the stop is traced as well as any other.
 */
double reachOf(const TriangleMesh& mesh, Index vertex, std::span<const double> cost)
{
  double dearest = cost.empty() ? 1.0 : cost[vertex];
  for (const geodesic::RingEntry& entry : mesh.ring(vertex))
  {
    dearest = cost.empty() ? 1.0 : std::max(dearest, cost[entry.neighbour()]);
  }
  return dearest * mesh.longestEdgeAround(vertex);
}

/** Returns the distance at which the options stop a front. */
double stopOf(const TriangleMesh& mesh, const geodesic::SolveOptions& options,
  const geodesic::DistanceField& field)
{
  geodesic::StopLimit limit(mesh, options, field);
  limit.update();
  return limit.value();
}

std::runtime_error noRoute(vtkIdType begin, vtkIdList* seeds, double stop)
{
  constexpr vtkIdType mostNamed = 5;
  const vtkIdType count = seeds->GetNumberOfIds();
  std::string message = "There is no path from begin point " + std::to_string(begin) + " to " +
    (count == 1 ? "seed point " : "any of the seed points ");
  for (vtkIdType i = 0; i < std::min(count, mostNamed); ++i)
  {
    message += (i > 0 ? ", " : "") + std::to_string(seeds->GetId(i));
  }
  message += count > mostNamed ? ", ..." : "";
  message += stop < geodesic::DistanceField::Unreached
    ? " within the distance " + geodesic::textOf(stop) +
      ", where DistanceStopCriterion or DestinationVertexStopCriterion stops the front. Raise the "
      "stop, or take it away."
    : ": they are on parts of the surface that are not connected, or exclusion points lie between "
      "them. Choose other points; merge coincident ones (Clean) where parts merely touch.";
  return std::runtime_error(message);
}

/** Returns the ends of the edge that a point of a path lies on, the nearer one first. */
std::array<Index, 2> edgeOf(const TriangleMesh& mesh, const PathPoint& point)
{
  const geodesic::Carriers ends = point.carriers();
  if (ends.size() == 1)
  {
    return { ends[0], mesh.ring(ends[0]).front().neighbour() };
  }
  const bool isFirstNearer = weightOf(point, ends[0]) >= weightOf(point, ends[1]);
  return { ends[isFirstNearer ? 0 : 1], ends[isFirstNearer ? 1 : 0] };
}

}

struct vtkFastMarchingGeodesicPath::Internals
{
  geodesic::bridge::FastMarchingWorkspace Workspace;
};

vtkStandardNewMacro(vtkFastMarchingGeodesicPath);

//------------------------------------------------------------------------------
vtkFastMarchingGeodesicPath::vtkFastMarchingGeodesicPath()
  : MaximumPathPoints(VTK_ID_MAX)
  , Internal(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkFastMarchingGeodesicPath::~vtkFastMarchingGeodesicPath() = default;

//------------------------------------------------------------------------------
void vtkFastMarchingGeodesicPath::SetSeeds(vtkIdList* seeds)
{
  this->Geodesic->SetSeeds(seeds);
}

//------------------------------------------------------------------------------
vtkIdList* vtkFastMarchingGeodesicPath::GetSeeds()
{
  return this->Geodesic->GetSeeds();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkFastMarchingGeodesicPath::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Geodesic->GetMTime());
}

//------------------------------------------------------------------------------
int vtkFastMarchingGeodesicPath::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->GeodesicLength = 0.0;
  this->ZerothOrderPathPointIds->Reset();
  this->FirstOrderPathPointIds->Reset();
  try
  {
    const geodesic::bridge::SetUpReporter setUp(*this, 0.2);
    this->CheckLimits();
    const TriangleMesh& mesh = this->Internal->Workspace.solverFor(input).mesh();
    if (const auto path = this->FindPath(input))
    {
      this->Deliver(mesh, *path, output);
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
void vtkFastMarchingGeodesicPath::CheckLimits() const
{
  if (!(this->MaximumPathLength >= 0.0))
  {
    throw std::invalid_argument("MaximumPathLength is " +
      geodesic::textOf(this->MaximumPathLength) +
      "; it must be at least 0. For no limit give VTK_DOUBLE_MAX.");
  }
  if (this->MaximumPathPoints < 1)
  {
    throw std::invalid_argument("MaximumPathPoints is " + std::to_string(this->MaximumPathPoints) +
      "; it must be at least 1. For no limit give VTK_ID_MAX.");
  }
}

//------------------------------------------------------------------------------
std::optional<SurfacePath> vtkFastMarchingGeodesicPath::FindPath(vtkPolyData* input)
{
  using namespace geodesic;
  FastMarchingSolver& solver = this->Internal->Workspace.solverFor(input);
  const TriangleMesh& mesh = solver.mesh();
  const bridge::FastMarchingRequest request(
    *this->Geodesic, this->Internal->Workspace.surface(), *this);
  const PathStyle style{ this->InterpolationOrder == 0 ? PathOrder::Vertices : PathOrder::Edges,
    this->Straighten };
  const Index begin = bridge::vertexAtPoint(mesh, this->BeginPointId, "Begin");
  if (request.options().isExcluded(begin))
  {
    throw std::invalid_argument("Begin point id " + std::to_string(this->BeginPointId) +
      " is among the exclusion points, where no path may be; choose another point.");
  }
  const SurfacePoint start = mesh.pointAtVertex(begin);
  std::vector<SurfacePoint> seeds;
  for (const Seed& seed : request.seeds())
  {
    seeds.push_back(seed.points.front());
  }

  SolveOptions options = request.options();
  options.maximumDistance += reachOf(mesh, begin, options.cost);
  std::optional<PathFinder> finder;
  const auto marchFrom = [&](std::span<const SurfacePoint> ends)
  {
    finder.emplace(solver, ends, options, style);
    return finder->march({ &start, 1 });
  };
  if (!marchFrom(seeds))
  {
    return std::nullopt;
  }
  const DistanceField& field = finder->field();
  const double stop = stopOf(mesh, request.options(), field);
  const bool isReached = field.isReached(begin) && field.distance(begin) <= stop;
  // A field of several seeds is less exact where edges lie between the fronts of two seeds, so it
  // is solved again from the nearest seed alone.
  if (isReached && seeds.size() > 1 && !marchFrom({ &seeds[field.nearestSeed(begin)], 1 }))
  {
    return std::nullopt;
  }
  const auto path = isReached ? finder->pathFrom(start) : std::nullopt;
  if (!path && !geodesic::bridge::isAborted(*this))
  {
    throw noRoute(this->BeginPointId, this->GetSeeds(), stop);
  }
  if (!path)
  {
    return std::nullopt;
  }
  return beginningOf(
    mesh, *path, this->MaximumPathLength, static_cast<std::size_t>(this->MaximumPathPoints), false);
}

//------------------------------------------------------------------------------
void vtkFastMarchingGeodesicPath::Deliver(
  const TriangleMesh& mesh, const SurfacePath& path, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  // A line needs at least two points, especially in VTK 9.1. Both can be the same point.
  lines->InsertNextCell(static_cast<int>(std::max<std::size_t>(path.size(), 2)));
  vtkIdType lastNearest = -1;
  for (const PathPoint& point : path)
  {
    const geodesic::Vector3 position = point.position(mesh);
    lines->InsertCellPoint(points->InsertNextPoint(position.x, position.y, position.z));
    const auto [nearer, other] = edgeOf(mesh, point);
    const vtkIdType nearest = mesh.pointOfVertex(nearer);
    if (nearest != lastNearest)
    {
      this->ZerothOrderPathPointIds->InsertNextId(nearest);
      lastNearest = nearest;
    }
    if (this->InterpolationOrder == 1)
    {
      this->FirstOrderPathPointIds->InsertNextId(nearest);
      this->FirstOrderPathPointIds->InsertNextId(mesh.pointOfVertex(other));
    }
  }
  if (path.size() == 1)
  {
    lines->InsertCellPoint(0);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  this->GeodesicLength = lengthOf(mesh, path);
}

//------------------------------------------------------------------------------
void vtkFastMarchingGeodesicPath::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Geodesic:\n";
  this->Geodesic->PrintSelf(os, indent.GetNextIndent());
  os << indent << "BeginPointId: " << this->BeginPointId << "\n";
  os << indent << "InterpolationOrder: " << this->InterpolationOrder << "\n";
  os << indent << "MaximumPathLength: " << this->MaximumPathLength << "\n";
  os << indent << "MaximumPathPoints: " << this->MaximumPathPoints << "\n";
  os << indent << "Straighten: " << (this->Straighten ? "On" : "Off") << "\n";
  os << indent << "GeodesicLength: " << this->GeodesicLength << "\n";
  os << indent << "ZerothOrderPathPointIds: " << this->ZerothOrderPathPointIds.GetPointer() << "\n";
  os << indent << "FirstOrderPathPointIds: " << this->FirstOrderPathPointIds.GetPointer() << "\n";
}

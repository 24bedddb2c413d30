// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/PathScout.h"

#include "path/PathEnds.h"
#include "path/SearchProgress.h"
#include "path/WeightedMesh.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace geodesic::distributed
{
namespace
{

/** A path that comes to a vertex so deep in a ball of the corridor goes on along the path there. */
constexpr float DepthOfKnown = 0.5f;

/** How far ahead of where a path has come to the next ball has its centre, in radii. */
constexpr double Ahead = 0.75;

/** Of several paths to the same end in a cube of this part of a ball's radius one goes on. */
constexpr double PartOfSame = 0.25;

}

/** Traces the next parts of paths, on a mesh of the balls round where they have come to. */
class PathScout::Window
{
public:
  Window(PathScout& scout, const Corridor& corridor)
    : Scout(scout)
    , Mesh(corridor, scout.HasCost)
    , Options(this->optionsFor(scout.Options))
    , Progress(this->Options)
    , Surface(this->Mesh.mesh(), this->Options, this->Progress)
    , NoEnds(this->Mesh.mesh(), {})
    , Tracer(this->Surface, this->Mesh.fieldOf(corridor, StopReason::Exhausted), this->NoEnds)
  {
  }

  void follow(const Walker& walker)
  {
    if (!walker.start)
    {
      this->step(walker, PathPoint::atVertex(this->Mesh.find(*walker.vertex)), walker.seed);
      return;
    }
    const SurfacePoint point = this->Mesh.pointsOf({ walker.start, 1 }).front();
    const PathPoint start = PathPoint::at(this->Mesh.mesh(), point);
    for (const Index seed : this->Tracer.seedsNear(start))
    {
      this->step(walker, start, seed);
      if (!this->Scout.Style.straighten)
      {
        // See PathFinder: the likeliest is taken.
        break;
      }
    }
  }

  std::vector<Walker> next() { return std::move(this->Next); }

private:
  SolveOptions optionsFor(const SolveOptions& request) const
  {
    SolveOptions options = this->Mesh.options();
    options.onProgress = request.onProgress;
    return options;
  }

  void step(const Walker& walker, const PathPoint& from, Index seed)
  {
    if (seed == NoIndex)
    {
      return;
    }
    const TriangleMesh& mesh = this->Mesh.mesh();
    const double radius = walker.ball.radius;
    const Vector3& end = this->Scout.Ends[seed].position;
    const auto isNearEnd = [&](const SurfacePath& path)
    { return norm(path.back().position(mesh) - end) < radius; };
    try
    {
      if (const auto path = this->Tracer.trace(from, seed, this->Scout.Style.order, isNearEnd))
      {
        this->add({ { path->back().position(mesh), radius }, nullptr, {}, seed, 0.0 });
      }
    }
    catch (const IncompleteRing& border)
    {
      const PatchVertex& vertex = this->Mesh.vertex(border.vertex());
      if (vertex.distance < walker.distance &&
        this->Scout.Along.depthOf(vertex.vertex) < DepthOfKnown)
      {
        const double reach = ReachInEdges * vertex.longestEdge;
        const Vector3 way = vertex.position - from.position(mesh);
        const double length = norm(way);
        const double step = length > 0.0 ? Ahead * reach / length : 0.0;
        this->add({ { vertex.position + step * way, reach }, nullptr, vertex.vertex, seed,
          vertex.distance });
      }
    }
  }

  void add(const Walker& walker)
  {
    const Vector3& c = walker.ball.centre;
    const double side = PartOfSame * walker.ball.radius;
    const std::array cube{ std::floor(c.x / side), std::floor(c.y / side), std::floor(c.z / side) };
    if (this->Taken.emplace(walker.seed, cube).second)
    {
      this->Next.push_back(walker);
    }
  }

  PathScout& Scout;
  CorridorMesh Mesh;
  SolveOptions Options;
  SearchProgress Progress;
  WeightedMesh Surface;
  /** The ends of paths need not be on this mesh. */
  PathEnds NoEnds;
  PathTracer Tracer;
  std::vector<Walker> Next;
  /** The cubes to which the next ones have come, by the seed. */
  std::set<std::pair<Index, std::array<double, 3>>> Taken;
};

PathScout::PathScout(Corridor& corridor, const std::vector<GlobalPoint>& ends,
  const PathStyle& style, const SolveOptions& options, bool hasCost, Cut cut)
  : Along(corridor)
  , Ends(ends)
  , Style(style)
  , Options(options)
  , HasCost(hasCost)
  , CutOnAll(std::move(cut))
{
}

bool PathScout::followFrom(std::span<const GlobalPoint> starts, std::size_t mostPoints)
{
  std::vector<Walker> walkers;
  for (const GlobalPoint& start : starts)
  {
    walkers.push_back({ { start.position, ReachInEdges * start.longestEdge }, &start, {}, NoIndex,
      std::numeric_limits<double>::infinity() });
  }
  return this->follow(std::move(walkers), mostPoints);
}

void PathScout::followFrom(std::span<const PatchVertex> vertices)
{
  std::vector<Walker> walkers;
  for (const PatchVertex& vertex : vertices)
  {
    walkers.push_back({ { vertex.position, ReachInEdges * vertex.longestEdge }, nullptr,
      vertex.vertex, vertex.nearestSeed, vertex.distance });
  }
  this->follow(std::move(walkers), std::numeric_limits<std::size_t>::max());
}

bool PathScout::follow(std::vector<Walker> walkers, std::size_t mostPoints)
{
  while (!walkers.empty())
  {
    std::vector<Ball> balls;
    for (const Walker& walker : walkers)
    {
      balls.push_back(walker.ball);
    }
    const std::vector<SurfacePatch> patches = this->CutOnAll(balls);
    this->Along.add(patches, balls);
    if (this->Along.vertices().size() > mostPoints)
    {
      return false;
    }
    Corridor corridor;
    corridor.add(patches, balls);
    Window window(*this, corridor);
    for (const Walker& walker : walkers)
    {
      // Others have come to an end.
      if (walker.start || walker.vertex)
      {
        window.follow(walker);
      }
    }
    walkers = window.next();
  }
  return true;
}

}

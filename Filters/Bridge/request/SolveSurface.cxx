// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "request/SolveSurface.h"

#include "split/BaseMeshPath.h"
#include "split/SplitMesh.h"

#include <algorithm>
#include <stdexcept>

namespace geodesic::bridge
{

SolveSurface::SolveSurface(std::shared_ptr<const InputSurface> base,
  const std::shared_ptr<const TriangleMesh>& mesh, const SurfaceLines& lines,
  const Barriers& barriers, const std::vector<double>& cost, bool alongEdges)
  : Base(std::move(base))
  , Mesh(lines.split() ? lines.split()->mesh() : mesh)
  , Split(lines.split())
  , SeedLines(lines.seeds())
{
  if (this->Split)
  {
    this->Excluded = alongEdges ? this->Split->excludedForEdges(barriers.excluded)
                                : this->Split->excluded(barriers.excluded);
    this->Closed = barriers.closed.empty() ? barriers.closed : this->Split->closed(barriers.closed);
    this->Cost = cost.empty() ? cost : this->Split->cost(cost);
    return;
  }
  this->Excluded = barriers.excluded;
  this->Closed = barriers.closed;
  this->Cost = cost;
  for (const SurfacePath& line : lines.barriers())
  {
    this->Excluded.resize(this->Mesh->numberOfVertices(), 0);
    for (const PathPoint& point : line)
    {
      this->Excluded[point.carriers()[0]] = 1;
    }
  }
}

SolveOptions SolveSurface::options() const
{
  SolveOptions options;
  options.cost = this->Cost;
  options.excluded = this->Excluded;
  options.closedTriangles = this->Closed;
  return options;
}

const TriangleMesh& SolveSurface::baseMesh() const
{
  return this->Split ? this->Split->base() : *this->Mesh;
}

SurfacePoint SolveSurface::pointOf(const SurfacePoint& basePoint) const
{
  return this->Split ? this->Split->pointOf(basePoint) : basePoint;
}

SurfacePoint SolveSurface::openPointOf(const SurfacePoint& basePoint, const std::string& name) const
{
  const SurfacePoint point = this->pointOf(basePoint);
  this->checkOpen(point, name);
  return point;
}

void SolveSurface::checkOpen(const SurfacePoint& point, const std::string& name) const
{
  if (this->Split && this->Split->isOnCut(point))
  {
    throw std::invalid_argument(name + " lies on a line of BarrierSource. Move it off the line.");
  }
  const Carriers carriers = PathPoint::at(*this->Mesh, point).carriers();
  const bool isExcluded = !this->Excluded.empty() &&
    std::all_of(
      carriers.begin(), carriers.end(), [&](Index vertex) { return this->Excluded[vertex] != 0; });
  if (isExcluded)
  {
    const Index vertex = this->Split ? this->Split->origin(carriers[0]).carriers()[0] : carriers[0];
    const Index input = this->baseMesh().pointOfVertex(vertex);
    throw std::invalid_argument(name + " is at " +
      (input < this->Base->mesh()->numberOfPoints() ? this->Base->numbering().nameOfPoint(input)
                                                    : "a point of another rank") +
      ", which is on a barrier. Move it off the barrier.");
  }
}

std::vector<Seed> SolveSurface::seedsOf(const std::vector<Seed>& baseSeeds) const
{
  std::vector<Seed> seeds;
  std::size_t line = 0;
  for (const Seed& baseSeed : baseSeeds)
  {
    Seed seed = baseSeed;
    const std::string name = "Seed " + std::to_string(seeds.size());
    if (seed.kind == Seed::Kind::Curve)
    {
      seed.points.clear();
      if (this->Split)
      {
        seed.points = this->Split->curve(line);
      }
      else if (!this->SeedLines.empty())
      {
        for (const PathPoint& point : this->SeedLines[line])
        {
          seed.points.push_back(surfacePointOf(*this->Mesh, point));
        }
      }
      ++line;
    }
    else if (this->Split && seed.kind == Seed::Kind::Region)
    {
      seed.vertices = this->Split->region(seed.vertices);
    }
    else if (seed.kind == Seed::Kind::Point)
    {
      for (SurfacePoint& point : seed.points)
      {
        point = this->pointOf(point);
      }
    }
    for (const SurfacePoint& point : seed.points)
    {
      this->checkOpen(point, name);
    }
    seeds.push_back(std::move(seed));
  }
  return seeds;
}

SurfacePath SolveSurface::basePathOf(const SurfacePath& path) const
{
  return this->Split
    ? basePath(*this->Mesh, path, [this](Index vertex) { return this->Split->origin(vertex); })
    : path;
}

bool SolveSurface::isLike(const SolveSurface& other) const
{
  return this->Mesh == other.Mesh && this->Excluded == other.Excluded &&
    this->Closed == other.Closed && this->Cost == other.Cost;
}

}

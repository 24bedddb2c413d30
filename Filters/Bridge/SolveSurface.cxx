// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SolveSurface.h"

#include "SplitMesh.h"

#include <algorithm>
#include <stdexcept>

namespace geodesic::bridge
{
namespace
{

/** Sine of the angle below which a path runs straight through a point. */
constexpr double StraightSine = 1e-9;

bool isStraightAt(const Vector3& before, const Vector3& here, const Vector3& after)
{
  const Vector3 in = here - before;
  const Vector3 out = after - here;
  return norm(cross(in, out)) <= StraightSine * norm(in) * norm(out) && dot(in, out) >= 0.0;
}

}

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
    throw std::invalid_argument(name + " lies on a line of BarrierSource; move it off the line.");
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
      ", on a barrier, where nothing may be; move it off the barrier.");
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
  if (!this->Split)
  {
    return path;
  }
  SurfacePath basePath;
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    const PathPoint point = this->Split->basePointOf(path[i]);
    const bool isEnd = i == 0 || i + 1 == path.size();
    const bool isStraight = !isEnd && point.carriers().size() == 3 &&
      isStraightAt(path[i - 1].position(*this->Mesh), path[i].position(*this->Mesh),
        path[i + 1].position(*this->Mesh));
    if (!isStraight)
    {
      basePath.push_back(point);
    }
  }
  return basePath;
}

bool SolveSurface::isLike(const SolveSurface& other) const
{
  return this->Mesh == other.Mesh && this->Excluded == other.Excluded &&
    this->Closed == other.Closed && this->Cost == other.Cost;
}

}

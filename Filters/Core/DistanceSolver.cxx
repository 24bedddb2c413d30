#include "DistanceSolver.h"

#include "StopLimit.h"
#include "TriangleMesh.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace geodesic
{
namespace
{

void checkOptions(const TriangleMesh& mesh, const SolveOptions& options)
{
  if (!options.excluded.empty() && options.excluded.size() != mesh.numberOfVertices())
  {
    throw std::invalid_argument("The exclusion mask has " +
      std::to_string(options.excluded.size()) + " entries, but the mesh has " +
      std::to_string(mesh.numberOfVertices()) + " vertices.");
  }
  if (!(options.maximumDistance >= 0.0))
  {
    throw std::invalid_argument("The maximum distance is " +
      std::to_string(options.maximumDistance) + "; it must be at least 0.");
  }
  for (Index target : options.targets)
  {
    if (target >= mesh.numberOfVertices())
    {
      throw std::invalid_argument("Target vertex " + std::to_string(target) +
        " does not exist; the mesh has " + std::to_string(mesh.numberOfVertices()) + " vertices.");
    }
  }
}

/** A seed whose carrier (its vertex, or both ends of its edge) is excluded has nowhere to start. */
void checkNotExcluded(
  const TriangleMesh& mesh, std::span<const Seed> seeds, std::span<const std::uint8_t> excluded)
{
  if (excluded.empty())
  {
    return;
  }
  for (std::size_t s = 0; s < seeds.size(); ++s)
  {
    const SurfacePoint& point = seeds[s].point;
    const Triangle& corners = mesh.triangle(point.triangle);
    Index blocking = NoIndex;
    bool isOpen = false;
    for (int c = 0; c < 3; ++c)
    {
      if (point.weights[c] > 0.0)
      {
        isOpen = isOpen || !excluded[corners[c]];
        blocking = excluded[corners[c]] ? corners[c] : blocking;
      }
    }
    if (!isOpen)
    {
      throw std::invalid_argument("Seed " + std::to_string(s) + " is at excluded point " +
        std::to_string(mesh.pointOfVertex(blocking)) + "; move it off the excluded points.");
    }
  }
}

}

DistanceSolver::DistanceSolver(std::shared_ptr<const TriangleMesh> mesh)
  : Mesh(std::move(mesh))
  , Field(this->Mesh->numberOfVertices())
{
}

const DistanceField& DistanceSolver::solve(std::span<const Seed> seeds, const SolveOptions& options)
{
  if (seeds.empty())
  {
    throw std::invalid_argument("There is no seed to measure from; give at least one.");
  }
  checkOptions(*this->Mesh, options);
  std::vector<SeedCorner> corners = seedCorners(*this->Mesh, seeds);
  checkNotExcluded(*this->Mesh, seeds, options.excluded);
  std::erase_if(corners,
    [&](const SeedCorner& corner)
    { return !options.excluded.empty() && options.excluded[corner.vertex]; });

  this->Field.reset();
  StopLimit limit(options, this->Field);
  const bool finished = this->march({ seeds, corners, options }, limit, this->Field);
  limit.update();
  this->Field.finish(limit.value(), finished ? limit.reason() : StopReason::Cancelled);
  return this->Field;
}

}

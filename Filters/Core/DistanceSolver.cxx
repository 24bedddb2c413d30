#include "DistanceSolver.h"

#include "ClosedFans.h"
#include "RequestCheck.h"
#include "StopLimit.h"
#include "TriangleMesh.h"

#include <stdexcept>

namespace geodesic
{

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
  const ClosedFans closed(*this->Mesh, options.closedTriangles);
  SeedFront front = seedFront(*this->Mesh, closed, seeds);
  checkSeedsAreOpen(*this->Mesh, seeds, options, closed);
  std::erase_if(
    front.starts, [&](const FrontStart& start) { return options.isExcluded(start.vertex); });

  this->Field.reset();
  StopLimit limit(options, this->Field);
  const bool finished = this->march({ front, closed, options }, limit, this->Field);
  limit.update();
  this->Field.finish(limit.value(), finished ? limit.reason() : StopReason::Cancelled);
  return this->Field;
}

}

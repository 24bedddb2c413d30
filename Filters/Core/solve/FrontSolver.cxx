// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/FrontSolver.h"

#include "mesh/TriangleMesh.h"
#include "solve/OptionsOfMarches.h"
#include "solve/Partition.h"
#include "solve/RequestCheck.h"
#include "solve/SeedCheck.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace geodesic
{

FrontSolver::FrontSolver(std::shared_ptr<const TriangleMesh> mesh)
  : Mesh(std::move(mesh))
  , Field(this->Mesh->numberOfVertices())
{
}

bool FrontSolver::moveTo(const std::shared_ptr<const TriangleMesh>& mesh)
{
  if (!mesh->hasStructureOf(*this->Mesh) || !this->renewFor(*mesh))
  {
    return false;
  }
  this->Mesh = mesh;
  // So that the next run keeps nothing of the last one's surface.
  this->Closed.reset();
  return true;
}

const DistanceField& FrontSolver::solve(std::span<const Seed> seeds, const SolveOptions& options)
{
  Partition onePiece;
  Partition& partition = options.partition ? *options.partition : onePiece;
  const bool keepsSurface = options.keepsSurface && this->Closed;
  partition.together(
    [&]
    {
      if (seeds.empty())
      {
        throw std::invalid_argument("There is no seed to measure from; give at least one.");
      }
      if (!keepsSurface)
      {
        checkSurface(*this->Mesh, options);
      }
      checkOptions(*this->Mesh, options);
      checkSeeds(*this->Mesh, seeds, partition);
    });
  if (!keepsSurface)
  {
    const double ownCost = options.cost.empty() ? 0.0 : 1.0;
    const std::vector<double> costs = partition.gather({ &ownCost, 1 });
    this->HasCost = *std::max_element(costs.begin(), costs.end()) > 0.0;
    this->Closed.emplace(*this->Mesh, options.closedTriangles);
  }
  const ClosedTriangles& closed = *this->Closed;
  SeedFront& front = this->Front;
  OptionsOfMarches marches(options);
  makeSeedFront(
    *this->Mesh, closed, seeds, !options.numbersSeeds, [&] { return marches.goesOn(); }, partition,
    front);
  if (marches.areCancelled(partition))
  {
    this->Closed.reset();
    this->forgetLast();
    this->Field.reset();
    this->Field.finish(0.0, StopReason::Cancelled);
    return this->Field;
  }
  checkSeedsAreOpen(*this->Mesh, seeds, options, closed, partition);
  std::erase_if(
    front.starts, [&](const FrontStart& start) { return options.isExcluded(start.vertex); });

  this->Field.reset();
  StopLimit limit(*this->Mesh, options, this->Field);
  const bool finished =
    this->march({ front, closed, marches.get(), partition, this->HasCost, keepsSurface, seeds },
      limit, this->Field);
  limit.update();
  this->Field.setLeavesOutElsewhere(limit.goal().isKnown());
  this->Field.finish(limit.value(), finished ? limit.reason() : StopReason::Cancelled);
  return this->Field;
}

}

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/IntrinsicMarchingSolver.h"

#include "base/Interruption.h"
#include "march/EdgeLowering.h"
#include "mesh/Carriers.h"
#include "mesh/IntrinsicTriangles.h"
#include "mesh/TriangleMesh.h"
#include "solve/MarchControl.h"
#include "solve/OptionsOfMarches.h"
#include "solve/Partition.h"
#include "solve/RequestCheck.h"
#include "solve/SeedCheck.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace geodesic
{
namespace
{

/** The triangles that flips must leave as they are: closed ones, and those at excluded vertices. */
std::vector<bool> fixedTriangles(const TriangleMesh& mesh, const SolveOptions& options)
{
  if (options.closedTriangles.empty() && options.excluded.empty())
  {
    return {};
  }
  std::vector<bool> isFixed(mesh.numberOfTriangles());
  for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
  {
    const Triangle& corners = mesh.triangle(t);
    isFixed[t] = options.isClosed(t) ||
      std::any_of(
        corners.begin(), corners.end(), [&](Index vertex) { return options.isExcluded(vertex); });
  }
  return isFixed;
}

/** What was made with options, made longer: what is added is of the vertices that a mesh has not.
 */
template <class Value>
std::vector<Value> extended(std::span<const Value> values, Index size, Value added)
{
  std::vector<Value> all(values.begin(), values.end());
  if (!all.empty())
  {
    all.resize(size, added);
  }
  return all;
}

}

/** The march itself, on the intrinsic mesh. */
class IntrinsicMarchingSolver::Solver final : public FastMarchingSolver
{
public:
  Solver(const std::shared_ptr<const TriangleMesh>& intrinsic, const TriangleMesh& faces,
    const SolveOptions& barriers, const std::vector<std::array<Index, 2>>& removedEdges)
    : FastMarchingSolver(intrinsic)
    , Faces(faces)
    , ClosedFaces(faces, barriers.closedTriangles)
    , Starts(faces.numberOfVertices() + 1)
  {
    for (const auto& [a, b] : removedEdges)
    {
      ++this->Starts[a + 1];
      ++this->Starts[b + 1];
    }
    std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
    this->Removed.resize(this->Starts.back());
    std::vector<Index> places(this->Starts.begin(), this->Starts.end() - 1);
    for (const auto& [a, b] : removedEdges)
    {
      const double length = edgeLength(faces, a, b);
      this->Removed[places[a]++] = { b, length };
      this->Removed[places[b]++] = { a, length };
    }
  }

protected:
  bool march(const Request& request, StopLimit& limit, DistanceField& field) override
  {
    OptionsOfMarches marches(request.options);
    const Request first{ request.front, request.closed, marches.get(), request.partition,
      request.hasCost, request.keepsSurface, request.seeds };
    if (!FastMarchingSolver::march(first, limit, field))
    {
      return false;
    }
    marches.beginNext();
    std::vector<Index> from;
    std::copy_if(field.reached().begin(), field.reached().end(), std::back_inserter(from),
      [&](Index vertex) { return this->isNearAlongRemoved(vertex, field); });
    return lowerAlongEdges(
      this->Faces, this->ClosedFaces, marches.get(), from, request.partition, limit, field);
  }

private:
  /** An edge of the mesh that the intrinsic triangles do not have, at one of its ends. */
  struct RemovedEdge
  {
    Index otherEnd;
    double length;
  };

  /** Whether a vertex is nearer than an edge that is not there makes one of its neighbours. */
  bool isNearAlongRemoved(Index vertex, const DistanceField& field) const
  {
    if (vertex >= this->Faces.numberOfVertices())
    {
      return false;
    }
    const double own = field.distance(vertex);
    return std::any_of(this->Removed.begin() + this->Starts[vertex],
      this->Removed.begin() + this->Starts[vertex + 1],
      [&](const RemovedEdge& edge) { return own + edge.length < field.distance(edge.otherEnd); });
  }

  const TriangleMesh& Faces;
  ClosedTriangles ClosedFaces;
  /** Where in Removed the edges of each vertex begin. */
  std::vector<Index> Starts;
  std::vector<RemovedEdge> Removed;
};

/** The intrinsic triangles within some barriers, and the solver on them. */
struct IntrinsicMarchingSolver::Intrinsic
{
  Intrinsic(const TriangleMesh& faces, const SolveOptions& options)
    : closedFaces(options.closedTriangles.begin(), options.closedTriangles.end())
    , triangles(faces, fixedTriangles(faces, options))
    , mesh(std::make_shared<TriangleMesh>(faces.withTriangles(this->triangles)))
    , excluded(extended(options.excluded, this->mesh->numberOfVertices(), std::uint8_t{ 0 }))
    , numberOf(this->mesh->numberOfTriangles())
    , solver(this->mesh, faces, options, this->triangles.removedEdges())
  {
    for (Index t = 0; t < this->numberOf.size(); ++t)
    {
      this->numberOf[this->mesh->sourceOfTriangle(t)] = t;
    }
    if (!this->closedFaces.empty())
    {
      this->closed.resize(this->numberOf.size());
      for (Index t = 0; t < this->closedFaces.size(); ++t)
      {
        // On the faces, too, one of several with the same corners closes them all.
        this->closed[this->numberOf[this->triangles.numberOf(t)]] |= this->closedFaces[t];
      }
    }
  }

  /** Whether it was made for the barriers of a request. */
  bool suits(const TriangleMesh& faces, const SolveOptions& options) const
  {
    const auto ofFaces =
      std::span(this->excluded).first(options.excluded.empty() ? 0 : faces.numberOfVertices());
    return this->excluded.empty() == options.excluded.empty() &&
      std::ranges::equal(ofFaces, options.excluded) &&
      std::ranges::equal(this->closedFaces, options.closedTriangles);
  }

  /** A seed on the faces as one on the intrinsic mesh. */
  Seed seedOf(const TriangleMesh& faces, const Seed& seed) const
  {
    Seed moved = seed;
    moved.position = seed.position ? seed.position : faces.positionOf(seed.points[0]);
    const Carriers carriers = carriersOf(faces, seed.points[0]);
    if (carriers.size() == 1)
    {
      moved.points[0] = this->mesh->pointAtVertex(carriers[0]);
      return moved;
    }
    moved.points[0] = this->triangles.pointOf(seed.points[0]);
    moved.points[0].triangle = this->numberOf[moved.points[0].triangle];
    return moved;
  }

  std::vector<std::uint8_t> closedFaces;
  IntrinsicTriangles triangles;
  std::shared_ptr<const TriangleMesh> mesh;
  /** For each vertex and triangle of the intrinsic mesh; empty if there is none. */
  std::vector<std::uint8_t> excluded;
  std::vector<std::uint8_t> closed;
  /** The number in the intrinsic mesh of each of the triangles. */
  std::vector<Index> numberOf;
  Solver solver;
};

IntrinsicMarchingSolver::IntrinsicMarchingSolver(const std::shared_ptr<const TriangleMesh>& mesh)
  : Faces(mesh)
{
}

IntrinsicMarchingSolver::~IntrinsicMarchingSolver() = default;

bool IntrinsicMarchingSolver::moveTo(const std::shared_ptr<const TriangleMesh>& mesh)
{
  if (!this->OnFaces || !this->OnFaces->moveTo(mesh))
  {
    return false;
  }
  this->Faces = mesh;
  this->Last = nullptr;
  this->OnIntrinsic.reset();
  this->IsBetterOnFaces = false;
  return true;
}

bool IntrinsicMarchingSolver::canMarchIntrinsically(
  std::span<const Seed> seeds, const SolveOptions& options)
{
  const bool isInOnePiece = !options.partition || !options.partition->isDivided();
  return isInOnePiece && options.cost.empty() && !seeds.empty() &&
    std::all_of(
      seeds.begin(), seeds.end(), [](const Seed& seed) { return seed.kind == Seed::Kind::Point; });
}

const DistanceField& IntrinsicMarchingSolver::solve(
  std::span<const Seed> seeds, const SolveOptions& options)
{
  if (!options.isIntrinsic || this->IsBetterOnFaces)
  {
    return this->solveOnFaces(seeds, options);
  }
  if (!canMarchIntrinsically(seeds, options))
  {
    throw std::invalid_argument(
      "Fast marching on intrinsic triangles is from points, without costs "
      "and on a surface in one piece. Let it march on the faces.");
  }
  Partition onePiece;
  checkSurface(*this->Faces, options);
  checkOptions(*this->Faces, options);
  checkSeeds(*this->Faces, seeds, onePiece);
  if (!this->Field)
  {
    this->Field.emplace(this->Faces->numberOfVertices());
  }
  this->Field->reset();
  if (!this->prepare(options))
  {
    this->Field->finish(0.0, StopReason::Cancelled);
    return *this->Field;
  }
  try
  {
    return this->solveIntrinsically(seeds, options);
  }
  catch (const FrontDoesNotSettle&)
  {
    // As where triangles lie on each other, and new vertices have no bound by straight lines.
    this->Last = nullptr;
    this->OnIntrinsic.reset();
    this->IsBetterOnFaces = true;
    return this->solveOnFaces(seeds, options);
  }
}

const DistanceField& IntrinsicMarchingSolver::solveOnFaces(
  std::span<const Seed> seeds, const SolveOptions& options)
{
  if (!this->OnFaces)
  {
    this->OnFaces = std::make_unique<FastMarchingSolver>(this->Faces);
  }
  SolveOptions onFaces = options;
  onFaces.keepsSurface = options.keepsSurface && this->Last == this->OnFaces.get();
  this->Last = this->OnFaces.get();
  return this->OnFaces->solve(seeds, onFaces);
}

bool IntrinsicMarchingSolver::prepare(const SolveOptions& options)
{
  if (this->OnIntrinsic && this->OnIntrinsic->suits(*this->Faces, options))
  {
    return true;
  }
  this->Last = nullptr;
  this->OnIntrinsic.reset();
  const Interruption watch([&] { return !options.onProgress || options.onProgress(0); });
  try
  {
    this->OnIntrinsic = std::make_unique<Intrinsic>(*this->Faces, options);
  }
  catch (const Interrupted&)
  {
    return false;
  }
  return true;
}

const DistanceField& IntrinsicMarchingSolver::solveIntrinsically(
  std::span<const Seed> seeds, const SolveOptions& options)
{
  Intrinsic& intrinsic = *this->OnIntrinsic;
  std::vector<Seed> moved;
  moved.reserve(seeds.size());
  std::transform(seeds.begin(), seeds.end(), std::back_inserter(moved),
    [&](const Seed& seed) { return intrinsic.seedOf(*this->Faces, seed); });
  const auto usefulBelow =
    extended(options.usefulBelow, intrinsic.mesh->numberOfVertices(), DistanceField::Unreached);
  SolveOptions onIntrinsic = options;
  onIntrinsic.closedTriangles = intrinsic.closed;
  onIntrinsic.excluded = intrinsic.excluded;
  onIntrinsic.usefulBelow = usefulBelow;
  onIntrinsic.pathStarts = {};
  onIntrinsic.incomplete = {};
  onIntrinsic.beyondTargets = StopLimit::beyondCorners(*this->Faces, options.pathStarts);
  onIntrinsic.keepsSurface = options.keepsSurface && this->Last == &intrinsic.solver;
  this->Last = &intrinsic.solver;
  const DistanceField& found = intrinsic.solver.solve(moved, onIntrinsic);
  DistanceField& field = *this->Field;
  if (seeds.size() == 1)
  {
    field.setNearestSeed(0);
  }
  for (const Index vertex : found.reached())
  {
    if (vertex < this->Faces->numberOfVertices())
    {
      field.setDistance(vertex, found.distance(vertex));
      if (seeds.size() > 1)
      {
        field.setNearestSeed(vertex, found.nearestSeed(vertex));
      }
    }
  }
  field.noteRaisedGain(found.raisedGain());
  field.setLeavesOutElsewhere(found.leavesOutElsewhere());
  field.setIntrinsic();
  field.finish(DistanceField::Unreached, found.stopReason());
  return field;
}

}

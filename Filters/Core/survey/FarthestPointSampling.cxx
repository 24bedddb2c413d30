// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "survey/FarthestPointSampling.h"

#include "base/NumberText.h"
#include "mesh/Carriers.h"
#include "mesh/TriangleMesh.h"
#include "methods/SolverTeam.h"
#include "solve/DistanceSolver.h"
#include "solve/Partition.h"
#include "survey/FarthestVertices.h"
#include "survey/MarchesAhead.h"
#include "survey/OpenVertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace geodesic
{
namespace
{

void checkLimits(const SamplingRequest& request)
{
  if (!(request.spacing >= 0.0))
  {
    throw std::invalid_argument("The spacing of samples is " + textOf(request.spacing) +
      "; give a distance above 0, or 0 to give their number.");
  }
  if (request.count == 0 && request.spacing == 0.0)
  {
    throw std::invalid_argument(
      "Neither a number of samples nor their spacing is given; give at least one of them.");
  }
  if (request.count > 0 && request.firstPoints.size() > request.count)
  {
    throw std::invalid_argument(std::to_string(request.count) +
      " samples are asked for, fewer than the " + std::to_string(request.firstPoints.size()) +
      " first points. Give fewer first points, or ask for more samples.");
  }
}

/** Takes one sample after the other. */
class Sampler
{
public:
  /** Gives the solver at each call: a team replaces one that has failed. */
  using Solver = std::function<DistanceSolver&()>;

  Sampler(
    const TriangleMesh& mesh, Solver solver, const SamplingRequest& request, Partition& partition)
    : GetSolver(std::move(solver))
    , Mesh(mesh)
    , Request(request)
    , Pieces(partition)
    , Result{ {}, DistanceField(this->Mesh.numberOfVertices()) }
    , IsOpen(openVertices(this->Mesh, request.options, request.neverSamples, partition))
    , Farthest(this->Mesh, this->Result.field.distances(), this->IsOpen)
  {
  }

  /** Has marches made ahead, by a team. @pre a surface in one piece */
  void marchAhead(SolverTeam& team) { this->Ahead.emplace(team, this->Result.field.distances()); }

  Sampling take()
  {
    this->checkCount();
    this->takeFirstPoints();
    while (
      this->Result.samples.size() < this->mostSamples() && this->mayGoOn() && this->takeFarthest())
    {
    }
    this->Result.isCancelled = this->IsCancelled;
    if (!this->IsCancelled)
    {
      this->measure();
      this->Result.field.finish(DistanceField::Unreached, StopReason::Exhausted);
    }
    return std::move(this->Result);
  }

private:
  /** The next sample. */
  struct Choice
  {
    /** NoIndex where another piece has proposed it. */
    Index vertex;
    Seed seed;
  };

  std::size_t mostSamples() const
  {
    return this->Request.count > 0 ? this->Request.count : static_cast<std::size_t>(NoIndex);
  }

  void checkCount()
  {
    double own = 0.0;
    for (Index vertex = 0; vertex < this->IsOpen.size(); ++vertex)
    {
      own += this->IsOpen[vertex] ? 1.0 : 0.0;
    }
    const std::vector<double> all = this->Pieces.gather({ &own, 1 });
    const double most = std::accumulate(all.begin(), all.end(), 0.0) +
      static_cast<double>(this->Request.firstPoints.size());
    if (static_cast<double>(this->Request.count) > most)
    {
      this->refuseCount(most);
    }
  }

  [[noreturn]] void refuseCount(double limit) const
  {
    throw std::invalid_argument(std::to_string(this->Request.count) +
      " samples are asked for, but the surface has only " + textOf(limit) +
      " points that can be samples and lie apart. Ask for no more, or subdivide the surface.");
  }

  void takeFirstPoints()
  {
    const std::span<const Seed> points = this->Request.firstPoints;
    for (const Seed& point : points)
    {
      this->Result.samples.push_back(
        { point.position ? *point.position : this->Mesh.positionOf(point.points.at(0)),
          DistanceField::Unreached, this->vertexOf(point) });
    }
    if (!points.empty() && this->mayGoOn())
    {
      this->spread(points, 0, DistanceField::Unreached);
    }
  }

  /** The vertex at which a point lies and for which this piece speaks. */
  Index vertexOf(const Seed& point) const
  {
    if (point.points.empty())
    {
      return NoIndex;
    }
    const Carriers carriers = carriersOf(this->Mesh, point.points[0]);
    return carriers.size() == 1 && this->Pieces.owns(carriers[0]) ? carriers[0] : NoIndex;
  }

  /** Takes the farthest vertex as a sample.
   * @return false if all are within the spacing, or the sampling is cancelled */
  bool takeFarthest()
  {
    std::optional<Choice> next = this->chooseTied();
    if (!next)
    {
      this->Reach = this->farthestOfAll();
      if (this->Reach <= this->Request.spacing)
      {
        this->checkEnough();
        return false;
      }
      this->Farthest.setLevel(this->Reach * (1.0 - FarthestVertices::TiePart));
      next = this->chooseTied();
    }
    const auto number = static_cast<Index>(this->Result.samples.size());
    this->Result.samples.push_back({ *next->seed.position, this->Reach, next->vertex });
    if (this->goesAhead(next->vertex))
    {
      this->spreadAhead(next->vertex, number);
    }
    else
    {
      this->spread({ &next->seed, 1 }, number, this->Reach);
    }
    return !this->IsCancelled;
  }

  /** Throws where all vertices are samples, and still more are asked for. */
  void checkEnough() const
  {
    if (this->Request.spacing == 0.0)
    {
      this->refuseCount(static_cast<double>(this->Result.samples.size()));
    }
  }

  void measure()
  {
    double own = 0.0;
    for (Index vertex = 0; vertex < this->IsOpen.size(); ++vertex)
    {
      const bool isReached = this->Result.field.isReached(vertex);
      if (this->IsOpen[vertex])
      {
        own = isReached ? std::max(own, this->Result.field.distance(vertex)) : own;
        this->Result.numberOfUnreached += isReached ? 0 : 1;
      }
    }
    const std::vector<double> all = this->Pieces.gather({ &own, 1 });
    this->Result.coveringRadius = *std::max_element(all.begin(), all.end());
  }

  double farthestOfAll()
  {
    const double own = this->Farthest.farthest();
    const std::vector<double> all = this->Pieces.gather({ &own, 1 });
    return *std::max_element(all.begin(), all.end());
  }

  /** The first of the tied vertices of all pieces; nothing if none is left. Collective. */
  std::optional<Choice> chooseTied()
  {
    const Index vertex = this->Farthest.firstAtLevel();
    const bool isThere = vertex != NoIndex;
    const Vector3 own = isThere ? this->Mesh.position(vertex) : Vector3{};
    const std::array proposal{ isThere ? 1.0 : 0.0, own.x, own.y, own.z };
    const std::vector<double> all = this->Pieces.gather(proposal);
    std::optional<std::size_t> piece;
    Vector3 position{};
    for (std::size_t i = 0; i < all.size(); i += proposal.size())
    {
      const Vector3 proposed{ all[i + 1], all[i + 2], all[i + 3] };
      if (all[i] == 1.0 && (!piece || isBefore(proposed, position)))
      {
        piece = i / proposal.size();
        position = proposed;
      }
    }
    if (!piece)
    {
      return std::nullopt;
    }
    const Index mine = *piece == this->Pieces.number() ? vertex : NoIndex;
    return Choice{ mine, seedAtVertex(this->Mesh, mine, position, this->Pieces) };
  }

  /** Marches from samples, and takes over what is nearer to them than to the samples before.
   * @param number  that of the first of them
   * @param reach   no vertex that has a distance has a larger one */
  void spread(std::span<const Seed> seeds, Index number, double reach)
  {
    SolveOptions options = this->optionsWithin(reach);
    options.keepsSurface = this->HasMarched;
    options.onProgress = [&](std::size_t) { return this->report(); };
    const DistanceField& own = this->GetSolver().solve(seeds, options);
    this->HasMarched = true;
    this->IsCancelled |= own.stopReason() == StopReason::Cancelled;
    for (const Index vertex : own.reached())
    {
      this->takeOver(vertex, own.distance(vertex), number + own.nearestSeed(vertex));
    }
  }

  /** Whether the march of a sample has been made ahead, or is to be made with others. No vertex is
   * far before there is a sample. */
  bool goesAhead(Index vertex)
  {
    if (this->Ahead && this->Ahead->isMade(vertex))
    {
      return true;
    }
    const bool isPaused = this->Pause > 0;
    this->Pause -= isPaused ? 1 : 0;
    return !isPaused && this->Ahead && this->Ahead->gains() &&
      this->Reach < DistanceField::Unreached;
  }

  /** The same from one sample, with marches ahead. */
  void spreadAhead(Index vertex, Index number)
  {
    if (!this->Ahead->isMade(vertex))
    {
      // This sample is counted already.
      const std::size_t left = this->mostSamples() - this->Result.samples.size() + 1;
      std::vector<Index> vertices = this->Farthest.apartFrom(
        vertex, std::min(left, this->Ahead->sizeOfBatch()), this->Request.options.cost);
      // Where no other vertex is far, it takes time to look for one at each sample.
      constexpr int samplesOfPause = 8;
      this->Pause = vertices.size() > 1 ? 0 : samplesOfPause;
      std::erase_if(vertices, [&](Index likely) { return this->Ahead->isMade(likely); });
      this->IsCancelled |= !this->Ahead->march(
        vertices, this->optionsWithin(this->Reach), [&] { return this->report(); });
    }
    if (!this->IsCancelled)
    {
      for (const auto& [nearer, distance] : this->Ahead->take(vertex))
      {
        this->takeOver(nearer, distance, number);
      }
    }
  }

  SolveOptions optionsWithin(double reach) const
  {
    SolveOptions options = this->Request.options;
    options.maximumDistance = reach;
    options.usefulBelow = this->Result.field.distances();
    return options;
  }

  /** Sets the distance of a vertex from a sample if it is less than that from those before. */
  void takeOver(Index vertex, double distance, Index number)
  {
    DistanceField& field = this->Result.field;
    if (distance < field.distance(vertex))
    {
      field.setDistance(vertex, distance);
      field.setNearestSeed(vertex, number);
    }
  }

  /** Whether no piece is to cancel. Collective. */
  bool mayGoOn()
  {
    const double own = this->report() ? 0.0 : 1.0;
    const std::vector<double> all = this->Pieces.gather({ &own, 1 });
    this->IsCancelled |= *std::max_element(all.begin(), all.end()) > 0.0;
    return !this->IsCancelled;
  }

  bool report() const
  {
    if (!this->Request.onProgress)
    {
      return true;
    }
    const auto taken = static_cast<double>(this->Result.samples.size());
    const double ofCount = this->Request.spacing > 0.0 && this->Request.count == 0
      ? 0.0
      : taken / static_cast<double>(this->mostSamples());
    // About as many samples are needed as discs of the reach's size.
    const double ofReach = this->Request.spacing / this->Reach;
    return this->Request.onProgress(std::clamp(std::max(ofCount, ofReach * ofReach), 0.0, 1.0));
  }

  Solver GetSolver;
  const TriangleMesh& Mesh;
  const SamplingRequest& Request;
  Partition& Pieces;
  Sampling Result;
  std::vector<std::uint8_t> IsOpen;
  FarthestVertices Farthest;
  std::optional<MarchesAhead> Ahead;
  /** For so many samples no march is made ahead. */
  int Pause = 0;
  bool HasMarched = false;
  bool IsCancelled = false;
  double Reach = DistanceField::Unreached;
};

}

Sampling sampleFarthest(DistanceSolver& solver, const SamplingRequest& request)
{
  Partition onePiece;
  Partition& partition = request.options.partition ? *request.options.partition : onePiece;
  partition.together([&] { checkLimits(request); });
  return Sampler(
    solver.mesh(), [&]() -> DistanceSolver& { return solver; }, request, partition)
    .take();
}

Sampling sampleFarthest(SolverTeam& solvers, const SamplingRequest& request)
{
  Partition* const partition = request.options.partition;
  if (partition && partition->isDivided())
  {
    return sampleFarthest(solvers.first(), request);
  }
  checkLimits(request);
  Partition onePiece;
  SamplingRequest undivided = request;
  undivided.options.partition = nullptr;
  Sampler sampler(
    solvers.mesh(), [&]() -> DistanceSolver& { return solvers.first(); }, undivided, onePiece);
  sampler.marchAhead(solvers);
  return sampler.take();
}

}

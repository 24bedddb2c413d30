// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/FastMarchingSolver.h"

#if GEODESIC_HAS_LANES

#include "march/BatchedMarch.h"
#include "march/FieldValues.h"
#include "march/HigherBounds.h"
#include "march/LabelBounds.h"
#include "march/LabelMargin.h"
#include "march/NeighbourUpdateOnOne.h"
#include "march/QueuedFront.h"
#include "march/UpdateBounds.h"
#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"
#include "solve/MarchControl.h"
#include "solve/Partition.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace geodesic
{
namespace
{

/**
 * Width of the queue's buckets, in heights of triangles: a front's distance grows by about one
 * height for each triangle that it passes. In wider buckets more vertices wait at a time, and more
 * of them are near each other in memory; but more are also taken too early, and then again.
 */
constexpr double BucketWidthInHeights = 0.46;

/** In a march of dense labels over edges that differ much, buckets are as wide as if the mean of
 * edges were this many times the harmonic one, but no less than a part of the usual width. Else
 * fine parts of a surface would be in a bucket or two, without an order: 200 seeds in one took
 * 80,000 updates for 3,700 vertices beside coarse ones, and take 22,000. */
constexpr double MostOfHarmonicMean = 4.0;
constexpr double LeastPartOfWidth = 1.0 / 16.0;
/** One start for so many vertices is dense: fronts go some ten buckets until they meet. */
constexpr std::size_t VerticesOfDenseStart = 256;
/** So many vertices, with all that a march reads, are in the caches of a core anyway. */
constexpr std::size_t MostInCaches = 8 * FrontQueues::VerticesOfDenseGroup;

}

FastMarchingSolver::FastMarchingSolver(
  const std::shared_ptr<const TriangleMesh>& mesh, bool mayUseQuads)
  : FastMarchingSolver(mesh, std::make_shared<UpdateBounds>(*mesh), mayUseQuads)
{
}

FastMarchingSolver::FastMarchingSolver(std::shared_ptr<const TriangleMesh> mesh,
  std::shared_ptr<const UpdateBounds> bounds, bool mayUseQuads)
  : MarchingSolver(std::move(mesh), std::move(bounds))
  , MayUseQuads(mayUseQuads)
{
  this->States.resize(this->mesh().numberOfVertices());
}

std::unique_ptr<MarchingSolver> FastMarchingSolver::another() const
{
  return std::make_unique<FastMarchingSolver>(
    this->sharedMesh(), this->bounds(), this->MayUseQuads);
}

bool FastMarchingSolver::marchFrom(std::span<const StartValue> starts, const UnitCost& cost,
  const Request& request, LabelBounds* bounds, StopLimit& limit, DistanceField& field)
{
  return this->marchAtCost(starts, cost, request, bounds, limit, field);
}

bool FastMarchingSolver::marchFrom(std::span<const StartValue> starts, const VertexCost& cost,
  const Request& request, LabelBounds* bounds, StopLimit& limit, DistanceField& field)
{
  return this->marchAtCost(starts, cost, request, bounds, limit, field);
}

bool FastMarchingSolver::isDense(std::span<const StartValue> starts, const Request& request) const
{
  const std::size_t vertices = this->mesh().numberOfVertices();
  // New vertices of an intrinsic mesh are not near those with near numbers.
  if (request.front.labels.size() > 1 || !request.options.targets.empty() ||
    this->mesh().isIntrinsic() || vertices <= MostInCaches ||
    starts.size() * VerticesOfDenseStart <= vertices)
  {
    return false;
  }
  std::vector<std::uint8_t> haveStart(1 + vertices / FrontQueues::VerticesOfDenseGroup);
  for (const StartValue& start : starts)
  {
    haveStart[start.vertex / FrontQueues::VerticesOfDenseGroup] = 1;
  }
  const auto count = std::count(haveStart.begin(), haveStart.end(), 1);
  return 2 * static_cast<std::size_t>(count) > haveStart.size();
}

std::size_t FastMarchingSolver::numberOfGroups(
  const Request& request, const LabelBounds* bounds) const
{
  const std::size_t size = bounds ? FrontQueues::VerticesOfDenseGroup : FrontQueues::ItemsOfTurn;
  const std::size_t groups = (this->mesh().numberOfVertices() + size - 1) / size;
  return request.options.targets.empty()
    ? std::clamp(request.front.labels.size(), std::size_t{ 1 }, std::max(groups, std::size_t{ 1 }))
    : 1;
}

template <class Cost>
void FastMarchingSolver::startQueues(
  FrontQueues& queues, const Cost& cost, std::size_t groups, double partOfWidth) const
{
  const double edge = this->mesh().meanLongestEdge();
  const double height = heightOfMargin(edge, this->bounds()->meanMargin());
  const double width = partOfWidth * BucketWidthInHeights * height * cost.mean();
  // A piece without triangles has no edges.
  queues.start(width > 0.0 ? width : 1.0, 2.0 * this->mesh().longestEdgeLength() * cost.largest(),
    cost.queueOrder() == QueueOrder::ByValue ? 1 : groups, cost.queueOrder());
}

template void FastMarchingSolver::startQueues(
  FrontQueues&, const UnitCost&, std::size_t, double) const;
template void FastMarchingSolver::startQueues(
  FrontQueues&, const VertexCost&, std::size_t, double) const;

template <class Cost>
void FastMarchingSolver::startQueues(FrontQueues& queues, const Cost& cost,
  std::span<const StartValue> starts, const Request& request, const LabelBounds* bounds) const
{
  if (!this->isDense(starts, request))
  {
    const double fine = MostOfHarmonicMean / this->mesh().spreadOfEdges();
    this->startQueues(queues, cost, this->numberOfGroups(request, bounds),
      bounds ? std::clamp(fine, LeastPartOfWidth, 1.0) : 1.0);
    return;
  }
  const std::size_t vertices = this->mesh().numberOfVertices();
  this->startQueues(queues, cost, 1 + vertices / FrontQueues::VerticesOfDenseGroup);
  if (!queues.groupByVertex(vertices))
  {
    this->startQueues(queues, cost, 1);
  }
}

template void FastMarchingSolver::startQueues(FrontQueues&, const UnitCost&,
  std::span<const StartValue>, const Request&, const LabelBounds*) const;
template void FastMarchingSolver::startQueues(FrontQueues&, const VertexCost&,
  std::span<const StartValue>, const Request&, const LabelBounds*) const;

template <class Cost>
bool FastMarchingSolver::marchAtCost(std::span<const StartValue> starts, const Cost& cost,
  const Request& request, LabelBounds* bounds, StopLimit& limit, DistanceField& field)
{
  this->WorkOfThreads = {};
  // In the order of values each thread would soon be far from that of all.
  const bool mayShare = cost.queueOrder() == QueueOrder::ByBucket;
  const std::size_t threads = mayShare ? this->threadsFor(starts, request, limit) : 1;
  if (threads > 1)
  {
    if (const auto isFinished =
          this->marchOnThreads(threads, starts, cost, request, bounds, limit, field))
    {
      return *isFinished;
    }
    // Once more, on one thread. Progress goes on from where it was.
    const std::size_t before = this->WorkOfThreads.updates;
    SolveOptions options = request.options;
    options.threads = 1;
    if (options.onProgress)
    {
      options.onProgress = [&](std::size_t taken)
      { return request.options.onProgress(before + taken); };
    }
    const Request again{ request.front, request.closed, options, request.partition,
      request.hasCost };
    return this->marchAtCost(starts, cost, again, bounds, limit, field);
  }
  const std::vector<Label>& labels = request.front.labels;
  this->startQueues(this->Queues, cost, starts, request, bounds);
  MarchControl control(request.options, limit);
  const MarchContext<Cost> context{ this->mesh(), *this->bounds(), cost, request.options, limit,
    control, field, this->Queues, this->States };
  if (labels.size() == 1)
  {
    OneLabelValues<Cost> values(context, labels[0]);
    return this->run(cost, values, starts, request, limit, control, field);
  }
  LabelValues<Cost> values(context, labels, this->Labels, this->Fronts, bounds);
  return this->run(cost, values, starts, request, limit, control, field);
}

template <class Cost, class Values>
bool FastMarchingSolver::run(const Cost& cost, Values& values, std::span<const StartValue> starts,
  const Request& request, StopLimit& limit, MarchControl& control, DistanceField& field)
{
  BatchedMarch<Cost, Values> batches(this->mesh(), *this->bounds(), request.closed, cost, values,
    this->Queues, control, this->MayUseQuads);
  // Many more starts are set in a time than reportAgain() has been called for.
  constexpr std::size_t startsOfReport = 16;
  for (std::size_t i = 0; i < starts.size(); ++i)
  {
    const StartValue& start = starts[i];
    values.start(values.enter(start.label, start.vertex), start);
    if (i % startsOfReport == startsOfReport - 1)
    {
      control.reportAgain();
    }
  }
  const double edge = this->mesh().meanLongestEdge();
  QueuedFront front(this->Queues, control, edge * cost.mean(), edge * cost.typical(),
    values.firstDistance(), values,
    [&](std::uint64_t end, std::vector<Index>* taken) { batches.advance(end, taken); });
  bool finished = request.partition.march(front, limit);
  if constexpr (Values::hasOtherLabels)
  {
    finished = finished &&
      goOnWithinHigherBounds(values.bounds(), front, values, request.partition, limit, field);
  }
  field.noteRaisedGain(control.raisedGain());
  field.orderReached();
  values.finish();
  return finished;
}

}

#endif

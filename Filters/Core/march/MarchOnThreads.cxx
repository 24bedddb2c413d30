// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// One march of FastMarchingSolver on several threads.
#include "march/FastMarchingSolver.h"

#if GEODESIC_HAS_LANES

#include "base/CallsTogether.h"
#include "march/BatchedMarch.h"
#include "march/LabelValues.h"
#include "march/OneLabelValues.h"
#include "march/SharedFront.h"
#include "march/SharedLabelValues.h"
#include "march/SharedValues.h"
#include "mesh/TriangleMesh.h"
#include "solve/MarchControl.h"
#include "solve/StopLimit.h"
#include "threads/SharedMarch.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>

namespace geodesic
{
namespace
{

/** To make threads takes as long as some hundred updates. So a march that may be over soon, as on
 * one of many small parts, is not shared; and it goes on by about as many more until they run. */
constexpr std::size_t LeastUpdates = 1024;
/** Where labels have fewer vertices each, too many lie where they meet. */
constexpr std::size_t VerticesOfLabel = 4096;

/** A mean edge, by which a march goes on at a time. Where all points are one place, no step would
 * lead on. */
double stepOf(const TriangleMesh& mesh, double meanCost)
{
  const double edge = mesh.meanLongestEdge() * meanCost;
  return edge > 0.0 ? edge : DistanceField::Unreached;
}

/** Whether one thread has gone on for long enough, and its front is to be shared. */
bool isToBeShared(const MarchControl& control, std::size_t waiting, const DistanceField& field,
  std::size_t threads, const SolveOptions& options)
{
  const std::size_t reached = field.reached().size();
  return control.count() >= std::min(LeastUpdates, options.verticesOfThread) &&
    control.count() <= SharedMarch::mostUpdates(reached) &&
    SharedMarch::isToBeShared(waiting, field.distances().size() - reached, threads, options);
}

}

std::size_t FastMarchingSolver::threadsFor(
  std::span<const StartValue> starts, const Request& request, const StopLimit& limit) const
{
  const std::size_t labels = request.front.labels.size();
  const bool areFew = labels == 1 ||
    labels * std::min(VerticesOfLabel, request.options.verticesOfThread) <=
      this->mesh().numberOfVertices();
  const bool mayShare = areFew && !limit.isPossible() && !request.partition.isDivided() &&
    !starts.empty() && !this->IsBetterAlone[request.hasCost ? 1 : 0] &&
    this->mesh().numberOfVertices() < SharedValues<UnitCost>::MostVertices;
  const std::size_t worthwhile =
    this->mesh().numberOfVertices() / std::max<std::size_t>(request.options.verticesOfThread, 1);
  return mayShare ? std::min({ request.options.threads, SharedMarch::MostThreads, worthwhile }) : 1;
}

template <class Cost>
std::optional<bool> FastMarchingSolver::marchOnThreads(std::size_t threads,
  std::span<const StartValue> starts, const Cost& cost, const Request& request, StopLimit& limit,
  DistanceField& field)
{
  this->Threads.resize(threads);
  FrontQueues& queues = this->Threads[0].queues;
  this->startQueues(queues, cost, 1);
  MarchControl control(request.options, limit);
  const MarchContext<Cost> context{ this->mesh(), *this->bounds(), cost, request.options, limit,
    control, field, queues, this->States };
  OneLabelValues<Cost> values(context, request.front.labels[0]);
  for (const StartValue& start : starts)
  {
    values.start(values.label(), start);
  }
  BatchedMarch<Cost, OneLabelValues<Cost>> batches(this->mesh(), *this->bounds(), request.closed,
    cost, values, queues, control, this->MayUseQuads);
  const BucketQueue& queue = queues.group(0).best;
  const double step = stepOf(this->mesh(), cost.mean());
  const auto goesOn = [&] { return !queue.isEmpty() && !control.isCancelled(); };
  const auto advanceWhile = [&](const auto& mayGoOn)
  { batches.advanceWhile(queues.endOfMarch(queues.nextKey() + step), nullptr, mayGoOn); };
  while (goesOn() && !isToBeShared(control, queue.size(), field, threads, request.options))
  {
    advanceWhile([] { return true; });
  }
  if (goesOn())
  {
    SharedMarch march(this->mesh(), threads, request.options);
    const auto untilTheyRun = [&](const auto& areThere)
    {
      const std::size_t most =
        control.count() + std::min(LeastUpdates, request.options.verticesOfThread);
      const auto mayGoOn = [&] { return control.count() < most && !areThere(); };
      while (goesOn() && mayGoOn())
      {
        advanceWhile(mayGoOn);
      }
      march.begin(control.count(), field.reached().size(), control.isCancelled());
    };
    const Outcome outcome = this->goOnOnThreads<SharedValues<Cost>>(
      march, untilTheyRun,
      [&](const MarchContext<Cost>& of, SharedMarch::Share& share, std::vector<Index>& reached)
      { return SharedValues<Cost>(of, request.front.labels[0], share, reached); },
      [](std::size_t) {}, cost, request, field);
    if (outcome == Outcome::Unsettled)
    {
      field.fillReached(std::span(this->States), VertexState());
      field.reset();
      return std::nullopt;
    }
    field.orderReached();
    field.setNearestSeed(request.front.labels[0].seed);
    field.fillReached(std::span(this->States), VertexState());
    return outcome == Outcome::Finished;
  }
  field.noteRaisedGain(control.raisedGain());
  field.orderReached();
  values.finish();
  return !control.isCancelled();
}

template std::optional<bool> FastMarchingSolver::marchOnThreads(std::size_t,
  std::span<const StartValue>, const UnitCost&, const Request&, StopLimit&, DistanceField&);
template std::optional<bool> FastMarchingSolver::marchOnThreads(std::size_t,
  std::span<const StartValue>, const VertexCost&, const Request&, StopLimit&, DistanceField&);

template <class Cost>
std::optional<bool> FastMarchingSolver::marchLabelsOnThreads(std::size_t threads,
  std::span<const StartValue> starts, const Cost& cost, const Request& request, StopLimit& limit,
  DistanceField& field)
{
  const std::vector<Label>& labels = request.front.labels;
  const Index count = this->mesh().numberOfVertices();
  this->Threads.resize(threads);
  this->startQueues(this->Queues, cost, 1);
  MarchControl control(request.options, limit);
  const MarchContext<Cost> context{ this->mesh(), *this->bounds(), cost, request.options, limit,
    control, field, this->Queues, this->States };
  LabelValues<Cost> values(context, labels, this->Labels, this->Fronts, nullptr);
  for (const StartValue& start : starts)
  {
    values.start(values.enter(start.label, start.vertex), start);
  }
  BatchedMarch<Cost, LabelValues<Cost>> batches(this->mesh(), *this->bounds(), request.closed, cost,
    values, this->Queues, control, this->MayUseQuads);
  const FrontGroup& group = this->Queues.group(0);
  const double step = stepOf(this->mesh(), cost.mean());
  const auto goesOn = [&]
  { return !(group.best.isEmpty() && group.secondary.isEmpty()) && !control.isCancelled(); };
  while (goesOn() && !isToBeShared(control, group.best.size(), field, threads, request.options))
  {
    batches.advance(this->Queues.endOfMarch(this->Queues.nextKey() + step), nullptr);
  }
  const auto end = [&](LabelValues<Cost>& last, bool isFinished)
  {
    field.orderReached();
    last.finish();
    return isFinished;
  };
  if (!goesOn())
  {
    field.noteRaisedGain(control.raisedGain());
    return end(values, !control.isCancelled());
  }

  // Best values on all threads.
  for (const StartValue& start : starts)
  {
    this->States[start.vertex].setHeld(true);
  }
  FrontQueues& queues = this->Threads[0].queues;
  this->startQueues(queues, cost, 1);
  for (const Index vertex : field.reached())
  {
    if (this->Labels.hasSecondary(vertex))
    {
      this->States[vertex].setHeld(true);
    }
    if (this->States[vertex].isQueued())
    {
      queues.group(0).best.push(vertex, field.distance(vertex) - values.firstDistance());
    }
  }
  SharedMarch march(this->mesh(), threads, request.options);
  std::vector<std::vector<Index>> whereLabelsMeet(threads);
  const Outcome outcome = this->goOnOnThreads<SharedLabelValues<Cost>>(
    march, [&](const auto&) { march.begin(control.count(), field.reached().size(), false); },
    [&](const MarchContext<Cost>& of, SharedMarch::Share& share, std::vector<Index>& reached)
    { return SharedLabelValues<Cost>(of, this->Fronts, values.firstDistance(), share, reached); },
    [&](std::size_t thread)
    {
      const auto startOf = [&](std::size_t part)
      { return static_cast<Index>(std::size_t{ count } * part / threads); };
      for (Index vertex = startOf(thread); vertex < startOf(thread + 1); ++vertex)
      {
        if (this->isWhereLabelsMeet(vertex))
        {
          whereLabelsMeet[thread].push_back(vertex);
        }
      }
    },
    cost, request, field);
  if (outcome == Outcome::Unsettled)
  {
    end(values, false);
    field.reset();
    return std::nullopt;
  }
  if (outcome == Outcome::Cancelled)
  {
    return end(values, false);
  }

  // All values where labels meet. Progress goes on from where it was.
  const std::size_t before = march.work().updates;
  SolveOptions options = request.options;
  if (options.onProgress)
  {
    options.onProgress = [&](std::size_t taken)
    { return request.options.onProgress(before + taken); };
  }
  this->startQueues(this->Queues, cost, 1);
  MarchControl lastControl(options, limit);
  const MarchContext<Cost> lastContext{ this->mesh(), *this->bounds(), cost, options, limit,
    lastControl, field, this->Queues, this->States };
  LabelValues<Cost> last(lastContext, labels, this->Labels, this->Fronts, nullptr);
  BatchedMarch<Cost, LabelValues<Cost>> lastBatches(this->mesh(), *this->bounds(), request.closed,
    cost, last, this->Queues, lastControl, this->MayUseQuads);
  for (const std::vector<Index>& ofThread : whereLabelsMeet)
  {
    for (const Index vertex : ofThread)
    {
      last.startAgain(vertex);
    }
  }
  lastBatches.advance(this->Queues.endOfMarch(DistanceField::Unreached), nullptr);
  field.noteRaisedGain(lastControl.raisedGain());
  return end(last, !lastControl.isCancelled());
}

template std::optional<bool> FastMarchingSolver::marchLabelsOnThreads(std::size_t,
  std::span<const StartValue>, const UnitCost&, const Request&, StopLimit&, DistanceField&);
template std::optional<bool> FastMarchingSolver::marchLabelsOnThreads(std::size_t,
  std::span<const StartValue>, const VertexCost&, const Request&, StopLimit&, DistanceField&);

bool FastMarchingSolver::isWhereLabelsMeet(Index vertex) const
{
  const VertexState state = this->States[vertex];
  if (!state.hasLabel())
  {
    return false;
  }
  const std::span<const RingEntry> ring = this->mesh().ring(vertex);
  return state.isHeld() ||
    std::any_of(ring.begin(), ring.end(),
      [&](const RingEntry& entry)
      {
        const VertexState other = this->States[entry.neighbour()];
        return other.isHeld() || other.hasOtherLabel(state.labelBits());
      });
}

template <class Values, class Meanwhile, class MakeValues, class Afterwards, class Cost>
FastMarchingSolver::Outcome FastMarchingSolver::goOnOnThreads(SharedMarch& march,
  const Meanwhile& meanwhile, const MakeValues& makeValues, const Afterwards& afterwards,
  const Cost& cost, const Request& request, DistanceField& field)
{
  const std::size_t threads = this->Threads.size();
  SolveOptions options = request.options;
  options.onProgress = nullptr;
  std::vector<std::exception_ptr> errors(threads);
  std::vector<std::uint8_t> areFinished(threads);
  std::atomic<bool> settles = true;
  callTogether(threads, meanwhile,
    [&](std::size_t thread)
    {
      try
      {
        SharedMarch::Share share(march, thread);
        auto& [queues, reached] = this->Threads[thread];
        reached.clear();
        if (thread > 0)
        {
          this->startQueues(queues, cost, 1);
        }
        StopLimit limit(this->mesh(), options, field);
        MarchControl control(options, limit, SharedMarch::MostUpdates);
        const MarchContext<Cost> context{ this->mesh(), *this->bounds(), cost, options, limit,
          control, field, queues, this->States };
        Values values = makeValues(context, share, reached);
        BatchedMarch<Cost, Values> batches(this->mesh(), *this->bounds(), request.closed, cost,
          values, queues, control, this->MayUseQuads);
        SharedFront front(
          queues, control, this->mesh().meanLongestEdge() * cost.mean(), values, share, batches);
        if (share.march(front))
        {
          areFinished[thread] = 1;
          afterwards(thread);
        }
      }
      catch (const FrontDoesNotSettle&)
      {
        settles = false;
        march.fail();
      }
      catch (...)
      {
        errors[thread] = std::current_exception();
        march.fail();
      }
    });
  for (const std::exception_ptr& error : errors)
  {
    if (error)
    {
      std::rethrow_exception(error);
    }
  }
  this->WorkOfThreads = march.work();
  std::vector<std::span<const Index>> reached;
  for (const OfThread& thread : this->Threads)
  {
    reached.emplace_back(thread.reached);
  }
  field.noteReached(reached);
  if (!settles)
  {
    this->IsBetterAlone[request.hasCost ? 1 : 0] = true;
    return Outcome::Unsettled;
  }
  return std::find(areFinished.begin(), areFinished.end(), 0) == areFinished.end()
    ? Outcome::Finished
    : Outcome::Cancelled;
}

}

#endif

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// One march of FastMarchingSolver on several threads.
#include "march/FastMarchingSolver.h"

#if GEODESIC_HAS_LANES

#include "base/CallsTogether.h"
#include "march/BatchedMarch.h"
#include "march/OneLabelValues.h"
#include "march/SharedFront.h"
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

}

std::size_t FastMarchingSolver::threadsFor(
  std::span<const StartValue> starts, const Request& request, const StopLimit& limit) const
{
  const bool mayShare = request.front.labels.size() == 1 && !limit.isPossible() &&
    !request.partition.isDivided() && !starts.empty() &&
    !this->IsBetterAlone[request.hasCost ? 1 : 0] &&
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
  const std::size_t least = std::min(LeastUpdates, request.options.verticesOfThread);
  const auto isToBeShared = [&]
  {
    const std::size_t reached = field.reached().size();
    return control.count() >= least && control.count() <= SharedMarch::mostUpdates(reached) &&
      SharedMarch::isToBeShared(
        queue.size(), this->mesh().numberOfVertices() - reached, threads, request.options);
  };
  // A mean edge at a time. Where all points are one place, no step would lead on.
  const double edge = this->mesh().meanLongestEdge() * cost.mean();
  const double step = edge > 0.0 ? edge : DistanceField::Unreached;
  const auto goesOn = [&] { return !queue.isEmpty() && !control.isCancelled(); };
  const auto advanceWhile = [&](const auto& mayGoOn)
  { batches.advanceWhile(queues.endOfMarch(queues.nextKey() + step), nullptr, mayGoOn); };
  while (goesOn() && !isToBeShared())
  {
    advanceWhile([] { return true; });
  }
  if (goesOn())
  {
    SharedMarch march(this->mesh(), threads, request.options);
    const auto untilTheyRun = [&](const auto& areThere)
    {
      const std::size_t most = control.count() + least;
      const auto mayGoOn = [&] { return control.count() < most && !areThere(); };
      while (goesOn() && mayGoOn())
      {
        advanceWhile(mayGoOn);
      }
      march.begin(control.count(), field.reached().size(), control.isCancelled());
    };
    return this->goOnOnThreads(march, untilTheyRun, cost, request, field);
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

template <class Meanwhile, class Cost>
std::optional<bool> FastMarchingSolver::goOnOnThreads(SharedMarch& march,
  const Meanwhile& meanwhile, const Cost& cost, const Request& request, DistanceField& field)
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
        SharedValues<Cost> values(context, request.front.labels[0], share, reached);
        BatchedMarch<Cost, SharedValues<Cost>> batches(this->mesh(), *this->bounds(),
          request.closed, cost, values, queues, control, this->MayUseQuads);
        SharedFront front(
          queues, control, this->mesh().meanLongestEdge() * cost.mean(), values, share, batches);
        areFinished[thread] = share.march(front) ? 1 : 0;
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
    field.fillReached(std::span(this->States), VertexState());
    field.reset();
    this->IsBetterAlone[request.hasCost ? 1 : 0] = true;
    return std::nullopt;
  }
  field.orderReached();
  field.setNearestSeed(request.front.labels[0].seed);
  field.fillReached(std::span(this->States), VertexState());
  return std::find(areFinished.begin(), areFinished.end(), 0) == areFinished.end();
}

}

#endif

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// One march of FastMarchingSolver on several threads.
#include "march/FastMarchingSolver.h"

#if GEODESIC_HAS_LANES

#include "base/CallsTogether.h"
#include "march/BatchedMarch.h"
#include "march/FinishedVertex.h"
#include "march/LabelBounds.h"
#include "march/NeighbourUpdateOnOne.h"
#include "march/SharedFront.h"
#include "march/SharedLabelValues.h"
#include "march/SharedSecondaryValues.h"
#include "march/SharedValues.h"
#include "mesh/TriangleMesh.h"
#include "solve/MarchControl.h"
#include "solve/StopLimit.h"
#include "threads/SharedMarch.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace geodesic
{
namespace
{

/** To make threads takes as long as some hundred updates. So a march that may be over soon, as on
 * one of many small parts, is not shared; and it goes on by about as many more until they run. */
constexpr std::size_t LeastUpdates = 1024;

/** How a march of one label is shared. */
template <class Cost>
class OneLabelSharing
{
public:
  OneLabelSharing(const MarchContext<Cost>& context, const Label& label)
    : Context(context)
    , Only(label)
    , Alone(context, label)
  {
  }

  /** The values of the one thread that begins. */
  OneLabelValues<Cost>& alone() { return this->Alone; }
  /** Whether it can be shared; once it can't, it never can. */
  static bool isPossible() { return true; }
  /** To be called once it is to be shared. */
  void begin() {}
  /** The values of one of several threads, for the parameters see SharedValues. */
  SharedValues<Cost> ofThread(
    const MarchContext<Cost>& context, SharedMarch::Share& share, std::vector<Index>& reached)
  {
    return { context, this->Only, share, reached };
  }
  /** What each thread does once the march has ended. It may be called again for the same vertices.
   * @param reached  vertices that got their first value by this thread
   * @param isFinished  whether the march has come to its end */
  void finish(std::span<const Index>, bool) {}
  /** To be called once all have done so. */
  void end()
  {
    this->Context.field.setNearestSeed(this->Only.seed);
    this->Context.field.fillReached(this->Context.states, VertexState());
  }

private:
  const MarchContext<Cost>& Context;
  const Label& Only;
  OneLabelValues<Cost> Alone;
};

/** The same for several labels. */
template <class Cost>
class LabelSharing
{
public:
  /** For the parameters see LabelValues. */
  LabelSharing(const MarchContext<Cost>& context, std::span<const Label> labels,
    SecondaryValues& sets, std::vector<SourceFront>& fronts, LabelBounds* bounds)
    : Context(context)
    , Labels(labels)
    , OfOne(sets)
    , Fronts(fronts)
    , Bounds(bounds)
    , Alone(context, labels, sets, fronts, bounds)
  {
  }

  LabelValues<Cost>& alone() { return this->Alone; }
  bool isPossible() const { return !this->OfOne.hasLongChains(); }
  void begin() { this->OfAll.emplace(this->OfOne); }
  SharedLabelValues<Cost> ofThread(
    const MarchContext<Cost>& context, SharedMarch::Share& share, std::vector<Index>& reached)
  {
    return { context, this->Fronts, *this->OfAll, this->Bounds, this->Alone.firstDistance(), share,
      reached };
  }
  void finish(std::span<const Index> reached, bool isFinished)
  {
    std::vector<Index> atEnds;
    for (const Index vertex : reached)
    {
      if (this->Context.states[vertex].hasLabel() &&
        finishVertex(this->Context, this->Labels, *this->OfAll, this->Bounds, vertex) && isFinished)
      {
        atEnds.push_back(vertex);
      }
    }
    const std::lock_guard lock(this->Mutex);
    for (const Index vertex : atEnds)
    {
      this->Bounds->noteAtEnd(vertex);
    }
  }
  void end() { this->OfOne.finish(); }

private:
  const MarchContext<Cost>& Context;
  std::span<const Label> Labels;
  SecondaryValues& OfOne;
  const std::vector<SourceFront>& Fronts;
  LabelBounds* Bounds;
  std::mutex Mutex;
  LabelValues<Cost> Alone;
  std::optional<SharedSecondaryValues> OfAll;
};

}

std::size_t FastMarchingSolver::threadsFor(
  std::span<const StartValue> starts, const Request& request, const StopLimit& limit)
{
  const Index most = request.front.labels.size() == 1 ? SharedValues<UnitCost>::MostVertices
                                                      : SharedLabelValues<UnitCost>::MostVertices;
  const bool mayShare = !limit.isPossible() && !request.partition.isDivided() && !starts.empty() &&
    this->isBetterAlone(request) == 0 && this->mesh().numberOfVertices() < most;
  const std::size_t worthwhile =
    this->mesh().numberOfVertices() / std::max<std::size_t>(request.options.verticesOfThread, 1);
  return mayShare ? std::min({ request.options.threads, SharedMarch::MostThreads, worthwhile }) : 1;
}

template <class Cost>
std::optional<bool> FastMarchingSolver::marchOnThreads(std::size_t threads,
  std::span<const StartValue> starts, const Cost& cost, const Request& request, LabelBounds* bounds,
  StopLimit& limit, DistanceField& field)
{
  this->Threads.resize(threads);
  FrontQueues& queues = this->Threads[0].queues;
  this->startQueues(queues, cost, starts, request, bounds);
  MarchControl control(request.options, limit);
  const MarchContext<Cost> context{ this->mesh(), *this->bounds(), cost, request.options, limit,
    control, field, queues, this->States };
  const std::vector<Label>& labels = request.front.labels;
  if (labels.size() == 1)
  {
    OneLabelSharing<Cost> sharing(context, labels[0]);
    return this->marchOnThreads(sharing, starts, control, context, request);
  }
  LabelSharing<Cost> sharing(context, labels, this->Labels, this->Fronts, bounds);
  return this->marchOnThreads(sharing, starts, control, context, request);
}

template std::optional<bool> FastMarchingSolver::marchOnThreads(std::size_t,
  std::span<const StartValue>, const UnitCost&, const Request&, LabelBounds*, StopLimit&,
  DistanceField&);
template std::optional<bool> FastMarchingSolver::marchOnThreads(std::size_t,
  std::span<const StartValue>, const VertexCost&, const Request&, LabelBounds*, StopLimit&,
  DistanceField&);

template <class Sharing, class Cost>
std::optional<bool> FastMarchingSolver::marchOnThreads(Sharing& sharing,
  std::span<const StartValue> starts, MarchControl& control, const MarchContext<Cost>& context,
  const Request& request)
{
  const std::size_t threads = this->Threads.size();
  DistanceField& field = context.field;
  FrontQueues& queues = context.queues;
  auto& values = sharing.alone();
  for (const StartValue& start : starts)
  {
    values.start(values.enter(start.label, start.vertex), start);
  }
  BatchedMarch batches(this->mesh(), *this->bounds(), request.closed, context.cost, values, queues,
    control, this->MayUseQuads);
  const std::size_t least = std::min(LeastUpdates, request.options.verticesOfThread);
  const auto isToBeShared = [&]
  {
    return sharing.isPossible() && control.count() >= least &&
      control.count() <= SharedMarch::mostUpdates(values.numberOfValues()) &&
      SharedMarch::isToBeShared(queues.size(),
        this->mesh().numberOfVertices() - field.reached().size(), threads,
        request.front.labels.size(), request.options);
  };
  // A mean edge at a time. Where all points are one place, no step would lead on.
  const double edge = this->mesh().meanLongestEdge() * context.cost.mean();
  const double step = edge > 0.0 ? edge : DistanceField::Unreached;
  const auto goesOn = [&] { return queues.size() > 0 && !control.isCancelled(); };
  const auto endOfStep = [&] { return queues.endOfMarch(queues.nextKey() + step); };
  while (goesOn() && !isToBeShared())
  {
    batches.advance(
      sharing.isPossible() ? endOfStep() : queues.endOfMarch(DistanceField::Unreached), nullptr);
  }
  if (goesOn())
  {
    SharedMarch march(this->mesh(), threads, request.front.labels.size(), request.options);
    const auto untilTheyRun = [&](const auto& areThere)
    {
      const std::size_t most = control.count() + least;
      const auto mayGoOn = [&] { return control.count() < most && !areThere(); };
      while (goesOn() && mayGoOn())
      {
        batches.advanceWhile(endOfStep(), nullptr, mayGoOn);
      }
      sharing.begin();
      march.begin(
        control.count(), field.reached().size(), values.numberOfValues(), control.isCancelled());
    };
    return this->goOnOnThreads(march, untilTheyRun, sharing, context, request);
  }
  field.noteRaisedGain(control.raisedGain());
  field.orderReached();
  values.finish();
  return !control.isCancelled();
}

template <class Meanwhile, class Sharing, class Cost>
std::optional<bool> FastMarchingSolver::goOnOnThreads(SharedMarch& march,
  const Meanwhile& meanwhile, Sharing& sharing, const MarchContext<Cost>& alone,
  const Request& request)
{
  const std::size_t threads = this->Threads.size();
  const Cost& cost = alone.cost;
  DistanceField& field = alone.field;
  SolveOptions options = request.options;
  options.onProgress = nullptr;
  std::vector<std::exception_ptr> errors(threads);
  std::vector<std::uint8_t> areFinished(threads);
  std::atomic<bool> settles = true;
  for (OfThread& thread : this->Threads)
  {
    thread.reached.clear();
  }
  callTogether(threads, meanwhile,
    [&](std::size_t thread)
    {
      try
      {
        SharedMarch::Share share(march, thread);
        auto& [queues, reached] = this->Threads[thread];
        if (thread > 0)
        {
          this->startQueues(queues, cost, alone.queues.numberOfGroups());
          queues.groupAs(alone.queues);
        }
        StopLimit limit(this->mesh(), options, field);
        MarchControl control(options, limit, SharedMarch::MostUpdates);
        const MarchContext<Cost> context{ this->mesh(), *this->bounds(), cost, options, limit,
          control, field, queues, this->States };
        auto values = sharing.ofThread(context, share, reached);
        BatchedMarch batches(this->mesh(), *this->bounds(), request.closed, cost, values, queues,
          control, this->MayUseQuads);
        SharedFront front(
          queues, control, this->mesh().meanLongestEdge() * cost.mean(), values, share, batches);
        if (share.march(front))
        {
          sharing.finish(reached, true);
          areFinished[thread] = 1;
        }
      }
      catch (const FrontDoesNotSettle&)
      {
        settles = false;
        march.fail();
      }
      catch (const SharedSecondaryValues::TooManyValues&)
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
  const bool isFinished = std::find(areFinished.begin(), areFinished.end(), 0) == areFinished.end();
  sharing.finish(field.reached(), isFinished);
  std::vector<std::span<const Index>> reached;
  for (const OfThread& thread : this->Threads)
  {
    reached.emplace_back(thread.reached);
    if (!isFinished)
    {
      sharing.finish(thread.reached, false);
    }
  }
  field.noteReached(reached);
  field.orderReached();
  sharing.end();
  for (const std::exception_ptr& error : errors)
  {
    if (error)
    {
      std::rethrow_exception(error);
    }
  }
  this->WorkOfThreads = march.work();
  if (!settles && !march.wasCancelled())
  {
    const double gain = field.raisedGain();
    field.reset();
    field.noteRaisedGain(gain);
    this->isBetterAlone(request) = 1;
    return std::nullopt;
  }
  return isFinished;
}

}

#endif

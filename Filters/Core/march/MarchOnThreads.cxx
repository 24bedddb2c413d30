// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// One march of FastMarchingSolver on several threads.
#include "march/FastMarchingSolver.h"

#if GEODESIC_HAS_LANES

#include "base/CallsTogether.h"
#include "march/BatchedMarch.h"
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

/** The most updates of a thread for each vertex that it came to first. Usual are 1 to 2. It is far
 * below that at which the least gain is raised (see MarchControl). */
constexpr std::size_t MostUpdates = 4;

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
  std::span<const StartValue> starts, const Cost& cost, const Request& request,
  DistanceField& field)
{
  this->Threads.resize(threads);
  SharedMarch march(this->mesh(), threads, request.options);
  SolveOptions options = request.options;
  options.onProgress = nullptr;
  std::vector<std::exception_ptr> errors(threads);
  std::vector<std::uint8_t> areFinished(threads);
  std::atomic<bool> settles = true;
  callTogether(threads,
    [&](std::size_t thread)
    {
      SharedMarch::Share share(march, thread);
      try
      {
        auto& [queues, reached] = this->Threads[thread];
        this->startQueues(queues, cost, 1);
        StopLimit limit(this->mesh(), options, field);
        MarchControl control(options, limit, MostUpdates);
        const MarchContext<Cost> context{ this->mesh(), *this->bounds(), cost, options, limit,
          control, field, queues, this->States };
        reached.clear();
        SharedValues<Cost> values(context, request.front.labels[0], share, reached);
        BatchedMarch<Cost, SharedValues<Cost>> batches(this->mesh(), *this->bounds(),
          request.closed, cost, values, queues, control, this->MayUseQuads);
        for (const StartValue& start : starts)
        {
          if (share.owns(start.vertex))
          {
            values.start(start);
          }
        }
        SharedFront front(queues, control, this->mesh().meanLongestEdge() * cost.mean(), values,
          share, [&](std::uint64_t end) { batches.advance(end, nullptr); });
        areFinished[thread] = share.march(front) ? 1 : 0;
      }
      catch (const FrontDoesNotSettle&)
      {
        settles = false;
        share.fail();
      }
      catch (...)
      {
        errors[thread] = std::current_exception();
        share.fail();
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

template std::optional<bool> FastMarchingSolver::marchOnThreads(
  std::size_t, std::span<const StartValue>, const UnitCost&, const Request&, DistanceField&);
template std::optional<bool> FastMarchingSolver::marchOnThreads(
  std::size_t, std::span<const StartValue>, const VertexCost&, const Request&, DistanceField&);

}

#endif

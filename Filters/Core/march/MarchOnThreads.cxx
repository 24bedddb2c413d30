// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// One march on several threads. Each has a solver of its own, with a field in which the vertices of
// other threads are left out.
#include "march/MarchingSolver.h"

#include "base/MachineMemory.h"
#include "mesh/TriangleMesh.h"
#include "solve/StopLimit.h"
#include "threads/ThreadRounds.h"
#include "threads/VertexShares.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <iterator>
#include <thread>
#include <utility>
#include <vector>

namespace geodesic
{
namespace
{

/** Blocks are dealt out by their distances from as many starts at most. */
constexpr std::size_t MostOrigins = 64;

/** The positions of some of the starts. */
std::vector<Vector3> originsOf(const TriangleMesh& mesh, std::span<const StartValue> starts)
{
  std::vector<Vector3> origins;
  const std::size_t step = starts.size() / MostOrigins + 1;
  for (std::size_t i = 0; i < starts.size(); i += step)
  {
    origins.push_back(mesh.position(starts[i].vertex));
  }
  return origins;
}

/** How many threads may march on a mesh: their solvers take at most a quarter of the memory. */
std::size_t mostThreads(const TriangleMesh& mesh, const SolveOptions& options)
{
  constexpr double shareOfMemory = 0.25;
  constexpr double bytesPerVertex = 28.0;
  const double bytes = bytesPerVertex * std::max<Index>(mesh.numberOfVertices(), 1);
  const auto fitting =
    static_cast<std::size_t>(shareOfMemory * static_cast<double>(machineMemory()) / bytes);
  const std::size_t worthwhile =
    mesh.numberOfVertices() / std::max<std::size_t>(options.verticesOfThread, 1);
  return std::min({ options.threads, VertexShares::MostThreads, fitting, worthwhile });
}

/** Calls work(thread) on each of some threads at the same time; the first is the calling one.
 * Returns when all have returned.
 * @param work  throws nothing
 * @throws std::system_error where the system has no more threads, before any call */
template <class Work>
void onEach(std::size_t threads, const Work& work)
{
  enum Signal
  {
    Wait,
    Begin,
    Leave
  };
  // The threads wait for each other in their work, so that none may begin before all are there.
  std::atomic<Signal> signal = Wait;
  const auto give = [&](Signal given)
  {
    signal = given;
    signal.notify_all();
  };
  std::vector<std::jthread> others;
  try
  {
    for (std::size_t thread = 1; thread < threads; ++thread)
    {
      others.emplace_back(
        [&, thread]
        {
          signal.wait(Wait);
          if (signal == Begin)
          {
            work(thread);
          }
        });
    }
  }
  catch (...)
  {
    give(Leave);
    throw;
  }
  give(Begin);
  work(std::size_t{ 0 });
}

}

struct MarchingSolver::OnThreads
{
  /** A thread's solver, and what its field has. */
  struct OfThread
  {
    std::unique_ptr<MarchingSolver> solver;
    /** For each block whether the thread owned it in the last run. */
    std::vector<std::uint8_t> hadBlocks;
  };

  OnThreads(const TriangleMesh& mesh, std::size_t threads)
    : shares(mesh, threads)
    , ofThreads(threads)
  {
  }

  /** Makes a thread's field ready for a run: what the thread has is unreached, the rest is left
   * out. */
  void prepare(std::size_t thread)
  {
    OfThread& own = this->ofThreads[thread];
    DistanceField& field = own.solver->field();
    field.reset();
    for (std::size_t block = 0; block < this->shares.numberOfBlocks(); ++block)
    {
      const bool isOwn = this->shares.ownerOfBlock(block) == thread;
      const Index first = this->shares.firstOfBlock(block);
      const Index last = this->shares.firstOfBlock(block + 1);
      if (isOwn && own.hadBlocks[block] == 0)
      {
        field.takeIn(first, last);
      }
      else if (!isOwn && own.hadBlocks[block] != 0)
      {
        field.leaveOut(first, last);
      }
      own.hadBlocks[block] = isOwn ? 1 : 0;
    }
    for (const Index vertex : this->shares.atBorders())
    {
      if (this->shares.has(thread, vertex))
      {
        field.takeIn(vertex, vertex + 1);
      }
      else
      {
        field.leaveOut(vertex, vertex + 1);
      }
    }
  }

  VertexShares shares;
  std::vector<OfThread> ofThreads;
};

void MarchingSolver::DeleteThreads::operator()(OnThreads* threads) const
{
  delete threads;
}

template <class Cost>
bool MarchingSolver::marchShared(std::span<const StartValue> starts, const Cost& cost,
  const Request& request, StopLimit& limit, DistanceField& field)
{
  const std::size_t threads = mostThreads(this->mesh(), request.options);
  const bool mayShare = !limit.isPossible() && !request.partition.isDivided() && !starts.empty();
  if (threads < 2 || !mayShare)
  {
    return this->marchFrom(starts, cost, request, nullptr, limit, field);
  }
  return this->marchOnThreads(threads, starts, cost, request, field);
}

template <class Cost>
bool MarchingSolver::marchOnThreads(std::size_t threads, std::span<const StartValue> starts,
  const Cost& cost, const Request& request, DistanceField& field)
{
  if (!this->Threads || this->Threads->shares.numberOfThreads() != threads)
  {
    this->Threads.reset(new OnThreads(this->mesh(), threads));
  }
  VertexShares& shares = this->Threads->shares;
  shares.deal(originsOf(this->mesh(), starts));
  ThreadRounds rounds(this->mesh(), shares, request.front.labels, request.options);
  std::vector<std::exception_ptr> errors(threads);
  std::vector<std::uint8_t> areFinished(threads);
  onEach(threads,
    [&](std::size_t thread)
    {
      ThreadRounds::Piece piece(rounds, thread);
      try
      {
        auto& own = this->Threads->ofThreads[thread];
        if (!own.solver)
        {
          own.solver = this->another();
          own.solver->field().leaveOut(0, this->mesh().numberOfVertices());
          own.hadBlocks.assign(shares.numberOfBlocks(), 0);
        }
        this->Threads->prepare(thread);
        std::vector<StartValue> ownStarts;
        std::copy_if(starts.begin(), starts.end(), std::back_inserter(ownStarts),
          [&](const StartValue& start) { return shares.has(thread, start.vertex); });
        SolveOptions options = request.options;
        options.onProgress = nullptr;
        DistanceField& ownField = own.solver->field();
        StopLimit ownLimit(this->mesh(), options, ownField);
        const Request share{ request.front, request.closed, options, piece, request.hasCost };
        areFinished[thread] =
          own.solver->marchFrom(ownStarts, cost, share, nullptr, ownLimit, ownField) ? 1 : 0;
        for (std::size_t block = 0; block < shares.numberOfBlocks(); ++block)
        {
          if (shares.ownerOfBlock(block) == thread)
          {
            field.takeOver(ownField, shares.firstOfBlock(block), shares.firstOfBlock(block + 1));
          }
        }
      }
      catch (...)
      {
        errors[thread] = std::current_exception();
        piece.fail();
      }
    });
  for (const std::exception_ptr& error : errors)
  {
    if (error)
    {
      this->Threads.reset();
      std::rethrow_exception(error);
    }
  }
  for (const auto& own : this->Threads->ofThreads)
  {
    field.noteRaisedGain(own.solver->field().raisedGain());
  }
  field.findReached();
  this->WorkOfThreads = rounds.work();
  return std::find(areFinished.begin(), areFinished.end(), 0) == areFinished.end();
}

template bool MarchingSolver::marchShared(
  std::span<const StartValue>, const UnitCost&, const Request&, StopLimit&, DistanceField&);
template bool MarchingSolver::marchShared(
  std::span<const StartValue>, const VertexCost&, const Request&, StopLimit&, DistanceField&);

}

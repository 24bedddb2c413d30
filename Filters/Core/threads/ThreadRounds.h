// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ThreadRounds_h
#define geodesic_ThreadRounds_h

#include "base/Index.h"
#include "solve/KnownValues.h"
#include "solve/Partition.h"
#include "solve/SeedFront.h"
#include "solve/SolveOptions.h"
#include "threads/VertexShares.h"

#include "base/SpinBarrier.h"
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace geodesic
{

/** The work of a march on several threads, to reckon what more of them would give. */
struct ThreadWork
{
  std::size_t rounds = 0;
  /** The number of vertices taken from queues. */
  std::size_t updates = 0;
  /** The sum over all rounds of the most updates of any thread. */
  std::size_t longestChain = 0;
  /** The number of values sent. */
  std::size_t values = 0;
};

/**
 * The rounds in which the threads of a march go on together, as ranks do (DistributedSolver): each
 * thread marches on its share of the vertices up to a common limit. Then it sends the values of
 * shared vertices that fell to the threads that have these too; a received value that is lower
 * starts the march there again. All is done when no thread has any work left.
 *
 * Each thread calls march() of its own Piece. Threads write only what is their own, and read what
 * others wrote in the round before.
 */
class ThreadRounds
{
public:
  /** @param shares   dealt out for this march
   * @param options  onProgress is called by thread 0, with the updates of all threads
   * All arguments must live as long as this. */
  ThreadRounds(const TriangleMesh& mesh, const VertexShares& shares, std::span<const Label> labels,
    const SolveOptions& options);

private:
  struct Value
  {
    VertexShares::Slot slot;
    Index label;
    double value;
  };
  /** What a thread says after a round. Each on cache lines of its own. */
  struct alignas(128) Report
  {
    /** The least distance that waits in its queue, or that it sends. */
    double next = 0.0;
    /** In all rounds, and in this one. */
    std::size_t updates = 0;
    std::size_t roundUpdates = 0;
    /** How many values it sends. */
    std::size_t sent = 0;
    bool isCancelled = false;
    /** For each thread the values that are sent to it. */
    std::vector<std::vector<Value>> values;
  };

public:
  /** A thread's side of the march. */
  class Piece final : public Partition
  {
  public:
    Piece(ThreadRounds& rounds, std::size_t thread)
      : Rounds(rounds)
      , Thread(thread)
    {
    }

    std::size_t number() const override { return this->Thread; }
    bool march(MarchingFront& front, StopLimit& limit) override;
    /** To be called by a thread that ends with an error, instead of going on: ends all. */
    void fail();

  private:
    /** Marches up to a distance, and says what this thread then has to say. */
    void advance(MarchingFront& front, double end);
    void sendNews(MarchingFront& front);
    /** Takes over what was sent in the round before. */
    void takeNews(MarchingFront& front);

    Report& report() { return this->Rounds.Reports[this->Parity][this->Thread]; }

    ThreadRounds& Rounds;
    std::size_t Thread;
    /** Even and odd rounds take turns in what they write. */
    std::size_t Parity = 0;
    KnownValues Known;
    std::vector<Index> Taken;
    std::vector<VertexShares::Slot> Touched;
    std::vector<bool> IsTouched;
  };

  /** The work of the march, once it has ended. */
  const ThreadWork& work() const { return this->Work; }

private:
  /** Reports progress of all threads; false once the run is cancelled. Of thread 0. */
  bool mayGoOn(std::size_t updates);

  const TriangleMesh& Mesh;
  const VertexShares& Shares;
  std::span<const Label> Labels;
  const SolveOptions& Options;
  /** At how many updates thread 0 reports next. */
  std::size_t NextReport;
  /** For even and odd rounds, by thread. */
  std::array<std::vector<Report>, 2> Reports;
  SpinBarrier Together;
  ThreadWork Work;
};

}

#endif

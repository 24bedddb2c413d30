// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BatchedMarch_h
#define geodesic_BatchedMarch_h

#include "march/FrontQueues.h"
#include "march/NeighbourUpdate.h"
#include "mesh/TriangleMesh.h"
#include "solve/MarchControl.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

/** The loop of FastMarchingSolver: takes batches of vertices from the queues and updates their
 * neighbours. @tparam Cost, Values  as in NeighbourUpdate */
template <class Cost, class Values>
class BatchedMarch
{
public:
  /** @param mayUseQuads  see NeighbourUpdate */
  BatchedMarch(const TriangleMesh& mesh, const UpdateBounds& bounds, const ClosedTriangles& closed,
    const Cost& cost, Values& values, FrontQueues& queues, MarchControl& control, bool mayUseQuads)
    : Mesh(mesh)
    , FrontValues(values)
    , Queues(queues)
    , Control(control)
    , Update(mesh, bounds, closed, cost, values, mayUseQuads)
  {
  }

  /** Goes on until nothing waits in buckets before @p end, or the run is cancelled.
   * @param taken  gets the items that were taken from the queues; may be null */
  void advance(std::uint64_t end, std::vector<Index>* taken)
  {
    this->advanceWhile(end, taken, [] { return true; });
  }
  /** The same, as long as @p mayGoOn returns true, which is asked before each batch. It may put
   * items into the queues. */
  template <class MayGoOn>
  void advanceWhile(std::uint64_t end, std::vector<Index>* taken, const MayGoOn& mayGoOn)
  {
    std::array<Index, BatchSize> room;
    std::array<Index, BatchSize> roomOfNext;
    while (mayGoOn() && this->Queues.hasBefore(end))
    {
      const std::span<const Index> batch = this->Queues.take(
        room, [&](Index item) { return this->FrontValues.isWaiting(item); },
        [&](Index item, std::span<const Index> others) { return this->areApart(item, others); });
      // By value, what was left out is a step as well: a round that takes anything has done
      // something.
      const std::size_t steps = std::max(batch.size(), std::size_t{ 1 });
      if (!this->Control.mayGoOn(this->FrontValues.numberOfValues(), steps))
      {
        break;
      }
      if (taken)
      {
        taken->insert(taken->end(), batch.begin(), batch.end());
      }
      for (const Index later : this->Queues.upcoming(2 * BatchSize, roomOfNext))
      {
        this->Mesh.prefetchRingStart(this->FrontValues.vertexOf(later));
      }
      this->Update.update(batch, this->Queues.upcoming(0, roomOfNext));
    }
  }

private:
  /** Number of vertices in a batch. They are of one bucket, so hardly any of them gains by another;
   * by value they are fewer, and areApart() sees to it. While they are treated, the rings of the
   * next batch are fetched, and the starts of the rings of the batch after that. */
  static constexpr std::size_t BatchSize = 12;

  /** Whether the vertex of an item is no neighbour of those of some others. */
  bool areApart(Index item, std::span<const Index> others) const
  {
    const Index vertex = this->FrontValues.vertexOf(item);
    return std::none_of(others.begin(), others.end(),
      [&](Index other)
      {
        // The shorter ring tells it: the other one may be a hub's.
        Index centre = this->FrontValues.vertexOf(other);
        Index end = vertex;
        if (this->Mesh.ring(end).size() < this->Mesh.ring(centre).size())
        {
          std::swap(centre, end);
        }
        const std::span<const RingEntry> ring = this->Mesh.ring(centre);
        return centre == end ||
          std::any_of(ring.begin(), ring.end(),
            [&](const RingEntry& entry) { return entry.neighbour() == end; });
      });
  }

  const TriangleMesh& Mesh;
  Values& FrontValues;
  FrontQueues& Queues;
  MarchControl& Control;
  NeighbourUpdate<Cost, Values> Update;
};

}

#endif

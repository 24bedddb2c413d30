// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VertexShares_h
#define geodesic_VertexShares_h

#include "base/Index.h"
#include "base/Vector3.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace geodesic
{

class TriangleMesh;

/**
 * Which thread of a march has which vertices of a mesh. The vertices are in blocks of consecutive
 * numbers, that is, of neighbours on the surface (see SpatialOrder). For each march the blocks are
 * dealt out by how far they lie from where it begins, so that its front, wherever it is, passes
 * blocks of all threads. A thread *owns* its blocks, and *has* the neighbours of their vertices as
 * well: with their values it can update all that it owns.
 */
class VertexShares
{
public:
  /** The most threads: a set of them is the bits of a number. */
  static constexpr std::size_t MostThreads = 64;
  using Threads = std::uint64_t;
  using Slot = std::uint32_t;
  static constexpr Slot NoSlot = ~Slot{ 0 };

  /** Makes the blocks. @param threads  from 1 to MostThreads. Time O(n). */
  VertexShares(const TriangleMesh& mesh, std::size_t threads);

  /** Deals out the blocks. @param origins  where a march begins, at least one point; distances are
   * in straight lines. Time O(b log b + b o) for b blocks and o points, and O(1) for each slot. */
  void deal(std::span<const Vector3> origins);

  std::size_t numberOfThreads() const { return this->NumberOfThreads; }
  std::size_t numberOfBlocks() const { return this->Owners.size(); }
  std::size_t ownerOfBlock(std::size_t block) const { return this->Owners[block]; }
  /** The first vertex of a block; for the number after the last block the number of vertices. */
  Index firstOfBlock(std::size_t block) const
  {
    return static_cast<Index>(std::min(block * this->SizeOfBlock, this->Slots.size()));
  }
  /** Whether a thread has a vertex. */
  bool has(std::size_t thread, Index vertex) const
  {
    const Slot slot = this->Slots[vertex];
    return slot == NoSlot ? this->ownerOf(vertex) == thread
                          : (this->ThreadsOfSlots[slot] >> thread & 1u) != 0;
  }

  /** The vertices that have neighbours in other blocks, in ascending order. The place of a vertex
   * there is its *slot*. */
  std::span<const Index> atBorders() const { return this->AtBorders; }
  /** The slot of a vertex; NoSlot inside a block. */
  Slot slotOf(Index vertex) const { return this->Slots[vertex]; }
  /** The threads that have the vertex of a slot. */
  Threads threadsOf(Slot slot) const { return this->ThreadsOfSlots[slot]; }
  /** Whether a vertex or one of its neighbours has a slot. */
  bool isBeside(Index vertex) const { return this->AreBeside[vertex] != 0; }

private:
  std::size_t ownerOf(Index vertex) const { return this->Owners[vertex / this->SizeOfBlock]; }

  std::size_t NumberOfThreads;
  std::size_t SizeOfBlock;
  std::vector<std::size_t> Owners;
  /** The middle of each block's first, last and middle vertices. */
  std::vector<Vector3> Middles;
  std::vector<Index> AtBorders;
  /** For each slot where its blocks begin in BlocksOfSlots: its own and those of its neighbours. */
  std::vector<std::uint32_t> StartsOfSlots;
  std::vector<std::uint32_t> BlocksOfSlots;
  std::vector<Threads> ThreadsOfSlots;
  std::vector<Slot> Slots;
  std::vector<std::uint8_t> AreBeside;
};

}

#endif

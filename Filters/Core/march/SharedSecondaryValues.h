// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedSecondaryValues_h
#define geodesic_SharedSecondaryValues_h

#include "base/Index.h"
#include "base/SharedNumber.h"
#include "march/SecondaryValues.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <span>
#include <utility>

namespace geodesic
{

/**
 * The SecondaryValues of a march on several threads. The owner of a vertex adds and changes its
 * secondary values, also while other threads read them. So a value never moves: those that are not
 * in place are in chunks of memory, each twice as large as the one before.
 *
 * The distance at a place of a value only falls, whichever label has the place. The owner writes
 * the label first, and others read the distance first: then a distance that they take for the
 * label's is never below it. See SharedNumber.h.
 *
 * Chains are short here: all of one are looked at, one by one.
 */
class SharedSecondaryValues
{
public:
  using SecondaryValue = SecondaryValues::SecondaryValue;

  /** About the most values of a vertex that are not in place. */
  static constexpr Index MostOthers = SecondaryValues::LongChain;

  /** A vertex has more values than that, so that one thread is to go on. */
  class TooManyValues : public std::exception
  {
  };

  /** Goes on from the values of a march on one thread. */
  explicit SharedSecondaryValues(SecondaryValues& begun)
    : InPlace(begun.allInPlace())
    , FirstOther(static_cast<Index>(begun.allInPlace().size()))
  {
    const auto count = static_cast<Index>(begun.numberOfOthers());
    for (Index place = 0; place < count; place += SizeOfBlock)
    {
      this->takeBlock();
    }
    for (Index place = 0; place < count; ++place)
    {
      this->other(this->FirstOther + place) = { begun.secondary(this->FirstOther + place),
        begun.vertexOf(this->FirstOther + place) };
    }
  }

  /** The numbers of values that a thread may add. */
  class Block
  {
  public:
    /** How many values were added. */
    std::size_t added() const { return this->Added; }

  private:
    friend class SharedSecondaryValues;
    Index Next = 0;
    Index End = 0;
    std::size_t Added = 0;
  };

  // For all threads.

  /** What is in place at a vertex. */
  const SecondaryValue& inPlace(Index vertex) const { return this->InPlace[vertex]; }
  /** What is read of a value while its owner may change it. */
  static double distanceOf(const SecondaryValue& secondary)
  {
    return readShared(secondary.distance);
  }
  static VertexState stateOf(const SecondaryValue& secondary)
  {
    return readShared(secondary.state);
  }
  static Index nextOf(const SecondaryValue& secondary) { return readShared(secondary.Next); }
  /** The number of a vertex's secondary value for a label; NoIndex if it has none.
   * @throws TooManyValues */
  Index find(Index vertex, Index label) const
  {
    Index number = vertex;
    for (Index i = 0; number != NoIndex; ++i)
    {
      const SecondaryValue& secondary = this->secondary(number);
      const VertexState state = stateOf(secondary);
      if (state.hasLabel() && state.label() == label)
      {
        return number;
      }
      if (i > MostOthers)
      {
        throw TooManyValues();
      }
      number = nextOf(secondary);
      keepSharedInOrder();
    }
    return NoIndex;
  }
  const SecondaryValue& secondary(Index number) const
  {
    return number < this->FirstOther ? this->InPlace[number] : this->other(number).value;
  }

  // For the owner of a vertex.

  SecondaryValue& secondary(Index number)
  {
    return const_cast<SecondaryValue&>(std::as_const(*this).secondary(number));
  }
  static void setDistance(SecondaryValue& secondary, double distance)
  {
    writeShared(secondary.distance, distance);
  }
  static void setState(SecondaryValue& secondary, VertexState state)
  {
    writeShared(secondary.state, state);
  }
  Index vertexOf(Index number) const
  {
    return number < this->FirstOther ? number : this->other(number).vertex;
  }
  /** Adds a secondary value of +infinity to a vertex. @pre the vertex has none for the label
   * @return its number */
  Index add(Index vertex, Index label, Block& block)
  {
    ++block.Added;
    VertexState state;
    state.setLabel(label);
    SecondaryValue& inPlace = this->InPlace[vertex];
    if (!inPlace.state.hasLabel())
    {
      writeShared(inPlace.state, state);
      return vertex;
    }
    if (block.Next == block.End)
    {
      block.Next = this->takeBlock();
      block.End = block.Next + SizeOfBlock;
    }
    const Index number = this->FirstOther + block.Next++;
    Other& added = this->other(number);
    added.vertex = vertex;
    writeShared(added.value.state, state);
    writeShared(added.value.Next, inPlace.Next);
    // Others may read it from now on.
    keepSharedInOrder();
    writeShared(inPlace.Next, number);
    return number;
  }

  // When no march goes on.

  /** See SecondaryValues. */
  bool hasSecondary(Index vertex) const { return this->InPlace[vertex].state.hasLabel(); }
  void clear(Index vertex) { this->InPlace[vertex] = {}; }
  template <class Visit>
  void visitSecondary(Index vertex, const Visit& visit) const
  {
    if (!this->hasSecondary(vertex))
    {
      return;
    }
    for (Index number = vertex; number != NoIndex; number = this->secondary(number).Next)
    {
      visit(this->secondary(number));
    }
  }

private:
  struct Other
  {
    SecondaryValue value;
    Index vertex = NoIndex;
  };

  static constexpr Index SizeOfBlock = 64;
  static constexpr Index SizeOfFirstChunk = 4096;
  static_assert(SizeOfFirstChunk % SizeOfBlock == 0);
  static constexpr std::size_t MostChunks = 20;

  /** The first numbers of chunks are sizes of the first one times 2^chunk - 1. */
  static std::size_t chunkOf(Index place)
  {
    return static_cast<std::size_t>(std::bit_width(place / SizeOfFirstChunk + 1)) - 1;
  }
  const Other& other(Index number) const
  {
    const Index place = number - this->FirstOther;
    const std::size_t chunk = chunkOf(place);
    const Index first = ((Index{ 1 } << chunk) - 1) * SizeOfFirstChunk;
    return this->Chunks[chunk].load(std::memory_order_acquire)[place - first];
  }
  Other& other(Index number) { return const_cast<Other&>(std::as_const(*this).other(number)); }

  /** Takes places that no thread has taken, and makes their chunk. @return the first of them */
  Index takeBlock()
  {
    const std::lock_guard lock(this->Mutex);
    const Index first = std::exchange(this->Taken, this->Taken + SizeOfBlock);
    const std::size_t chunk = chunkOf(first);
    if (!this->Memory[chunk])
    {
      this->Memory[chunk] = std::make_unique<Other[]>(std::size_t{ SizeOfFirstChunk } << chunk);
      this->Chunks[chunk].store(this->Memory[chunk].get(), std::memory_order_release);
    }
    return first;
  }

  std::span<SecondaryValue> InPlace;
  Index FirstOther;
  std::mutex Mutex;
  Index Taken = 0;
  std::array<std::unique_ptr<Other[]>, MostChunks> Memory;
  std::array<std::atomic<Other*>, MostChunks> Chunks{};
};

}

#endif

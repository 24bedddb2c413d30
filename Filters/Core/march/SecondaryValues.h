// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SecondaryValues_h
#define geodesic_SecondaryValues_h

#include "base/Index.h"
#include "base/Platform.h"
#include "march/VertexState.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace geodesic
{

/**
 * The secondary values of vertices: what a vertex keeps for labels other than that of its best
 * value, at most one value for each label. A vertex keeps values within a margin above the best
 * one; the margin is the largest labelMargin() of the triangles round the vertex. Values of
 * different seeds in one update would give a wrong result on both sides of the border between the
 * seeds, and a choice by the nearest seed would depend on the order of the march.
 *
 * Most vertices have no secondary value: their only value, the best one, is the distance in the
 * field. Near a border between labels most vertices have one. So each vertex has a place for its
 * first secondary value, which is found without a search: this value is "in place". The others of
 * the vertex are in a linked list, the chain behind it. Secondary values have numbers: one in place
 * has the number of its vertex, the others have numbers behind those.
 *
 * Under costs, a vertex may keep a value of each of 10,000 seeds in a face. What is not among the
 * first values of so long a chain is looked up in a table.
 */
class SecondaryValues
{
public:
  /** As many values of a chain are looked at one by one. */
  static constexpr std::uint8_t LongChain = 32;

  /** A value of a vertex for a label that is not its best one. */
  class SecondaryValue
  {
  public:
    /** The distance with the value of the label's seed; +infinity if the place is empty. */
    double distance = std::numeric_limits<double>::infinity();
    /** The label, whether the value is queued, and whether it is final; no label if the place is
     * empty. */
    VertexState state;

    /** The number of the next one of the same vertex; NoIndex for the last one. */
    Index next() const { return this->Next; }

  private:
    friend class SecondaryValues;
    friend class SharedSecondaryValues;
    Index Next = NoIndex;
  };

  /** Prepares for a march; to be called before each. Memory 16 bytes a vertex, and 21 for each
   * value that is not in place; some 60 in long chains. */
  void start(Index numberOfVertices)
  {
    this->InPlace.resize(numberOfVertices);
    this->FirstOther = numberOfVertices;
  }

  /** Whether a vertex has secondary values. */
  bool hasSecondary(Index vertex) const { return this->InPlace[vertex].state.hasLabel(); }
  /** Removes the values of a vertex. After a march it must be called for all vertices with
   * secondary values, and then finish(). */
  void clear(Index vertex) { this->InPlace[vertex] = {}; }
  void finish()
  {
    this->Others.clear();
    this->VerticesOfOthers.clear();
    this->Places.clear();
    this->OfLongChains.clear();
  }

  /** What is in place at all vertices. */
  std::span<SecondaryValue> allInPlace() { return this->InPlace; }
  /** The secondary value in place at a vertex; without a label if it has none. */
  const SecondaryValue& inPlace(Index vertex) const { return this->InPlace[vertex]; }

  /** Has the processor fetch what inPlace() is soon to return. */
  GEODESIC_INLINED void prefetchInPlace(Index vertex) const
  {
    prefetchToRead(&this->InPlace[vertex]);
  }

  /** The number of a vertex's secondary value for a label; NoIndex if it has none. */
  Index find(Index vertex, Index label) const
  {
    return this->InPlace[vertex].state.label() == label ? vertex : this->findInChain(vertex, label);
  }
  /** The same, among the values behind the one in place. */
  Index findInChain(Index vertex, Index label) const
  {
    Index number = this->InPlace[vertex].Next;
    for (int i = 0; number != NoIndex && this->other(number).state.label() != label; ++i)
    {
      if (i == LongChain)
      {
        return this->findInLongChain(vertex, label);
      }
      number = this->other(number).Next;
    }
    return number;
  }

  /** The secondary value of a number, and its vertex. */
  SecondaryValue& secondary(Index number)
  {
    return number < this->FirstOther ? this->InPlace[number]
                                     : this->Others[number - this->FirstOther];
  }
  const SecondaryValue& secondary(Index number) const
  {
    return const_cast<SecondaryValues*>(this)->secondary(number);
  }
  Index vertexOf(Index number) const
  {
    return number < this->FirstOther ? number : this->VerticesOfOthers[number - this->FirstOther];
  }

  /** Adds a secondary value of +infinity to a vertex. @pre the vertex has none for the label
   * @return its number */
  Index add(Index vertex, Index label)
  {
    if (!this->hasSecondary(vertex))
    {
      this->InPlace[vertex].state.setLabel(label);
      return vertex;
    }
    SecondaryValue other;
    other.state.setLabel(label);
    other.Next = std::exchange(
      this->InPlace[vertex].Next, this->FirstOther + static_cast<Index>(this->Others.size()));
    this->Others.push_back(other);
    this->VerticesOfOthers.push_back(vertex);
    this->Places.push_back(other.Next == NoIndex
        ? std::uint8_t{ 0 }
        : static_cast<std::uint8_t>(
            std::min(this->Places[other.Next - this->FirstOther] + 1, LongChain + 1)));
    if (this->Places.back() >= LongChain)
    {
      this->noteLongChain(vertex);
    }
    return this->InPlace[vertex].Next;
  }
  /** To be called after a vertex's secondary value got another label. @param before  the label that
   * it had */
  void relabelled(Index vertex, Index number, Index before)
  {
    if (number >= this->FirstOther &&
      this->Places[this->InPlace[vertex].Next - this->FirstOther] >= LongChain)
    {
      this->OfLongChains.erase(keyOf(vertex, before));
      this->OfLongChains.emplace(keyOf(vertex, this->other(number).state.label()), number);
    }
  }
  /** Whether a vertex has more than LongChain values behind the one in place. */
  bool hasLongChains() const { return !this->OfLongChains.empty(); }
  /** How many values were added to vertices that had one. */
  std::size_t numberOfOthers() const { return this->Others.size(); }
  /** As find(), or as add() if there is none. */
  Index findOrAdd(Index vertex, Index label)
  {
    const Index number = this->find(vertex, label);
    return number != NoIndex ? number : this->add(vertex, label);
  }

  /** Calls @p visit with each secondary value of a vertex. */
  template <class Visit>
  void visitSecondary(Index vertex, Visit&& visit) const
  {
    this->visitNumbers(vertex, [&](Index number) { visit(this->secondary(number)); });
  }
  /** The same with their numbers. */
  template <class Visit>
  void visitNumbers(Index vertex, Visit&& visit) const
  {
    if (!this->hasSecondary(vertex))
    {
      return;
    }
    for (Index number = vertex; number != NoIndex; number = this->secondary(number).Next)
    {
      visit(number);
    }
  }

private:
  /** A secondary value that is not in place. */
  const SecondaryValue& other(Index number) const
  {
    return this->Others[number - this->FirstOther];
  }

  static std::uint64_t keyOf(Index vertex, Index label)
  {
    return std::uint64_t{ vertex } << 32u | label;
  }
  Index findInLongChain(Index vertex, Index label) const
  {
    const auto found = this->OfLongChains.find(keyOf(vertex, label));
    return found == this->OfLongChains.end() ? NoIndex : found->second;
  }
  /** Enters the first value of a chain in the table; all of them, once it has become long. */
  void noteLongChain(Index vertex)
  {
    const Index first = this->InPlace[vertex].Next;
    const bool isNew = this->Places[first - this->FirstOther] == LongChain;
    Index number = first;
    do
    {
      this->OfLongChains.emplace(keyOf(vertex, this->other(number).state.label()), number);
      number = this->other(number).Next;
    } while (isNew && number != NoIndex);
  }

  /** One for each vertex. */
  std::vector<SecondaryValue> InPlace;
  /** The least number of a secondary value that is not in place: the number of vertices. */
  Index FirstOther = 0;
  std::vector<SecondaryValue> Others;
  std::vector<Index> VerticesOfOthers;
  /** For each of the others its place in the chain, counted from the end, up to LongChain + 1. */
  std::vector<std::uint8_t> Places;
  /** The numbers of all values in long chains. */
  std::unordered_map<std::uint64_t, Index> OfLongChains;
};

}

#endif

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SecondaryValues_h
#define geodesic_SecondaryValues_h

#include "base/Index.h"
#include "base/Platform.h"
#include "march/VertexState.h"

#include <limits>
#include <utility>
#include <vector>

namespace geodesic
{

/**
 * The values that vertices keep for several labels beside their best, as far as they are within a
 * margin of it; one a label and vertex. Mixing values of different seeds in an update would be
 * wrong on both sides of the border between them, and a switch by the nearest seed would depend on
 * the order.
 *
 * The margin of a vertex is the largest labelMargin() of the triangles round it.
 *
 * Most vertices have one value, the best, which is the vertex's distance in the field. Near borders
 * most have two: there is a place for a inPlace value at each vertex, so that it is found without a
 * search. Behind it comes a chain of others. SecondaryValue values, those that are not the best,
 * are numbered: the inPlace ones as the vertices, the others after them.
 */
class SecondaryValues
{
public:
  /** A value of a vertex that is not its best. */
  class SecondaryValue
  {
  public:
    /** Without the value of the seed itself; +infinity where there is none. */
    double value = std::numeric_limits<double>::infinity();
    /** Without a label where there is no value. */
    VertexState state;

    /** Of the next one of the same vertex. */
    Index next() const { return this->Next; }

  private:
    friend class SecondaryValues;
    Index Next = NoIndex;
  };

  /** To be called before each use. Memory 16 bytes a vertex. */
  void start(Index numberOfVertices)
  {
    this->InPlace.resize(numberOfVertices);
    this->FirstOther = numberOfVertices;
  }

  /** Whether a vertex has secondary values. */
  bool hasSecondary(Index vertex) const { return this->InPlace[vertex].state.hasLabel(); }
  /** Forgets a vertex; to be called for all that have secondary values, and finish() after. */
  void clear(Index vertex) { this->InPlace[vertex] = {}; }
  void finish()
  {
    this->Others.clear();
    this->VerticesOfOthers.clear();
  }

  /** The secondary value that has a place at the vertex. */
  const SecondaryValue& inPlace(Index vertex) const { return this->InPlace[vertex]; }

  /** Has the processor fetch it, as it is soon to be read. */
  GEODESIC_INLINED void prefetchInPlace(Index vertex) const
  {
    prefetchToRead(&this->InPlace[vertex]);
  }

  /** The secondary value of a vertex for a label, NoIndex where there is none. */
  Index find(Index vertex, Index label) const
  {
    return this->InPlace[vertex].state.label() == label ? vertex : this->findInChain(vertex, label);
  }
  /** The same where it is not the inPlace. */
  Index findInChain(Index vertex, Index label) const
  {
    Index number = this->InPlace[vertex].Next;
    while (number != NoIndex && this->other(number).state.label() != label)
    {
      number = this->other(number).Next;
    }
    return number;
  }

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

  /** Makes room for a secondary value of a vertex, for a label that it has none of. */
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
    return this->InPlace[vertex].Next;
  }
  /** The secondary value of a vertex for a label, a new one where there is none. */
  Index findOrAdd(Index vertex, Index label)
  {
    const Index number = this->find(vertex, label);
    return number != NoIndex ? number : this->add(vertex, label);
  }

  /** Calls @p visit with each secondary value of a vertex. */
  template <class Visit>
  void visitSecondary(Index vertex, Visit&& visit) const
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
  /** Behind a inPlace. */
  const SecondaryValue& other(Index number) const
  {
    return this->Others[number - this->FirstOther];
  }

  std::vector<SecondaryValue> InPlace;
  /** The number of the first secondary value that is not a inPlace. */
  Index FirstOther = 0;
  std::vector<SecondaryValue> Others;
  std::vector<Index> VerticesOfOthers;
};

}

#endif

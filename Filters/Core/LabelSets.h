#ifndef geodesic_LabelSets_h
#define geodesic_LabelSets_h

#include "Index.h"
#include "VertexState.h"

#include <cstdint>
#include <span>
#include <vector>

namespace geodesic
{

/**
 * Whose the values are that vertices keep for several labels, one a label and vertex, as far as
 * they are within a margin of the vertex's best. Mixing values of different seeds in an update
 * would be wrong on both sides of the border between them, and a switch by the nearest seed would
 * depend on the order.
 *
 * The margin of a vertex is the largest labelMargin() of the triangles round it.
 *
 * Most vertices have one value. The best one is the vertex's distance in the field; here is only
 * its label. Near borders most have two: there is a place for a second value at each vertex, so
 * that it is found without a search. Behind it comes a chain of others. Further values, those that
 * are not the best, are numbered: the second ones as the vertices, the others after them.
 */
class LabelSets
{
public:
  /** A value of a vertex that is not its best. */
  class Further
  {
  public:
    /** Without the value of the seed itself. */
    double value = 0.0;

    /** Whether it is one. */
    bool isSet() const { return (this->Bits & LabelBits) != 0; }
    Index label() const { return (this->Bits & LabelBits) - 1; }
    void setLabel(Index label) { this->Bits = (this->Bits & ~LabelBits) | (label + 1); }
    VertexState state() const { return { (this->Bits & Queued) != 0, (this->Bits & Pinned) != 0 }; }
    void setState(VertexState state)
    {
      this->Bits =
        (this->Bits & LabelBits) | (state.isQueued ? Queued : 0u) | (state.isPinned ? Pinned : 0u);
    }

    /** Of the next one of the same vertex. */
    Index next() const { return this->Next; }

    /** For who reads several at once: the number after the label, 0 for none, in LabelBits, and the
     * state. */
    Index bits() const { return this->Bits; }
    static constexpr Index LabelBits = 0x3fffffffu;
    static constexpr Index Queued = 0x80000000u;

  private:
    friend class LabelSets;
    static constexpr Index Pinned = 0x40000000u;
    Index Bits = 0;
    Index Next = NoIndex;
  };

  /** To be called before each use. Memory 20 bytes a vertex. */
  void start(Index numberOfVertices)
  {
    this->BestLabels.resize(numberOfVertices, NoLabel);
    this->Seconds.resize(numberOfVertices);
  }

  /** Forgets a vertex; to be called for all that have a value, and finish() after. */
  void clear(Index vertex)
  {
    this->BestLabels[vertex] = NoLabel;
    this->Seconds[vertex] = {};
  }
  void finish()
  {
    this->Others.clear();
    this->VerticesOfOthers.clear();
  }

  /** The label of a vertex's best value. @pre there is one */
  Index bestLabel(Index vertex) const { return this->BestLabels[vertex] - 1; }
  void setBestLabel(Index vertex, Index label) { this->BestLabels[vertex] = label + 1; }
  /** Other than 0 where the best value is of another label than this one. Without a branch, and to
   * be joined with more of its kind by |: on a front about half of the vertices have no value. */
  std::uint64_t isOther(Index vertex, Index label) const
  {
    const Index best = this->BestLabels[vertex];
    return std::uint64_t{ best } * (best - (label + 1));
  }

  /** For who reads several at once: the number after the label of a vertex's best value, 0 for
   * none; and the further value that has a place at the vertex. */
  Index bestBits(Index vertex) const { return this->BestLabels[vertex]; }
  const Further& second(Index vertex) const { return this->Seconds[vertex]; }

  /** The further value of a vertex for a label, NoIndex where there is none. */
  Index find(Index vertex, Index label) const
  {
    Index number = vertex;
    while (number != NoIndex && this->further(number).label() != label)
    {
      number = this->further(number).Next;
    }
    return number;
  }

  Further& further(Index number)
  {
    return number < this->Seconds.size() ? this->Seconds[number]
                                         : this->Others[number - this->Seconds.size()];
  }
  const Further& further(Index number) const
  {
    return const_cast<LabelSets*>(this)->further(number);
  }
  Index vertexOf(Index number) const
  {
    return number < this->Seconds.size() ? number
                                         : this->VerticesOfOthers[number - this->Seconds.size()];
  }

  /** Adds a further value to a vertex that has none for the label. */
  Index add(Index vertex, Index label, double value)
  {
    Further& second = this->Seconds[vertex];
    if (!second.isSet())
    {
      second.value = value;
      second.setLabel(label);
      return vertex;
    }
    Further other;
    other.value = value;
    other.setLabel(label);
    other.Next = second.Next;
    second.Next = static_cast<Index>(this->Seconds.size() + this->Others.size());
    this->Others.push_back(other);
    this->VerticesOfOthers.push_back(vertex);
    return second.Next;
  }

  /** Calls @p visit with each further value of a vertex. */
  template <class Visit>
  void visitFurther(Index vertex, Visit&& visit) const
  {
    if (!this->Seconds[vertex].isSet())
    {
      return;
    }
    for (Index number = vertex; number != NoIndex; number = this->further(number).Next)
    {
      visit(this->further(number));
    }
  }

private:
  /** Labels are kept as the number after theirs. */
  static constexpr Index NoLabel = 0;
  std::vector<Index> BestLabels;
  std::vector<Further> Seconds;
  std::vector<Further> Others;
  std::vector<Index> VerticesOfOthers;
};

}

#endif

#ifndef geodesic_LabelSets_h
#define geodesic_LabelSets_h

#include "base/Index.h"
#include "march/ValueMark.h"

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
 * most have two: there is a place for a second value at each vertex, so that it is found without a
 * search. Behind it comes a chain of others. Further values, those that are not the best, are
 * numbered: the second ones as the vertices, the others after them.
 */
class LabelSets
{
public:
  /** A value of a vertex that is not its best. */
  class Further
  {
  public:
    /** Without the value of the seed itself; +infinity where there is none. */
    double value = std::numeric_limits<double>::infinity();
    /** Without a label where there is no value. */
    ValueMark mark;

    /** Of the next one of the same vertex. */
    Index next() const { return this->Next; }

  private:
    friend class LabelSets;
    Index Next = NoIndex;
  };

  /** To be called before each use. Memory 16 bytes a vertex. */
  void start(Index numberOfVertices)
  {
    this->Seconds.resize(numberOfVertices);
    this->FirstOther = numberOfVertices;
  }

  /** Whether a vertex has further values. */
  bool hasFurther(Index vertex) const { return this->Seconds[vertex].mark.hasLabel(); }
  /** Forgets a vertex; to be called for all that have further values, and finish() after. */
  void clear(Index vertex) { this->Seconds[vertex] = {}; }
  void finish()
  {
    this->Others.clear();
    this->VerticesOfOthers.clear();
  }

  /** The further value that has a place at the vertex. */
  const Further& second(Index vertex) const { return this->Seconds[vertex]; }

  /** Has the processor fetch it, as it is soon to be read. */
  [[gnu::always_inline]] void prefetchSecond(Index vertex) const
  {
    __builtin_prefetch(&this->Seconds[vertex]);
  }

  /** The further value of a vertex for a label, NoIndex where there is none. */
  Index find(Index vertex, Index label) const
  {
    return this->Seconds[vertex].mark.label() == label ? vertex : this->findInChain(vertex, label);
  }
  /** The same where it is not the second. */
  Index findInChain(Index vertex, Index label) const
  {
    Index number = this->Seconds[vertex].Next;
    while (number != NoIndex && this->other(number).mark.label() != label)
    {
      number = this->other(number).Next;
    }
    return number;
  }

  Further& further(Index number)
  {
    return number < this->FirstOther ? this->Seconds[number]
                                     : this->Others[number - this->FirstOther];
  }
  const Further& further(Index number) const
  {
    return const_cast<LabelSets*>(this)->further(number);
  }
  Index vertexOf(Index number) const
  {
    return number < this->FirstOther ? number : this->VerticesOfOthers[number - this->FirstOther];
  }

  /** Makes room for a further value of a vertex, for a label that it has none of. */
  Index add(Index vertex, Index label)
  {
    if (!this->hasFurther(vertex))
    {
      this->Seconds[vertex].mark.setLabel(label);
      return vertex;
    }
    Further other;
    other.mark.setLabel(label);
    other.Next = std::exchange(
      this->Seconds[vertex].Next, this->FirstOther + static_cast<Index>(this->Others.size()));
    this->Others.push_back(other);
    this->VerticesOfOthers.push_back(vertex);
    return this->Seconds[vertex].Next;
  }
  /** The further value of a vertex for a label, a new one where there is none. */
  Index findOrAdd(Index vertex, Index label)
  {
    const Index number = this->find(vertex, label);
    return number != NoIndex ? number : this->add(vertex, label);
  }

  /** Calls @p visit with each further value of a vertex. */
  template <class Visit>
  void visitFurther(Index vertex, Visit&& visit) const
  {
    if (!this->hasFurther(vertex))
    {
      return;
    }
    for (Index number = vertex; number != NoIndex; number = this->further(number).Next)
    {
      visit(this->further(number));
    }
  }

private:
  /** Behind a second. */
  const Further& other(Index number) const { return this->Others[number - this->FirstOther]; }

  std::vector<Further> Seconds;
  /** The number of the first further value that is not a second. */
  Index FirstOther = 0;
  std::vector<Further> Others;
  std::vector<Index> VerticesOfOthers;
};

}

#endif

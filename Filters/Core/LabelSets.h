#ifndef geodesic_LabelSets_h
#define geodesic_LabelSets_h

#include "Index.h"
#include "VertexState.h"

#include <cstdint>
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
 * its label. Behind it comes a chain of further values.
 */
class LabelSets
{
public:
  /** A value of a vertex that is not its best. */
  struct Further
  {
    /** Without the value of the seed itself. */
    double value;
    Index label;
    Index vertex;
    /** Next one of the same vertex. */
    Index next;
    VertexState state;
  };

  /** To be called before each use. Memory 8 bytes a vertex. */
  void start(Index numberOfVertices)
  {
    this->BestLabels.resize(numberOfVertices, NoLabel);
    this->FirstFurther.resize(numberOfVertices, NoIndex);
  }

  /** Forgets a vertex; to be called for all that have a value, and finish() after. */
  void clear(Index vertex)
  {
    this->BestLabels[vertex] = NoLabel;
    this->FirstFurther[vertex] = NoIndex;
  }
  void finish() { this->FurtherValues.clear(); }

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

  /** The further value of a vertex for a label, NoIndex where there is none. */
  Index find(Index vertex, Index label) const
  {
    Index number = this->FirstFurther[vertex];
    while (number != NoIndex && this->FurtherValues[number].label != label)
    {
      number = this->FurtherValues[number].next;
    }
    return number;
  }

  Further& further(Index number) { return this->FurtherValues[number]; }
  const Further& further(Index number) const { return this->FurtherValues[number]; }

  /** Adds a further value to a vertex that has none for the label. */
  Index add(Index vertex, Index label, double value)
  {
    const Index number = static_cast<Index>(this->FurtherValues.size());
    this->FurtherValues.push_back({ value, label, vertex, this->FirstFurther[vertex], {} });
    this->FirstFurther[vertex] = number;
    return number;
  }

  /** Calls @p visit with each further value of a vertex. */
  template <class Visit>
  void visitFurther(Index vertex, Visit&& visit) const
  {
    for (Index i = this->FirstFurther[vertex]; i != NoIndex; i = this->FurtherValues[i].next)
    {
      visit(this->FurtherValues[i]);
    }
  }

private:
  /** Labels are kept as the number after theirs. */
  static constexpr Index NoLabel = 0;
  std::vector<Index> BestLabels;
  std::vector<Index> FirstFurther;
  std::vector<Further> FurtherValues;
};

}

#endif

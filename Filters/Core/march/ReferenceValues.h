// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ReferenceValues_h
#define geodesic_ReferenceValues_h

#include "base/Index.h"
#include "solve/DistanceField.h"

#include <vector>

namespace geodesic
{

/** What a label has at a vertex. */
struct ReferenceValue
{
  Index vertex;
  Index label;
  /** Without the value of the label's seed. */
  double value = DistanceField::Unreached;
  /** Never to be updated. */
  bool isFinal = false;
  bool isQueued = false;
  /** The number of the next value at the same vertex. */
  Index next = NoIndex;
};

/** The values of all labels at all vertices, numbered as they are added: a list for each vertex. */
class ReferenceValues
{
public:
  explicit ReferenceValues(Index numberOfVertices)
    : FirstOfVertex(numberOfVertices, NoIndex)
  {
  }

  ReferenceValue& operator[](Index number) { return this->Values[number]; }
  const ReferenceValue& operator[](Index number) const { return this->Values[number]; }

  /** The number of a label's value at a vertex, NoIndex where it has none. */
  Index find(Index vertex, Index label) const
  {
    Index number = this->FirstOfVertex[vertex];
    while (number != NoIndex && this->Values[number].label != label)
    {
      number = this->Values[number].next;
    }
    return number;
  }

  Index findOrAdd(Index vertex, Index label)
  {
    if (const Index number = this->find(vertex, label); number != NoIndex)
    {
      return number;
    }
    ReferenceValue added{ vertex, label };
    added.next = this->FirstOfVertex[vertex];
    this->FirstOfVertex[vertex] = static_cast<Index>(this->Values.size());
    this->Values.push_back(added);
    return this->FirstOfVertex[vertex];
  }

  double valueOf(Index vertex, Index label) const
  {
    const Index number = this->find(vertex, label);
    return number != NoIndex ? this->Values[number].value : DistanceField::Unreached;
  }

  template <class Visit>
  void visit(Index vertex, const Visit& visit) const
  {
    for (Index n = this->FirstOfVertex[vertex]; n != NoIndex; n = this->Values[n].next)
    {
      visit(this->Values[n]);
    }
  }

private:
  std::vector<Index> FirstOfVertex;
  std::vector<ReferenceValue> Values;
};

}

#endif

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ReferenceValues_h
#define geodesic_ReferenceValues_h

#include "base/Index.h"
#include "solve/DistanceField.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace geodesic
{

/** The value of a label at a vertex. */
struct ReferenceValue
{
  Index vertex;
  Index label;
  /** The distance without the value of the label's seed. */
  double value = DistanceField::Unreached;
  /** Whether no update may change the value. */
  bool isFinal = false;
  /** Whether the value waits in the queue. */
  bool isQueued = false;
  /** The number of the next value at the same vertex; NoIndex for the last one. */
  Index next = NoIndex;
};

/** The values of all labels at all vertices: a linked list for each vertex, and a table of those of
 * vertices that have many. Values are numbered in the order in which they are added. */
class ReferenceValues
{
public:
  explicit ReferenceValues(Index numberOfVertices)
    : FirstOfVertex(numberOfVertices, NoIndex)
    , CountOfVertex(numberOfVertices, 0)
  {
  }

  std::size_t size() const { return this->Values.size(); }
  ReferenceValue& operator[](Index number) { return this->Values[number]; }
  const ReferenceValue& operator[](Index number) const { return this->Values[number]; }

  /** The number of a label's value at a vertex; NoIndex if it has none there. */
  Index find(Index vertex, Index label) const
  {
    if (this->CountOfVertex[vertex] > Many)
    {
      const auto found = this->Table.find(keyOf(vertex, label));
      return found == this->Table.end() ? NoIndex : found->second;
    }
    Index number = this->FirstOfVertex[vertex];
    while (number != NoIndex && this->Values[number].label != label)
    {
      number = this->Values[number].next;
    }
    return number;
  }

  /** The same; a value of +infinity is added if the label has none there. */
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
    if (++this->CountOfVertex[vertex] > Many)
    {
      this->enterInTable(vertex);
    }
    return this->FirstOfVertex[vertex];
  }

  /** A label's value at a vertex; +infinity if it has none there. */
  double valueOf(Index vertex, Index label) const
  {
    const Index number = this->find(vertex, label);
    return number != NoIndex ? this->Values[number].value : DistanceField::Unreached;
  }

  /** Calls @p visit with each value of a vertex. */
  template <class Visit>
  void visit(Index vertex, const Visit& visit) const
  {
    for (Index n = this->FirstOfVertex[vertex]; n != NoIndex; n = this->Values[n].next)
    {
      visit(this->Values[n]);
    }
  }

private:
  /** The values of a vertex that has more are looked up in the table. */
  static constexpr Index Many = 32;

  static std::uint64_t keyOf(Index vertex, Index label)
  {
    return std::uint64_t{ vertex } << 32u | label;
  }
  /** Enters the last value of a vertex, or all once they have become many. */
  void enterInTable(Index vertex)
  {
    const bool isNew = this->CountOfVertex[vertex] == Many + 1;
    Index number = this->FirstOfVertex[vertex];
    do
    {
      this->Table.emplace(keyOf(vertex, this->Values[number].label), number);
      number = this->Values[number].next;
    } while (isNew && number != NoIndex);
  }

  std::vector<Index> FirstOfVertex;
  std::vector<Index> CountOfVertex;
  std::vector<ReferenceValue> Values;
  std::unordered_map<std::uint64_t, Index> Table;
};

}

#endif

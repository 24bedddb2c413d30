#ifndef geodesic_LabelSets_h
#define geodesic_LabelSets_h

#include "SeedFront.h"

#include <limits>
#include <span>
#include <vector>

namespace geodesic
{

/**
 * The values that vertices keep for several labels, one a label and vertex, as far as they are
 * within a margin of the vertex's best. Mixing values of different seeds in an update would be
 * wrong on both sides of the border between them, and a switch by the nearest seed would depend on
 * the order.
 *
 * The margin of a vertex is the largest labelMargin() of the triangles round it.
 *
 * Most vertices have one value. Each has its first entry in place, numbered like the vertex, and a
 * chain of further ones behind all vertices' first.
 */
class LabelSets
{
public:
  /** One value of one vertex. */
  struct Entry
  {
    /** Without the value of the seed itself. */
    double value = std::numeric_limits<double>::infinity();
    Index label : 30 = NoLabel;
    Index isQueued : 1 = 0;
    Index isPinned : 1 = 0;
    /** Next entry of the same vertex. */
    Index next = NoIndex;
  };
  static constexpr Index NoLabel = 0x3fffffffu;

  /** To be called before each use. Memory 16 bytes a vertex. */
  void start(Index numberOfVertices)
  {
    this->NumberOfVertices = numberOfVertices;
    this->Entries.resize(numberOfVertices);
  }

  /** Forgets the entries of a vertex; to be called for all that have some, and finish() after. */
  void clear(Index vertex) { this->Entries[vertex] = Entry(); }
  void finish()
  {
    this->Entries.resize(this->NumberOfVertices);
    this->VertexOfFurther.clear();
  }

  /** The entry of a vertex for a label, NoIndex where there is none. */
  Index find(Index vertex, Index label) const
  {
    Index entry = vertex;
    while (entry != NoIndex && this->Entries[entry].label != label)
    {
      entry = this->Entries[entry].next;
    }
    return entry;
  }

  Entry& operator[](Index entry) { return this->Entries[entry]; }
  const Entry& operator[](Index entry) const { return this->Entries[entry]; }

  /** Adds an entry without a value to a vertex that has none for the label. */
  Index add(Index vertex, Index label)
  {
    if (this->Entries[vertex].label == NoLabel)
    {
      this->Entries[vertex].label = label;
      return vertex;
    }
    const Index entry = static_cast<Index>(this->Entries.size());
    this->Entries.push_back({ .label = label, .next = this->Entries[vertex].next });
    this->Entries[vertex].next = entry;
    this->VertexOfFurther.push_back(vertex);
    return entry;
  }

  /** Calls @p visit with each entry of a vertex. */
  template <class Visit>
  void visit(Index vertex, Visit&& visit) const
  {
    for (Index e = vertex; e != NoIndex; e = this->Entries[e].next)
    {
      if (this->Entries[e].label != NoLabel)
      {
        visit(this->Entries[e]);
      }
    }
  }

  /** The vertex that an entry belongs to. */
  Index vertexOf(Index entry) const
  {
    return entry < this->NumberOfVertices ? entry
                                          : this->VertexOfFurther[entry - this->NumberOfVertices];
  }
  /** The smallest seed among those whose value equals the vertex's best one, rounding aside. */
  Index nearestSeed(Index vertex, double best, std::span<const Label> labels) const
  {
    constexpr double rounding = 1.0 + 1e-10;
    Index seed = NoIndex;
    for (Index e = vertex; e != NoIndex; e = this->Entries[e].next)
    {
      const Label& label = labels[this->Entries[e].label];
      if (label.seed < seed && this->Entries[e].value + label.value <= best * rounding)
      {
        seed = label.seed;
      }
    }
    return seed;
  }

private:
  Index NumberOfVertices = 0;
  std::vector<Entry> Entries;
  std::vector<Index> VertexOfFurther;
};

}

#endif

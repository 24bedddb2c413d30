// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_SharedPoints_h
#define geodesic_distributed_SharedPoints_h

#include "base/Index.h"
#include "ranks/KeyMatches.h"
#include "ranks/RankGroup.h"
#include "solve/StartValue.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace geodesic
{
class TriangleMesh;
}

namespace geodesic::distributed
{

/** A vertex by the lowest rank that has it and the number it has there. */
struct GlobalVertex
{
  int rank;
  Index vertex;

  friend auto operator<=>(const GlobalVertex&, const GlobalVertex&) = default;
};

/**
 * The vertices of this rank's piece of a surface that other ranks have as well.
 *
 * Only vertices inside the bounding box of another piece are looked at. Time and memory O(vertices
 * in overlapping boxes + boundary).
 */
class SharedPoints
{
public:
  /**
   * Collective.
   * @param keys one a vertex, equal for those of different ranks that are one point
   */
  SharedPoints(RankGroup& ranks, const TriangleMesh& mesh, std::span<const Key> keys);

  /** Their vertex numbers on this rank; a *slot* is a place in this list. */
  std::span<const Index> vertices() const { return this->Vertices; }

  /** A rank that shares vertices with this one. */
  struct Neighbour
  {
    int rank;
    /** The slots of the shared vertices, in an order that both ranks agree on. */
    std::vector<std::uint32_t> slots;
  };
  /** In the order of RankGroup::exchange. */
  std::span<const Neighbour> neighbours() const { return this->Neighbours; }

  /** Where a shared vertex is in the list of a neighbour. */
  struct Place
  {
    /** Number of the neighbour. */
    std::uint32_t neighbour;
    std::uint32_t place;
  };
  /** One for each neighbour that shares the slot. */
  std::span<const Place> placesOf(std::uint32_t slot) const
  {
    return { this->Places.data() + this->FirstPlaces[slot],
      this->Places.data() + this->FirstPlaces[slot + 1] };
  }

  /**
   * What the neighbours give for vertices of this rank. Collective.
   * @param own of any vertices; only those of shared ones are sent
   */
  std::vector<StartValue> exchange(RankGroup& ranks, std::span<const StartValue> own) const;
  /** Replaces the number of each shared vertex by the largest that any rank has for it.
   * Collective. */
  void takeLargest(RankGroup& ranks, std::span<float> ofVertices) const
  {
    std::vector<StartValue> own;
    for (const Index vertex : this->Vertices)
    {
      own.push_back({ vertex, 0, ofVertices[vertex], false });
    }
    for (const StartValue& other : this->exchange(ranks, own))
    {
      float& largest = ofVertices[other.vertex];
      largest = std::max(largest, static_cast<float>(other.value));
    }
  }

  bool owns(Index vertex) const { return this->globalOf(vertex).rank == this->Rank; }
  GlobalVertex globalOf(Index vertex) const;
  /** The number that a vertex has on this rank, NoIndex where it has none. */
  Index find(const GlobalVertex& vertex) const;
  /** The slot of a vertex, NoIndex where it is not shared. */
  Index slotOf(Index vertex) const;

private:
  void findPlaces();

  int Rank;
  /** Sorted. */
  std::vector<Index> Vertices;
  /** By slot. */
  std::vector<GlobalVertex> Globals;
  /** The slots in the order of Globals. */
  std::vector<std::uint32_t> ByGlobal;
  std::vector<Neighbour> Neighbours;
  /** By slot. */
  std::vector<std::uint32_t> FirstPlaces;
  std::vector<Place> Places;
};

/** A value of a shared vertex as it goes from neighbour to neighbour. */
struct SentValue
{
  /** In the list of shared vertices that both agree on. */
  std::uint32_t place;
  Index label : 31;
  Index isFinal : 1;
  double value;
};

}

#endif

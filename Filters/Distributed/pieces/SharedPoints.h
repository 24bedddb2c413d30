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
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace geodesic
{
class TriangleMesh;
}

namespace geodesic::distributed
{

/** Identifies a vertex on all ranks, by the lowest rank that has it and its number on that rank. */
struct GlobalVertex
{
  int rank;
  Index vertex;

  friend auto operator<=>(const GlobalVertex&, const GlobalVertex&) = default;
};

/** For tables of vertices. */
struct HashOfVertex
{
  std::size_t operator()(const GlobalVertex& vertex) const
  {
    const auto rank = static_cast<std::uint64_t>(static_cast<std::uint32_t>(vertex.rank));
    return std::hash<std::uint64_t>{}(rank << 32 | vertex.vertex);
  }
};

/**
 * The vertices of this rank's piece of a surface that other ranks have, too.
 *
 * Only vertices inside the bounding box of another piece are candidates. Time and memory O(vertices
 * in overlapping boxes + boundary).
 */
class SharedPoints
{
public:
  /**
   * Finds the shared vertices. Collective.
   * @param keys one key for each vertex; equal keys on different ranks mean the same point
   */
  SharedPoints(RankGroup& ranks, const TriangleMesh& mesh, std::span<const Key> keys);

  /**
   * The shared vertices by their numbers on this rank, sorted. A *slot* is a position in this list.
   */
  std::span<const Index> vertices() const { return this->Vertices; }

  /** A rank that shares vertices with this one. */
  struct Neighbour
  {
    int rank;
    /** The slots of the shared vertices, in an order that both ranks agree on. */
    std::vector<std::uint32_t> slots;
  };
  /** The neighbours, in the order that RankGroup::exchange() needs. */
  std::span<const Neighbour> neighbours() const { return this->Neighbours; }

  /** The position of a shared vertex in the list of a neighbour. */
  struct Place
  {
    /** The position of the neighbour in neighbours(). */
    std::uint32_t neighbour;
    std::uint32_t place;
  };
  /** The places of a slot, one for each neighbour that shares it. */
  std::span<const Place> placesOf(std::uint32_t slot) const
  {
    return { this->Places.data() + this->FirstPlaces[slot],
      this->Places.data() + this->FirstPlaces[slot + 1] };
  }

  /**
   * Sends values to the neighbours, and returns their values for vertices of this rank. Collective.
   * @param own values of any vertices; only those of shared vertices are sent
   */
  std::vector<StartValue> exchange(RankGroup& ranks, std::span<const StartValue> own) const;
  /** Sets the number of each shared vertex to its largest value on any rank. Collective. */
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

  /** Whether this rank is the lowest one that has a vertex. */
  bool owns(Index vertex) const { return this->globalOf(vertex).rank == this->Rank; }
  GlobalVertex globalOf(Index vertex) const;
  /** The number of a vertex on this rank; NoIndex if this rank does not have it. */
  Index find(const GlobalVertex& vertex) const;
  /** The slot of a vertex; NoIndex if the vertex is not shared, as one that a split has added to
   * the mesh. */
  Index slotOf(Index vertex) const;

private:
  void findPlaces();

  int Rank;
  /** Whether a vertex is shared. */
  std::vector<bool> IsShared;
  /** The shared vertices, sorted. */
  std::vector<Index> Vertices;
  /** The shared vertices as all ranks identify them, by slot. */
  std::vector<GlobalVertex> Globals;
  /** The slots, sorted by their entries in Globals. */
  std::vector<std::uint32_t> ByGlobal;
  std::vector<Neighbour> Neighbours;
  /** The first of each slot's places in Places. */
  std::vector<std::uint32_t> FirstPlaces;
  std::vector<Place> Places;
};

/** A value of a shared vertex in a message to a neighbour. */
struct SentValue
{
  /** The position in the list of shared vertices that both ranks agree on. */
  std::uint32_t place;
  Index label : 31;
  Index isFinal : 1;
  double value;
};

}

#endif

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NarrowUpdate_h
#define geodesic_NarrowUpdate_h

#include "base/Vector3.h"
#include "march/EikonalUpdate.h"
#include "march/NeighbourValues.h"
#include "march/SourceFront.h"
#include "march/TriangleSlack.h"
#include "march/UpdateBounds.h"
#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace geodesic
{

/**
 * What NeighbourUpdate does, for a batch of one vertex or two, with one label and cost 1: one
 * neighbour after the other. A front on a strip is never longer than that. Each step of
 * NeighbourUpdate then waits for the one before, and a strip of 300,000 squares takes 102 ms, with
 * this 52 ms (worst_cases.md). Larger batches are slower this way, as a processor can't predict
 * which neighbours gain.
 * @tparam Values  OneLabelValues
 */
template <class Values>
class NarrowUpdate
{
public:
  NarrowUpdate(const TriangleMesh& mesh, const UpdateBounds& bounds, const ClosedTriangles& closed,
    Values& values)
    : Mesh(mesh)
    , Bounds(bounds)
    , Closed(closed)
    , IsAllOpen(closed.isEmpty())
    , FrontValues(values)
  {
  }

  /** Whether this is the way to treat some items of the queue. */
  bool suits(std::span<const Index> waiting) const
  {
    return waiting.size() <= MostItems &&
      std::all_of(waiting.begin(), waiting.end(),
        [&](Index item)
        {
          const std::size_t size = this->Mesh.ring(this->FrontValues.vertexOf(item)).size();
          return size > 1 && size <= LongestRing;
        });
  }

  /** Updates the neighbours of the vertex of an item over the triangles round it. @pre suits() */
  void update(Index item)
  {
    const PoppedValue taken = this->FrontValues.pop(item);
    if (taken.vertex == NoIndex)
    {
      return;
    }
    const std::span<const RingEntry> entries = this->Mesh.ring(taken.vertex);
    const std::span<Neighbour> ring = std::span(this->Ring).first(entries.size());
    this->read(taken.vertex, entries, ring);
    const bool closes = ring.front().vertex == ring.back().vertex;
    for (std::size_t i = 0; i < ring.size() - (closes ? 1 : 0); ++i)
    {
      const double rise = ring[i].value - taken.value;
      if (rise > 0.0 && ring[i].square < rise * rise && this->isOpenEdge(taken.vertex, i, closes))
      {
        this->template propose<Way::Along>(taken, ring[i], taken.value + std::sqrt(ring[i].square));
      }
    }
    if (closes)
    {
      // On an intrinsic mesh the vector may be another one.
      ring.back().value = ring.front().value;
      ring.back().isQueued = ring.front().isQueued;
    }
    const EntryNumber* const slacks =
      this->Bounds.slacks() + this->Mesh.rings().numberOf(entries.data());
    for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    {
      this->updateAcross(taken, i, ring[i], ring[i + 1], TriangleSlack::from(slacks[i]));
    }
  }

private:
  static constexpr std::size_t MostItems = 2;
  static constexpr std::size_t LongestRing = 16;

  struct Neighbour
  {
    Index vertex;
    /** What the vertex has. */
    double value;
    bool isQueued;
    /** The vector to it from the vertex of the ring, and the square of its length. */
    Vector3 offset;
    double square;
  };

  void read(Index vertex, std::span<const RingEntry> entries, std::span<Neighbour> neighbours) const
  {
    for (std::size_t i = 0; i < entries.size(); ++i)
    {
      const Index there = entries[i].neighbour();
      const NeighbourValue known = this->FrontValues.known(there);
      const Vector3 offset = this->Mesh.toNeighbour(vertex, i);
      neighbours[i] = { there, known.value, known.isQueued, offset, dot(offset, offset) };
    }
  }

  /** Whether fronts may cross the triangle that an entry opens. The slack of one that opens none is
   * infinite. */
  bool isOpen(Index vertex, std::size_t entry) const
  {
    return this->IsAllOpen || this->Closed.isOpen(vertex, entry);
  }
  /** Whether they may cross a triangle beside the edge of an entry. @param closes  whether the last
   * entry is the first one again */
  bool isOpenEdge(Index vertex, std::size_t entry, bool closes) const
  {
    return this->IsAllOpen || this->Closed.isOpenEdge(vertex, entry) ||
      (closes && entry == 0 && this->Closed.isOpen(vertex, this->Mesh.ring(vertex).size() - 2));
  }

  /** Updates both neighbours of a triangle over the edge from the vertex of the ring to the other
   * one: unless that one waits itself, see CandidateLists. */
  void updateAcross(const PoppedValue& taken, std::size_t entry, Neighbour& first,
    Neighbour& second, const TriangleSlack& slack)
  {
    const double bound = taken.value + slack.value();
    const auto mayGain = [&](const Neighbour& target, const Neighbour& other)
    { return bound + other.value < 2.0 * target.value && (slack.isThin() || !other.isQueued); };
    const bool mayFirst = mayGain(first, second);
    const bool maySecond = mayGain(second, first);
    if ((!mayFirst && !maySecond) || !this->isOpen(taken.vertex, entry))
    {
      return;
    }
    const double product = dot(first.offset, second.offset);
    const Vector3 normal = cross(first.offset, second.offset);
    const double area = dot(normal, normal);
    if (mayFirst)
    {
      this->crossEdge(taken, { second.square, product, area }, second.value, first);
    }
    if (maySecond)
    {
      this->crossEdge(taken, { first.square, product, area }, first.value, second);
    }
  }

  void crossEdge(
    const PoppedValue& taken, const FlatTriangle& triangle, double atOther, Neighbour& target)
  {
    const double value = taken.label->shape == FrontShape::Straight
      ? straightFrontCrossing<double>(triangle, taken.value, atOther, 1.0)
      : pointSourceCrossing<double>(triangle, taken.value, atOther);
    if (value < target.value)
    {
      this->template propose<Way::Across>(taken, target, value);
    }
  }

  template <Way way>
  void propose(const PoppedValue& from, Neighbour& target, double value)
  {
    const NeighbourValue held =
      this->FrontValues.template propose<way>(*from.label, target.vertex, value);
    target.value = held.value;
    target.isQueued = held.isQueued;
  }

  const TriangleMesh& Mesh;
  const UpdateBounds& Bounds;
  const ClosedTriangles& Closed;
  bool IsAllOpen;
  Values& FrontValues;
  std::array<Neighbour, LongestRing> Ring;
};

}

#endif

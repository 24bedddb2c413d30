// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CandidateScan_h
#define geodesic_CandidateScan_h

#include "base/Lanes.h"
#include "march/NeighbourValues.h"
#include "march/TriangleSlack.h"
#include "march/UpdateBatch.h"
#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <span>

namespace geodesic
{

/**
 * Finds the candidates of a batch, the neighbours that may gain by an update, and notes them in the
 * masks of UpdateBatch. It is a part of NeighbourUpdate, which also explains Cost and Values.
 *
 * The scan reads two or four neighbours at a time. It has no branch on what it finds, so that the
 * processor can go ahead to the next ring while it waits for memory.
 */
template <class Cost, class Values>
class CandidateScan
{
public:
  CandidateScan(
    const TriangleMesh& mesh, const ClosedTriangles& closed, const Cost& cost, Values& values)
    : Mesh(mesh)
    , Closed(closed)
    , IsAllOpen(Cost::isUnit && closed.isEmpty())
    , TriangleCost(cost)
    , FrontValues(values)
  {
  }

  /**
   * Reads the neighbours of a row into the batch. With one label it notes the candidates as well;
   * with several, judge() does that when all values are known.
   * @param taken   the value that the row was made for
   * @param number  of the row
   * @pre at least two slots of the row are in use
   */
  template <class Real>
  GEODESIC_FLAT void scan(const PoppedValue& taken, std::size_t number, UpdateBatch& batch) const
  {
    UpdateBatch::Row& row = batch.Rows[number];
    const std::size_t base = number * UpdateBatch::Size;
    const RingEntry* const entries = row.entries;
    const std::size_t size = row.size;
    const Vector3* const positions = this->Mesh.positions().data();
    const Vector3& centre = positions[taken.vertex];
    const Vector3Of<Real> origin{ sameOf<Real>(centre.x), sameOf<Real>(centre.y),
      sameOf<Real>(centre.z) };
    const Vector3* const offsets = this->offsetsOf(entries);
    const typename Values::Reader reader = this->FrontValues.reader(*taken.label);
    Judgement<Real> judgement(this->TriangleCost, taken.vertex, taken.value);
    std::size_t others = batch.OthersCount;
    unsigned isQueued = 0;
    for (std::size_t i = 0; i < size; i += lanes<Real>)
    {
      // The last lanes may lie behind the row. Their numbers are written and never used.
      const Indices<Real> neighbours = neighboursIn<Real>(entries + i);
      std::copy_n(neighbours.begin(), lanes<Real>, &batch.Neighbours[base + i]);
      const BestValues<Real> seen = reader.template look<Real>(neighbours);
      const Vector3Of<Real> offset = offsets
        ? sideBySide<Real>([&](int lane) -> const Vector3& { return offsets[i + lane]; })
        : sideBySide<Real>(
            [&](int lane) -> const Vector3& { return positions[neighbours[lane]]; }) -
          origin;
      const Real squares = dot(offset, offset);
      store(seen.values, &batch.Values[base + i]);
      store(offset.x, &batch.X[base + i]);
      store(offset.y, &batch.Y[base + i]);
      store(offset.z, &batch.Z[base + i]);
      store(squares, &batch.SquaredLengths[base + i]);
      isQueued |= seen.areQueued << i;
      if constexpr (Values::hasOtherLabels)
      {
        store(seen.values, &batch.Ceilings[base + i]);
        batch.OthersSeen[others] = { base + i, seen.areOther };
        others += seen.areOther != 0;
      }
      else
      {
        judgement.add(
          i, row.slacks + i, neighbours, squares, seen.values, seen.values, &batch.Costs[base + i]);
      }
    }
    const std::size_t last = size - 1;
    const bool closes = entries[0].neighbour() == entries[last].neighbour();
    const auto end = static_cast<Mask>(1u << size >> 1);
    row.label = taken.label;
    row.last = closes ? static_cast<Index>(last) : 0;
    batch.OwnValues[number] = taken.value;
    batch.end[number] = end;
    batch.again[number] = closes ? end : Mask(0);
    batch.isQueued[number] = static_cast<Mask>(isQueued);
    if (!this->IsAllOpen)
    {
      batch.isOpen[number] = this->openTriangles(row, last);
    }
    if constexpr (Values::hasOtherLabels)
    {
      batch.OthersCount = others;
      batch.isStraight[number] = BatchMasks::allIf(taken.label->shape == FrontShape::Straight);
    }
    else
    {
      judgement.put(number, batch);
    }
  }

  /** Notes the candidates of a row in the masks of the batch. @pre the batch has the values of all
   * neighbours in the row */
  template <class Real>
  GEODESIC_FLAT void judge(std::size_t number, UpdateBatch& batch) const
  {
    const UpdateBatch::Row& row = batch.Rows[number];
    const std::size_t base = number * UpdateBatch::Size;
    Judgement<Real> judgement(this->TriangleCost, row.vertex, batch.OwnValues[number]);
    for (std::size_t i = 0; i < row.size; i += lanes<Real>)
    {
      Indices<Real> neighbours;
      std::copy_n(&batch.Neighbours[base + i], lanes<Real>, neighbours.begin());
      judgement.add(i, row.slacks + i, neighbours, load<Real>(&batch.SquaredLengths[base + i]),
        load<Real>(&batch.Values[base + i]), load<Real>(&batch.Ceilings[base + i]),
        &batch.Costs[base + i]);
    }
    judgement.put(number, batch);
  }

private:
  using Mask = BatchMasks::Mask;

  /** TriangleMesh::offsets() from some ring entries on; null if the mesh is not intrinsic. */
  const Vector3* offsetsOf(const RingEntry* entries) const
  {
    return this->Mesh.isIntrinsic()
      ? this->Mesh.offsets().data() + this->Mesh.rings().numberOf(entries)
      : nullptr;
  }

  template <class Real>
  GEODESIC_INLINED static Indices<Real> neighboursIn(const RingEntry* entries)
  {
    Indices<Real> neighbours;
    for (std::size_t lane = 0; lane < lanes<Real>; ++lane)
    {
      neighbours[lane] = entries[lane].neighbour();
    }
    return neighbours;
  }

  /** The slacks of two or four triangles, as many as a Real has lanes. */
  template <class Real>
  class Slacks
  {
  public:
    GEODESIC_INLINED explicit Slacks(const EntryNumber* stored)
      : Bits(bitsWith<Real>([&](int lane) { return std::uint32_t{ stored[lane] }; })
          << TriangleSlack::DroppedBits)
    {
    }
    GEODESIC_INLINED Real values() const
    {
      using Floats = typename FloatsBeside<Real>::Type;
      return __builtin_convertvector(std::bit_cast<Floats>(this->Bits), Real);
    }
    /** Mask of the triangles that are thin. */
    GEODESIC_INLINED unsigned areThin() const
    {
      static_assert(TriangleSlack::ThinBit == 1);
      return highestBits<Real>(this->Bits << (31 - TriangleSlack::DroppedBits));
    }

  private:
    BitsOf<Real> Bits;
  };

  /** Finds the candidates of one row, two or four neighbours at a time. */
  template <class Real>
  class Judgement
  {
  public:
    /** @param vertex of the row; @param own its value */
    Judgement(const Cost& cost, Index vertex, double own)
      : TriangleCost(cost)
      , Own(own)
      , OwnCost(Real() + cost.ofVertex(vertex))
      , LastVertexCosts(OwnCost)
    {
    }

    /**
     * Treats the neighbours in slots i, i + 1 and so on.
     * @param slacksHere  of the triangles that these neighbours open
     * @param neighbours  their numbers
     * @param squares     of the lengths of the edges to them
     * @param values      their values
     * @param held        their ceilings: only values below these count
     * @param costsHere   gets the costs of the triangles that end with these neighbours
     */
    GEODESIC_INLINED void add(std::size_t i, const EntryNumber* slacksHere,
      const Indices<Real>& neighbours, const Real& squares, const Real& values, const Real& held,
      double* costsHere)
    {
      // Lane i stands for the triangle that ends with neighbour i and that the one before it opens.
      const Real vertexCosts = lanesOf<Real>(
        [&](std::size_t lane) { return this->TriangleCost.ofVertex(neighbours[lane]); });
      const Real costs = Cost::template ofTriangles<Real>(
        this->OwnCost, shiftedIn(this->LastVertexCosts, vertexCosts), vertexCosts);

      // Along an edge a neighbour gets the own value plus cost times length. Under a varying cost
      // lane i stands for the neighbour before, as both triangles beside its edge are known then.
      const Real rises = largest(held - this->Own, Real());
      const auto gain = [](const Real& square, const Real& rise, const Real& cost)
      { return bitsOf(square * cost * cost < rise * rise); };
      if constexpr (Cost::isUnit)
      {
        this->Along |= gain(squares, rises, costs) << i;
      }
      else
      {
        store(costs, costsHere);
        this->Rising |= bitsOf(rises > 0.0) << i;
        this->Along |=
          gain(shiftedIn(this->LastSquares, squares), shiftedIn(this->LastRises, rises),
            least(shiftedIn(this->LastCosts, costs), costs))
          << i;
        this->LastSquares = squares;
        this->LastRises = rises;
        this->LastCosts = costs;
        this->LastVertexCosts = vertexCosts;
      }

      // A crossing gives at least half of the sum of both values at the edge and cost times slack,
      // see TriangleSlack.
      const Slacks<Real> some(slacksHere);
      const Real slacks = some.values();
      const Real bounds = this->Own + costs * shiftedIn(this->LastSlacks, slacks);
      this->First |= bitsOf(bounds + values < 2.0 * shiftedIn(this->LastHeld, held)) << i;
      this->Second |= bitsOf(bounds + shiftedIn(this->LastValues, values) < 2.0 * held) << i;
      this->IsThin |= some.areThin() << i;
      this->LastValues = values;
      this->LastHeld = held;
      this->LastSlacks = slacks;
    }

    /** Writes what was found into the masks of row @p number. */
    void put(std::size_t number, UpdateBatch& batch) const
    {
      // Of the first and the last neighbour one triangle is not known here.
      batch.along[number] = static_cast<Mask>(
        Cost::isUnit ? this->Along : this->Rising & (this->Along >> 1 | batch.end[number] | 1u));
      batch.first[number] = static_cast<Mask>(this->First >> 1);
      batch.second[number] = static_cast<Mask>(this->Second >> 1);
      batch.isThin[number] = static_cast<Mask>(this->IsThin);
    }

  private:
    // The values, ceilings and slacks of the neighbours before those that add() treats.
    Real LastValues = Real();
    Real LastHeld = Real();
    Real LastSlacks = Real() + std::numeric_limits<double>::infinity();
    // Only in use where the cost varies.
    Real LastSquares = Real();
    Real LastRises = Real();
    Real LastCosts = Real();
    const Cost& TriangleCost;
    double Own;
    Real OwnCost;
    Real LastVertexCosts;
    unsigned Rising = 0;
    unsigned Along = 0;
    unsigned First = 0;
    unsigned Second = 0;
    unsigned IsThin = 0;
  };

  /** Mask of the first @p count triangles of a row that fronts may cross. */
  Mask openTriangles(const UpdateBatch::Row& row, std::size_t count) const
  {
    const auto firstEntry =
      static_cast<std::size_t>(row.entries - this->Mesh.ring(row.vertex).data());
    unsigned isOpen = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      isOpen |= static_cast<unsigned>(this->Closed.isOpen(row.vertex, firstEntry + i)) << i;
    }
    return static_cast<Mask>(isOpen);
  }

  const TriangleMesh& Mesh;
  const ClosedTriangles& Closed;
  /** Whether the cost is 1 and no triangle is closed. Then all entries count as open. For those
   * that open no triangle this does no harm: their infinite slack rules out crossings, and edges
   * need no triangle to have a cost. */
  bool IsAllOpen;
  const Cost& TriangleCost;
  Values& FrontValues;
};

}

#endif

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NeighbourUpdate_h
#define geodesic_NeighbourUpdate_h

#include "base/Lanes.h"
#include "march/CandidateLists.h"
#include "march/CandidateScan.h"
#include "march/EikonalUpdate.h"
#include "march/NeighbourValues.h"
#include "march/SourceFront.h"
#include "march/UpdateBatch.h"
#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"
#include "solve/SeedFront.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace geodesic
{

/**
 * Updates the neighbours of vertices over the edges round them, after their own values fell.
 *
 * An update is the least of three crossings: along either edge to the neighbour, and over the
 * inside of the edge opposite to it. Along an edge the front comes when the edge's other end is
 * swept, over an edge when the last of its ends is. Few triangles of a march need their shape: most
 * corners can gain nothing by TriangleSlack.
 *
 * What is worth a closer look differs from vertex to vertex, and a processor that guesses wrong
 * waits. So some vertices are swept together, step by step, and each step is one loop over all of
 * them: first the rings are looked at, several neighbours at a time; where a neighbour's best value
 * is of another label, its own of this one is looked up; what is worth more is noted in the bits of
 * masks; then fronts go along edges, and over edges several at a time, whose values are proposed
 * last. Of several labels those over edges come first.
 *
 * @tparam Cost    of a triangle: UnitCost or VertexCost
 * @tparam Values  of the labels of the march:
 *                 vertexOf(Index), pop(Index) -> PoppedValue of what was in the queue;
 *                 prefetch(Index), some time before that;
 *                 reader(SourceFront), to look<Real>(const Indices<Real>&) at vertices ->
 *                 BestValues<Real>;
 *                 hasOtherLabels, whether any of those can be of another label, then also
 *                 others<Real>(...) -> NeighbourValues<Real> of them, see LabelValues, and
 *                 prefetchOther(Index), to be called before; if none can,
 *                 label() -> SourceFront, the only one;
 *                 propose(SourceFront, Index, double) -> NeighbourValue: to a vertex, queues it
 * with the value if that counts, and returns what then holds
 */
template <class Cost, class Values>
class NeighbourUpdate
{
public:
  /** @param mayUseQuads whether four numbers are treated at once where the processor can; the
   * values are the same either way */
  NeighbourUpdate(const TriangleMesh& mesh, const UpdateBounds& bounds,
    const ClosedTriangles& closed, const Cost& cost, Values& values, bool mayUseQuads = true)
    : Scan(mesh, closed, cost, values)
    , Mesh(mesh)
    , Bounds(bounds)
    , TriangleCost(cost)
    , FrontValues(values)
    , UsesQuads(mayUseQuads && hasQuads())
  {
    if constexpr (!Values::hasOtherLabels)
    {
      this->Batch.isStraight =
        BatchMasks(BatchMasks::allIf(values.label().shape == FrontShape::Straight));
    }
  }

  /** Sweeps over the triangles round the vertices of @p waiting, which were in the queue; has the
   * processor fetch what that takes for @p next, which are to be swept after them. */
  void update(std::span<const Index> waiting, std::span<const Index> next)
  {
    if (this->UsesQuads)
    {
      this->updateByFour(waiting, next);
    }
    else
    {
      this->updateByTwo(waiting, next);
    }
  }

private:
  using Mask = BatchMasks::Mask;
  using Row = UpdateBatch::Row;

  // Flat: what is called from these and not inlined would not be compiled for AVX2. Clang inlines
  // only what they call themselves, so the rest on the way is marked GEODESIC_FLAT.

  [[gnu::flatten, gnu::noinline, GEODESIC_QUADS]] void updateByFour(
    std::span<const Index> waiting, std::span<const Index> next)
  {
    this->scanRings<Quad>(waiting, next, [&] { this->finishByFour(); });
  }
  [[gnu::flatten, gnu::noinline, GEODESIC_QUADS]] void finishByFour() { this->finish<Quad>(); }
  [[gnu::flatten, gnu::noinline]] void updateByTwo(
    std::span<const Index> waiting, std::span<const Index> next)
  {
    this->scanRings<Pair>(waiting, next, [&] { this->finishByTwo(); });
  }
  [[gnu::flatten, gnu::noinline]] void finishByTwo() { this->finish<Pair>(); }

  /** @param updateScanned  does what was noted in all batch */
  template <class Real, class DoNoted>
  GEODESIC_FLAT void scanRings(
    std::span<const Index> waiting, std::span<const Index> next, DoNoted updateScanned)
  {
    // Where all the rings are comes first, so that less is to be kept at hand while they are looked
    // at.
    for (const Index item : waiting)
    {
      const Index vertex = this->FrontValues.vertexOf(item);
      const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
      const bool fits = ring.size() > 1 && ring.size() <= UpdateBatch::Size;
      if (this->Batch.Count == UpdateBatch::Most || !fits) [[unlikely]]
      {
        next = this->template scanAll<Real>(next);
        updateScanned();
      }
      if (fits) [[likely]]
      {
        this->Batch.add(vertex, item, ring, this->slacksOf(ring));
      }
      else
      {
        this->template scanRingInParts<Real>(item, ring, updateScanned);
      }
    }
    this->template scanAll<Real>(next);
    updateScanned();
  }

  /** The same of one vertex, whose ring takes several batch or none. */
  template <class Real, class DoNoted>
  GEODESIC_FLAT void scanRingInParts(
    Index item, std::span<const RingEntry> ring, DoNoted updateScanned)
  {
    const PoppedValue taken = this->FrontValues.pop(item);
    if (taken.vertex == NoIndex)
    {
      return;
    }
    constexpr std::size_t step = UpdateBatch::Size - 1;
    for (std::size_t first = 0; first + 1 < ring.size(); first += step)
    {
      if (this->Batch.Count == UpdateBatch::Most)
      {
        updateScanned();
      }
      const std::span<const RingEntry> part = ring.subspan(first);
      this->Batch.add(taken.vertex, item, part, this->slacksOf(part));
      this->Scan.template scan<Real>(taken, this->Batch.Count - 1, this->Batch);
    }
    updateScanned();
  }

  /** Of the triangles that entries open. */
  const TriangleSlack* slacksOf(std::span<const RingEntry> entries) const
  {
    return this->Bounds.slacks() + this->Mesh.rings().numberOf(entries.data());
  }

  /** Takes what the rows are of and looks at them; has the processor fetch some of @p next and
   * returns the others. */
  template <class Real>
  GEODESIC_FLAT std::span<const Index> scanAll(std::span<const Index> next)
  {
    for (std::size_t number = 0; number < this->Batch.Count; ++number)
    {
      // Little by little: a processor waits when it is to fetch too much at a time.
      if (!next.empty())
      {
        this->FrontValues.prefetch(next[0]);
        next = next.subspan(1);
      }
      UpdateBatch::Row& row = this->Batch.Rows[number];
      const PoppedValue taken = this->FrontValues.pop(row.item);
      if (taken.vertex != NoIndex)
      {
        this->Scan.template scan<Real>(taken, number, this->Batch);
      }
      else
      {
        row.size = 0;
      }
    }
    return next;
  }

  /** Does what was noted. */
  template <class Real>
  GEODESIC_FLAT void finish()
  {
    if constexpr (Values::hasOtherLabels)
    {
      for (std::size_t i = 0; i < this->Batch.OthersCount; ++i)
      {
        this->template prefetchOthers<Real>(this->Batch.OthersSeen[i]);
      }
      for (std::size_t i = 0; i < this->Batch.OthersCount; ++i)
      {
        this->template readOthers<Real>(this->Batch.OthersSeen[i]);
      }
      for (std::size_t number = 0; number < this->Batch.Count; ++number)
      {
        this->Scan.template judge<Real>(number, this->Batch);
      }
      // A value of one of several labels has to be found before it can be lowered. So along edges
      // goes only what is lower still than what came over edges.
      this->Candidates.listCrossings(this->Batch);
      this->updateAcrossEdges<Real>();
      this->closeRows();
      this->Candidates.listAlong(this->Batch);
      this->updateAlongEdges();
    }
    else
    {
      this->Candidates.listAlong(this->Batch);
      this->updateAlongEdges();
      this->closeRows();
      this->Candidates.listCrossings(this->Batch);
      this->updateAcrossEdges<Real>();
    }
    this->Batch.clear();
  }

  /** All of them are fetched before the first is looked up, as many may be far in memory. */
  template <class Real>
  void prefetchOthers(UpdateBatch::Others others) const
  {
    for (std::size_t lane = 0; lane < lanes<Real>; ++lane)
    {
      this->FrontValues.prefetchOther(this->Batch.Neighbours[others.first() + lane]);
    }
  }

  /** Looks up what a label has at neighbours whose best value is of another one. */
  template <class Real>
  GEODESIC_FLAT void readOthers(UpdateBatch::Others others)
  {
    const Slot first = others.first();
    const unsigned areOther = others.which();
    const Row& row = this->Batch.at(first);
    Indices<Real> neighbours;
    std::copy_n(&this->Batch.Neighbours[first], lanes<Real>, neighbours.begin());
    const Real best = load<Real>(&this->Batch.Values[first]);
    const NeighbourValues<Real> known =
      this->FrontValues.template others<Real>(neighbours, areOther, *row.label, best);
    const TestOf<Real> isOther = whereSet<Real>(areOther);
    store(select(isOther, known.values, best), &this->Batch.Values[first]);
    store(select(isOther, known.ceilings, best), &this->Batch.Ceilings[first]);
    this->Batch.isQueued[UpdateBatch::rowOf(first)] |=
      static_cast<Mask>((known.areQueued & areOther) << first % UpdateBatch::Size);
  }

  /** Of the first neighbours, where they come again as the last ones of their batch: what came to
   * either came to both. */
  void closeRows()
  {
    for (std::size_t number = 0; number < UpdateBatch::Most; ++number)
    {
      double* const known = &this->ceilings()[number * UpdateBatch::Size];
      double& again = known[this->Batch.Rows[number].last];
      if constexpr (Values::hasOtherLabels)
      {
        known[0] = std::min(known[0], again);
      }
      else
      {
        again = known[0];
      }
    }
  }

  void updateAlongEdges()
  {
    if constexpr (Values::hasOtherLabels)
    {
      // Which of them lower a value is not to be guessed, so there is no branch on it.
      std::size_t count = this->NumberOfProposals;
      for (std::size_t i = 0; i < this->Candidates.along().size(); ++i)
      {
        const Slot slot = this->Candidates.along()[i];
        const double value = this->valueAlong(slot);
        this->Proposals[count] = { value, slot };
        count += value < this->ceilings()[slot] ? 1 : 0;
      }
      this->NumberOfProposals = count;
      this->propose();
    }
    else
    {
      for (std::size_t i = 0; i < this->Candidates.along().size(); ++i)
      {
        this->updateAlongEdges(this->Candidates.along()[i]);
      }
    }
  }

  /** What comes over edges next is to know of it. */
  void updateAlongEdges(Slot slot)
  {
    const double value = this->valueAlong(slot);
    if (value < this->ceilings()[slot])
    {
      const std::size_t row = UpdateBatch::rowOf(slot);
      const NeighbourValue held = this->FrontValues.propose(
        *this->Batch.Rows[row].label, this->Batch.Neighbours[slot], value);
      this->Batch.Values[slot] = held.value;
      this->Batch.isQueued[row] |=
        static_cast<Mask>(static_cast<unsigned>(held.isQueued) << slot % UpdateBatch::Size);
    }
  }

  double valueAlong(Slot slot) const
  {
    const double length = std::sqrt(this->Batch.SquaredLengths[slot]);
    return this->Batch.OwnValues[UpdateBatch::rowOf(slot)] + this->edgeCost(slot) * length;
  }

  /** Of one label's neighbours values and ceilings are the same. */
  auto& ceilings()
  {
    if constexpr (Values::hasOtherLabels)
    {
      return this->Batch.Ceilings;
    }
    else
    {
      return this->Batch.Values;
    }
  }

  /** That of the cheaper open triangle beside the edge to the neighbour in a slot. */
  double edgeCost(Slot slot) const
  {
    if constexpr (Cost::isUnit)
    {
      return 1.0;
    }
    constexpr double none = std::numeric_limits<double>::infinity();
    const std::size_t row = UpdateBatch::rowOf(slot);
    const unsigned isOpen = this->Batch.isOpen[row];
    const std::size_t again = this->Batch.Rows[row].last;
    const std::size_t i = slot % UpdateBatch::Size;
    const std::size_t base = slot - i;
    const std::size_t last = i > 0 ? i - 1 : again > 0 ? again - 1 : UpdateBatch::Size;
    const double after = isOpen >> i & 1 ? this->triangleCost(slot) : none;
    const double before =
      isOpen >> last & 1 ? this->triangleCost(static_cast<Slot>(base + last)) : none;
    return std::min(before, after);
  }

  /** Of the triangle that the neighbour in a slot opens. */
  double triangleCost(Slot slot) const
  {
    return this->TriangleCost.ofTriangle(
      this->Batch.at(slot).vertex, this->Batch.Neighbours[slot], this->Batch.Neighbours[slot + 1]);
  }

  template <class Real>
  GEODESIC_FLAT void updateAcrossEdges()
  {
    this->updateAcrossEdges<Real, FrontShape::Round>();
    this->updateAcrossEdges<Real, FrontShape::Straight>();
    this->propose();
  }

  template <class Real, FrontShape Shape>
  GEODESIC_FLAT void updateAcrossEdges()
  {
    auto& crossings = this->Candidates.across(Shape);
    crossings.pad(lanes<Real>);
    std::size_t count = this->NumberOfProposals;
    for (std::size_t i = 0; i < crossings.size(); i += lanes<Real>)
    {
      count = this->crossEdges<Real, Shape>(&crossings[i], count);
    }
    this->NumberOfProposals = count;
  }

  /** As many at once as a Real has numbers. Puts what lowers a value behind the first @p count
   * proposals; returns how many there are then. */
  template <class Real, FrontShape Shape>
  GEODESIC_FLAT std::size_t crossEdges(const EdgeCrossing* crossings, std::size_t count)
  {
    const UpdateBatch& batch = this->Batch;
    const auto over = [&](std::size_t lane) { return crossings[lane].across(); };
    const auto target = [&](std::size_t lane) { return crossings[lane].target(); };
    const Vector3Of<Real> toOver{ gathered<Real>(batch.X, over), gathered<Real>(batch.Y, over),
      gathered<Real>(batch.Z, over) };
    const Vector3Of<Real> toTarget{ gathered<Real>(batch.X, target),
      gathered<Real>(batch.Y, target), gathered<Real>(batch.Z, target) };
    const Vector3Of<Real> normal = cross(toOver, toTarget);
    const FlatTriangleOf<Real> flat{ gathered<Real>(batch.SquaredLengths, over),
      dot(toOver, toTarget), dot(normal, normal) };
    const Real a = gathered<Real>(
      batch.OwnValues, [&](std::size_t lane) { return UpdateBatch::rowOf(over(lane)); });
    const Real b = gathered<Real>(batch.Values, over);
    const Real cost = lanesOf<Real>(
      [&](std::size_t lane) { return this->triangleCost(std::min(over(lane), target(lane))); });
    const Real values = Shape == FrontShape::Round
      ? cost * pointSourceCrossing<Real>(flat, a / cost, b / cost)
      : straightFrontCrossing<Real>(flat, a, b, cost);
    const unsigned isLower = bitsOf(values < gathered<Real>(this->ceilings(), target));
    for (std::size_t lane = 0; lane < lanes<Real>; ++lane)
    {
      this->Proposals[count] = { values[lane], target(lane) };
      count += isLower >> lane & 1;
    }
    return count;
  }

  /** Proposes what was found over edges. */
  [[gnu::flatten, gnu::noinline]] void propose()
  {
    for (std::size_t i = 0; i < this->NumberOfProposals; ++i)
    {
      const Proposal& proposal = this->Proposals[i];
      const NeighbourValue held = this->FrontValues.propose(*this->Batch.at(proposal.target).label,
        this->Batch.Neighbours[proposal.target], proposal.value);
      if constexpr (Values::hasOtherLabels)
      {
        this->Batch.Ceilings[proposal.target] = held.ceiling;
      }
    }
    this->NumberOfProposals = 0;
  }

  struct Proposal
  {
    double value;
    Slot target;
  };

  UpdateBatch Batch;
  CandidateScan<Cost, Values> Scan;
  const TriangleMesh& Mesh;
  const UpdateBounds& Bounds;
  const Cost& TriangleCost;
  Values& FrontValues;
  CandidateLists Candidates;
  /** What propose() proposes. */
  std::array<Proposal, 4 * UpdateBatch::Slots + lanes<Quad>> Proposals;
  std::size_t NumberOfProposals = 0;
  bool UsesQuads;
};

}

#endif

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NeighbourUpdate_h
#define geodesic_NeighbourUpdate_h

#include "base/Lanes.h"
#include "march/CandidateLists.h"
#include "march/CandidateScan.h"
#include "march/EikonalUpdate.h"
#include "march/HubTies.h"
#include "march/NarrowUpdate.h"
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
#include <utility>

namespace geodesic
{

/**
 * The heart of FastMarchingSolver: updates the neighbours of the vertices in a batch, after the
 * values of these vertices fell. ReferenceSolver does the same in updateNeighbours(), for one
 * vertex and one update at a time. The formula is in EikonalUpdate.h.
 *
 * An update of a neighbour is the least of three values: along either edge to the neighbour, and by
 * a crossing of the inside of the edge opposite to it. The part along an edge is computed when the
 * edge's other end is taken from the queue, the crossing when the last of the edge's ends is. Few
 * updates need the triangle's shape: TriangleSlack tells that most corners can gain nothing.
 *
 * Which updates are needed differs from vertex to vertex, and a processor that predicts a branch
 * wrongly has to wait. So a batch is treated step by step, and each step is one loop over all of
 * it:
 *
 *  1. scanAll(): the values are taken from the queue and their rings read into rows of UpdateBatch,
 *     two or four neighbours at a time
 *  2. readOthers(), with several labels: if the best value of a neighbour is of another label, its
 *     value of the row's label is looked up
 *  3. CandidateScan: neighbours that may gain are noted in masks
 *  4. CandidateLists: the masks are turned into lists
 *  5. updateAlongEdges(): updates along edges
 *  6. updateAcrossEdges(): crossings, two or four at a time, whose values are proposed last
 *
 * With several labels step 6 comes before step 5, see finish(). With one label at cost 1 a batch of
 * a vertex or two is left to NarrowUpdate.
 *
 * @tparam Cost    cost of a triangle: UnitCost or VertexCost
 * @tparam Values  the values of the march: OneLabelValues or LabelValues. It has
 *                 - vertexOf(Index): the vertex of an item of the queue;
 *                 - isWaiting(Index): whether the value of an item is still queued;
 *                 - pop(Index) -> PoppedValue: the value of an item that was taken from the queue;
 *                 - prefetch(Index): to be called some time before pop();
 *                 - reader(SourceFront): an object whose look<Real>(const Indices<Real>&) reads
 *                   vertices -> BestValues<Real>;
 *                 - propose<Way>(SourceFront, Index, double) -> NeighbourValue: gives a vertex the
 * value and queues it, if the value counts; returns what the vertex then has;
 *                 - hasOtherLabels: whether there are several labels;
 *                 - if so, others<Real>(...) -> NeighbourValues<Real> (see LabelValues), and
 *                   prefetchOther(Index), to be called some time before it, and
 *                   prefetchBound(Index), some time before propose();
 *                 - if not, label() -> SourceFront: the only label
 */
template <class Cost, class Values>
class NeighbourUpdate
{
public:
  /** @param mayUseQuads whether four numbers are treated at once if the processor can; the values
   * are the same either way */
  NeighbourUpdate(const TriangleMesh& mesh, const UpdateBounds& bounds,
    const ClosedTriangles& closed, const Cost& cost, Values& values, bool mayUseQuads = true)
    : Scan(mesh, closed, cost, values)
    , Narrow(mesh, bounds, closed, values)
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

  /**
   * Updates the neighbours of vertices over the triangles round these vertices.
   * @param waiting  items that were taken from the queue
   * @param next     items that are likely to come after them; the processor fetches their rings
   */
  void update(std::span<const Index> waiting, std::span<const Index> next)
  {
    if constexpr (MayBeNarrow)
    {
      if (this->Narrow.suits(waiting))
      {
        this->updateNarrow(waiting);
        return;
      }
    }
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

  /** Whether there is a way of their own for batches of a few vertices. */
  static constexpr bool MayBeNarrow = Cost::isUnit && requires(const Values& values)
  {
    values.known(Index());
  };

  [[gnu::noinline]] void updateNarrow(std::span<const Index> waiting)
  {
    if constexpr (MayBeNarrow)
    {
      for (const Index item : waiting)
      {
        this->Narrow.update(item);
      }
    }
  }

  // These functions are flat, because a function that they call without inlining it would not be
  // compiled for AVX2. Clang inlines only what they call themselves; functions further down are
  // marked GEODESIC_FLAT.

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

  /** Treats all of @p waiting, batch by batch. @param updateScanned  calls finish() for a batch
   * that was scanned */
  template <class Real, class UpdateScanned>
  GEODESIC_FLAT void scanRings(
    std::span<const Index> waiting, std::span<const Index> next, UpdateScanned updateScanned)
  {
    // All rows are added before the first is scanned, so that the scan has fewer variables to keep
    // in the processor's registers.
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

  /** Treats one item whose ring needs several rows, or none. Neighbouring parts of the ring have
   * one entry in common. @pre the batch is empty */
  template <class Real, class UpdateScanned>
  GEODESIC_FLAT void scanRingInParts(
    Index item, std::span<const RingEntry> ring, UpdateScanned updateScanned)
  {
    const PoppedValue taken = this->FrontValues.pop(item);
    if (taken.vertex == NoIndex)
    {
      return;
    }
    if constexpr (Values::hasOtherLabels)
    {
      if (this->FrontValues.hasBounds() &&
        !this->Ties.goesOn(
          taken.vertex, ring.size(), taken.label->number(), taken.label->distance(taken.value)))
      {
        return;
      }
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

  /** The slacks of the triangles that ring entries open. */
  const EntryNumber* slacksOf(std::span<const RingEntry> entries) const
  {
    return this->Bounds.slacks() + this->Mesh.rings().numberOf(entries.data());
  }

  /** Takes the values of all rows and scans the rows. Has the processor fetch the rings of some of
   * @p next. @return the rest of @p next */
  template <class Real>
  GEODESIC_FLAT std::span<const Index> scanAll(std::span<const Index> next)
  {
    for (std::size_t number = 0; number < this->Batch.Count; ++number)
    {
      // One for each row, because a processor waits if it is to fetch too much at a time.
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

  /** Computes and proposes the updates of a batch that was scanned, and clears it. */
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
      // With several labels a value must be found before it can be lowered. So crossings come
      // first; then a value along an edge is only proposed if it is lower still.
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

  /** Has the processor fetch what readOthers() reads. It is called for all of them before the first
   * is read, as many may be far in memory. */
  template <class Real>
  void prefetchOthers(UpdateBatch::Others others) const
  {
    for (std::size_t lane = 0; lane < lanes<Real>; ++lane)
    {
      this->FrontValues.prefetchOther(this->Batch.Neighbours[others.first() + lane]);
    }
  }

  /** Reads the values of a row's label at neighbours whose best value is of another label, into the
   * batch. */
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

  /** In rings that close, the first neighbour is in the row twice: gives both slots the value that
   * updates gave to one of them. */
  void closeRows()
  {
    for (std::size_t number = 0; number < this->Batch.Count; ++number)
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
      // A processor can't predict which of them lower a value, so there is no branch on it.
      std::size_t count = this->NumberOfProposals;
      for (std::size_t i = 0; i < this->Candidates.along().size(); ++i)
      {
        const Slot slot = this->Candidates.along()[i];
        this->FrontValues.prefetchBound(this->Batch.Neighbours[slot]);
        const double value = this->valueAlong(slot);
        this->Proposals[count] = { value, slot };
        count += value < this->ceilings()[slot] ? 1 : 0;
      }
      this->NumberOfProposals = count;
      this->template propose<Way::Along>();
    }
    else
    {
      for (std::size_t i = 0; i < this->Candidates.along().size(); ++i)
      {
        this->updateAlongEdges(this->Candidates.along()[i]);
      }
    }
  }

  /** Updates the neighbour in a slot, and stores in the batch what it then has: the crossings that
   * come next read it. */
  void updateAlongEdges(Slot slot)
  {
    const double value = this->valueAlong(slot);
    if (value < this->ceilings()[slot])
    {
      const std::size_t row = UpdateBatch::rowOf(slot);
      const NeighbourValue held = this->FrontValues.template propose<Way::Along>(
        *this->Batch.Rows[row].label, this->Batch.Neighbours[slot], value);
      this->Batch.Values[slot] = held.value;
      this->Batch.isQueued[row] |=
        static_cast<Mask>(static_cast<unsigned>(held.isQueued) << slot % UpdateBatch::Size);
    }
  }

  /** The value that the neighbour in a slot gets along the edge to it. */
  double valueAlong(Slot slot) const
  {
    const double length = std::sqrt(this->Batch.SquaredLengths[slot]);
    return this->Batch.OwnValues[UpdateBatch::rowOf(slot)] + this->edgeCost(slot) * length;
  }

  /** The ceilings of the neighbours. With one label they are the values. */
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

  /** The cost of the edge to the neighbour in a slot: that of the cheaper open triangle beside it.
   */
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

  /** The cost of the triangle that the neighbour in a slot opens. */
  double triangleCost(Slot slot) const { return Cost::isUnit ? 1.0 : this->Batch.Costs[slot + 1u]; }

  /** Computes the crossings of fronts of both shapes, and proposes their values. */
  template <class Real>
  GEODESIC_FLAT void updateAcrossEdges()
  {
    this->updateAcrossEdges<Real, FrontShape::Round>();
    this->updateAcrossEdges<Real, FrontShape::Straight>();
    this->template propose<Way::Across>();
  }

  /** Computes the crossings of fronts of a shape; their values become proposals. */
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

  /**
   * Computes crossings, as many at once as a Real has lanes. Those below the ceilings of their
   * targets become proposals.
   * @param count  number of proposals so far
   * @return the number of proposals then
   */
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
    const Real values = this->crossingOf<Real, Shape>(crossings, flat, a, b, cost);
    const unsigned isLower = bitsOf(values < gathered<Real>(this->ceilings(), target));
    for (std::size_t lane = 0; lane < lanes<Real>; ++lane)
    {
      this->Proposals[count] = { values[lane], target(lane) };
      count += isLower >> lane & 1;
    }
    return count;
  }

  /** The crossings of edges by fronts of a shape; round ones cross bypassed triangles as straight
   * ones. */
  template <class Real, FrontShape Shape>
  GEODESIC_INLINED Real crossingOf(const EdgeCrossing* crossings, const FlatTriangleOf<Real>& flat,
    const Real& a, const Real& b, const Real& cost) const
  {
    const auto asRound = [&] { return cost * pointSourceCrossing<Real>(flat, a / cost, b / cost); };
    if constexpr (Shape == FrontShape::Straight)
    {
      return straightFrontCrossing<Real>(flat, a, b, cost);
    }
    if (!this->TriangleCost.hasDetours())
    {
      return asRound();
    }
    const auto neighbour = [&](Slot slot) { return this->Batch.Neighbours[slot]; };
    const Real areBypassed = lanesOf<Real>(
      [&](std::size_t lane)
      {
        const auto [over, target] = std::pair(crossings[lane].across(), crossings[lane].target());
        return this->TriangleCost.isBypassed(
                 cost[lane], this->Batch.at(over).vertex, neighbour(over), neighbour(target))
          ? 1.0
          : 0.0;
      });
    // Where costs are spread, it is mostly all.
    const auto isRound = areBypassed < 1.0;
    const Real bypassed = bypassedCrossing<Real>(flat, a, b, cost);
    return any(isRound) ? select(isRound, asRound(), bypassed) : bypassed;
  }

  /** Proposes the values in Proposals to their vertices, and empties it. */
  template <Way way>
  [[gnu::flatten, gnu::noinline]] void propose()
  {
    for (std::size_t i = 0; i < this->NumberOfProposals; ++i)
    {
      const Proposal& proposal = this->Proposals[i];
      const NeighbourValue held =
        this->FrontValues.template propose<way>(*this->Batch.at(proposal.target).label,
          this->Batch.Neighbours[proposal.target], proposal.value);
      if constexpr (Values::hasOtherLabels)
      {
        this->Batch.Ceilings[proposal.target] = held.ceiling;
      }
    }
    this->NumberOfProposals = 0;
  }

  /** A value for the neighbour in a slot. */
  struct Proposal
  {
    double value;
    Slot target;
  };

  UpdateBatch Batch;
  CandidateScan<Cost, Values> Scan;
  NarrowUpdate<Values> Narrow;
  const TriangleMesh& Mesh;
  const UpdateBounds& Bounds;
  const Cost& TriangleCost;
  Values& FrontValues;
  CandidateLists Candidates;
  HubTies Ties;
  /** What propose() proposes. Places behind the last proposal are written too, a Quad's at most. */
  std::array<Proposal, 4 * UpdateBatch::Slots + lanes<Quad>> Proposals;
  std::size_t NumberOfProposals = 0;
  bool UsesQuads;
};

}

#endif

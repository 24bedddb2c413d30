#ifndef geodesic_RingSweep_h
#define geodesic_RingSweep_h

#include "base/Lanes.h"
#include "march/EikonalUpdate.h"
#include "march/KnownValues.h"
#include "march/MarchedLabel.h"
#include "march/RingLook.h"
#include "march/RingWays.h"
#include "march/RingWindows.h"
#include "mesh/TriangleMesh.h"
#include "solve/ClosedFans.h"
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
 * An update is the least of three ways: along either edge to the neighbour, and over the inside of
 * the edge opposite to it. Along an edge the front comes when the edge's other end is swept, over
 * an edge when the last of its ends is. Few triangles of a march need their shape: most corners can
 * gain nothing by RingEntry::slack.
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
 *                 vertexOf(Index), take(Index) -> TakenValue of what was in the queue;
 *                 prefetch(Index), some time before that;
 *                 sight(MarchedLabel), to look<Real>(const Indices<Real>&) at vertices ->
 *                 SeenValues<Real>;
 *                 hasOthers, whether any of those can be of another label, then also
 *                 others<Real>(...) -> KnownValues<Real> of them, see LabelValues, and
 *                 prefetchOther(Index), to be called before; if none can,
 *                 label() -> MarchedLabel, the only one;
 *                 propose(MarchedLabel, Index, double) -> KnownValue: to a vertex, queues it with
 *                 the value if that counts, and returns what then holds
 */
template <class Cost, class Values>
class RingSweep
{
public:
  /** @param mayUseQuads whether four numbers are treated at once where the processor can; the
   * values are the same either way */
  RingSweep(const TriangleMesh& mesh, const ClosedFans& closed, const Cost& cost, Values& values,
    bool mayUseQuads = true)
    : Look(mesh, closed, cost, values)
    , Mesh(mesh)
    , TriangleCost(cost)
    , FrontValues(values)
    , UsesQuads(mayUseQuads && hasQuads())
  {
    if constexpr (!Values::hasOthers)
    {
      this->Windows.isStraight =
        WindowMasks(WindowMasks::allIf(values.label().shape == FrontShape::Straight));
    }
  }

  /** Sweeps over the triangles round the vertices of @p waiting, which were in the queue; has the
   * processor fetch what that takes for @p next, which are to be swept after them. */
  void sweep(std::span<const Index> waiting, std::span<const Index> next)
  {
    if (this->UsesQuads)
    {
      this->sweepByFour(waiting, next);
    }
    else
    {
      this->sweepByTwo(waiting, next);
    }
  }

private:
  using Mask = WindowMasks::Mask;
  using Window = RingWindows::Window;

  // Flat: what is called from these and not inlined would not be compiled for AVX2.

  [[gnu::flatten, gnu::noinline, GEODESIC_QUADS]] void sweepByFour(
    std::span<const Index> waiting, std::span<const Index> next)
  {
    this->lookRound<Quad>(waiting, next, [&] { this->finishByFour(); });
  }
  [[gnu::flatten, gnu::noinline, GEODESIC_QUADS]] void finishByFour() { this->finish<Quad>(); }
  [[gnu::flatten, gnu::noinline]] void sweepByTwo(
    std::span<const Index> waiting, std::span<const Index> next)
  {
    this->lookRound<Pair>(waiting, next, [&] { this->finishByTwo(); });
  }
  [[gnu::flatten, gnu::noinline]] void finishByTwo() { this->finish<Pair>(); }

  /** @param doNoted  does what was noted in all windows */
  template <class Real, class DoNoted>
  void lookRound(std::span<const Index> waiting, std::span<const Index> next, DoNoted doNoted)
  {
    // Where all the rings are comes first, so that less is to be kept at hand while they are looked
    // at.
    for (const Index item : waiting)
    {
      const Index vertex = this->FrontValues.vertexOf(item);
      const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
      const bool fits = ring.size() > 1 && ring.size() <= RingWindows::Size;
      if (this->Windows.Count == RingWindows::Most || !fits) [[unlikely]]
      {
        next = this->template noteAll<Real>(next);
        doNoted();
      }
      if (fits) [[likely]]
      {
        this->Windows.add(vertex, item, ring);
      }
      else
      {
        this->template lookRoundInParts<Real>(item, ring, doNoted);
      }
    }
    this->template noteAll<Real>(next);
    doNoted();
  }

  /** The same of one vertex, whose ring takes several windows or none. */
  template <class Real, class DoNoted>
  void lookRoundInParts(Index item, std::span<const RingEntry> ring, DoNoted doNoted)
  {
    const TakenValue taken = this->FrontValues.take(item);
    if (taken.vertex == NoIndex)
    {
      return;
    }
    constexpr std::size_t step = RingWindows::Size - 1;
    for (std::size_t first = 0; first + 1 < ring.size(); first += step)
    {
      if (this->Windows.Count == RingWindows::Most)
      {
        doNoted();
      }
      this->Windows.add(taken.vertex, item, ring.subspan(first));
      this->Look.template note<Real>(taken, this->Windows.Count - 1, this->Windows);
    }
    doNoted();
  }

  /** Takes what the windows are of and looks at them; has the processor fetch some of @p next and
   * returns the others. */
  template <class Real>
  std::span<const Index> noteAll(std::span<const Index> next)
  {
    for (std::size_t number = 0; number < this->Windows.Count; ++number)
    {
      // Little by little: a processor waits when it is to fetch too much at a time.
      if (!next.empty())
      {
        this->FrontValues.prefetch(next[0]);
        next = next.subspan(1);
      }
      RingWindows::Window& window = this->Windows.Windows[number];
      const TakenValue taken = this->FrontValues.take(window.item);
      if (taken.vertex != NoIndex)
      {
        this->Look.template note<Real>(taken, number, this->Windows);
      }
      else
      {
        window.size = 0;
      }
    }
    return next;
  }

  /** Does what was noted. */
  template <class Real>
  void finish()
  {
    if constexpr (Values::hasOthers)
    {
      for (std::size_t i = 0; i < this->Windows.OthersCount; ++i)
      {
        this->template prefetchOthers<Real>(this->Windows.OthersSeen[i]);
      }
      for (std::size_t i = 0; i < this->Windows.OthersCount; ++i)
      {
        this->template lookAtOthers<Real>(this->Windows.OthersSeen[i]);
      }
      for (std::size_t number = 0; number < this->Windows.Count; ++number)
      {
        this->Look.template judge<Real>(number, this->Windows);
      }
      // A value of one of several labels has to be found before it can be lowered. So along edges
      // goes only what is lower still than what came over edges.
      this->Ways.noteOver(this->Windows);
      this->goOver<Real>();
      this->closeWindows();
      this->Ways.noteAlong(this->Windows);
      this->goAlong();
    }
    else
    {
      this->Ways.noteAlong(this->Windows);
      this->goAlong();
      this->closeWindows();
      this->Ways.noteOver(this->Windows);
      this->goOver<Real>();
    }
    this->Windows.clear();
  }

  /** All of them are fetched before the first is looked up, as many may be far in memory. */
  template <class Real>
  void prefetchOthers(RingWindows::Others others) const
  {
    for (std::size_t lane = 0; lane < lanes<Real>; ++lane)
    {
      this->FrontValues.prefetchOther(this->Windows.Neighbours[others.first() + lane]);
    }
  }

  /** Looks up what a label has at neighbours whose best value is of another one. */
  template <class Real>
  void lookAtOthers(RingWindows::Others others)
  {
    const Slot first = others.first();
    const unsigned areOther = others.which();
    const Window& window = this->Windows.at(first);
    Indices<Real> neighbours;
    std::copy_n(&this->Windows.Neighbours[first], lanes<Real>, neighbours.begin());
    const Real best = load<Real>(&this->Windows.Values[first]);
    const KnownValues<Real> known =
      this->FrontValues.template others<Real>(neighbours, areOther, *window.label, best);
    const TestOf<Real> isOther = whereSet<Real>(areOther);
    store(select(isOther, known.values, best), &this->Windows.Values[first]);
    store(select(isOther, known.ceilings, best), &this->Windows.Ceilings[first]);
    this->Windows.isQueued[RingWindows::windowOf(first)] |=
      static_cast<Mask>((known.areQueued & areOther) << first % RingWindows::Size);
  }

  /** Of the first neighbours, where they come again as the last ones of their windows: what came to
   * either came to both. */
  void closeWindows()
  {
    for (std::size_t number = 0; number < RingWindows::Most; ++number)
    {
      double* const known = &this->ceilings()[number * RingWindows::Size];
      double& again = known[this->Windows.Windows[number].last];
      if constexpr (Values::hasOthers)
      {
        known[0] = std::min(known[0], again);
      }
      else
      {
        again = known[0];
      }
    }
  }

  void goAlong()
  {
    if constexpr (Values::hasOthers)
    {
      // Which of them lower a value is not to be guessed, so there is no branch on it.
      std::size_t count = this->NumberOfProposals;
      for (std::size_t i = 0; i < this->Ways.along().size(); ++i)
      {
        const Slot slot = this->Ways.along()[i];
        const double value = this->valueAlong(slot);
        this->Proposals[count] = { value, slot };
        count += value < this->ceilings()[slot] ? 1 : 0;
      }
      this->NumberOfProposals = count;
      this->propose();
    }
    else
    {
      for (std::size_t i = 0; i < this->Ways.along().size(); ++i)
      {
        this->goAlong(this->Ways.along()[i]);
      }
    }
  }

  /** What comes over edges next is to know of it. */
  void goAlong(Slot slot)
  {
    const double value = this->valueAlong(slot);
    if (value < this->ceilings()[slot])
    {
      const std::size_t window = RingWindows::windowOf(slot);
      const KnownValue held = this->FrontValues.propose(
        *this->Windows.Windows[window].label, this->Windows.Neighbours[slot], value);
      this->Windows.Values[slot] = held.value;
      this->Windows.isQueued[window] |=
        static_cast<Mask>(static_cast<unsigned>(held.isQueued) << slot % RingWindows::Size);
    }
  }

  double valueAlong(Slot slot) const
  {
    const double length = std::sqrt(this->Windows.SquaredLengths[slot]);
    return this->Windows.OwnValues[RingWindows::windowOf(slot)] + this->edgeCost(slot) * length;
  }

  /** Of one label's neighbours values and ceilings are the same. */
  auto& ceilings()
  {
    if constexpr (Values::hasOthers)
    {
      return this->Windows.Ceilings;
    }
    else
    {
      return this->Windows.Values;
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
    const std::size_t window = RingWindows::windowOf(slot);
    const unsigned isOpen = this->Windows.isOpen[window];
    const std::size_t again = this->Windows.Windows[window].last;
    const std::size_t i = slot % RingWindows::Size;
    const std::size_t base = slot - i;
    const std::size_t last = i > 0 ? i - 1 : again > 0 ? again - 1 : RingWindows::Size;
    const double after = isOpen >> i & 1 ? this->triangleCost(slot) : none;
    const double before =
      isOpen >> last & 1 ? this->triangleCost(static_cast<Slot>(base + last)) : none;
    return std::min(before, after);
  }

  /** Of the triangle that the neighbour in a slot opens. */
  double triangleCost(Slot slot) const
  {
    return this->TriangleCost.ofTriangle(this->Windows.at(slot).vertex,
      this->Windows.Neighbours[slot], this->Windows.Neighbours[slot + 1]);
  }

  template <class Real>
  void goOver()
  {
    this->goOver<Real, FrontShape::Round>();
    this->goOver<Real, FrontShape::Straight>();
    this->propose();
  }

  template <class Real, FrontShape Shape>
  void goOver()
  {
    auto& ways = this->Ways.over(Shape);
    ways.pad(lanes<Real>);
    std::size_t count = this->NumberOfProposals;
    for (std::size_t i = 0; i < ways.size(); i += lanes<Real>)
    {
      count = this->crossEdges<Real, Shape>(&ways[i], count);
    }
    this->NumberOfProposals = count;
  }

  /** As many at once as a Real has numbers. Puts what lowers a value behind the first @p count
   * proposals; returns how many there are then. */
  template <class Real, FrontShape Shape>
  std::size_t crossEdges(const WayOver* ways, std::size_t count)
  {
    const RingWindows& windows = this->Windows;
    const auto over = [&](std::size_t lane) { return ways[lane].over(); };
    const auto target = [&](std::size_t lane) { return ways[lane].target(); };
    const Vector3Of<Real> toOver{ gathered<Real>(windows.X, over), gathered<Real>(windows.Y, over),
      gathered<Real>(windows.Z, over) };
    const Vector3Of<Real> toTarget{ gathered<Real>(windows.X, target),
      gathered<Real>(windows.Y, target), gathered<Real>(windows.Z, target) };
    const Vector3Of<Real> normal = cross(toOver, toTarget);
    const FlatTriangleOf<Real> flat{ gathered<Real>(windows.SquaredLengths, over),
      dot(toOver, toTarget), dot(normal, normal) };
    const Real a = gathered<Real>(
      windows.OwnValues, [&](std::size_t lane) { return RingWindows::windowOf(over(lane)); });
    const Real b = gathered<Real>(windows.Values, over);
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
      const KnownValue held = this->FrontValues.propose(*this->Windows.at(proposal.target).label,
        this->Windows.Neighbours[proposal.target], proposal.value);
      if constexpr (Values::hasOthers)
      {
        this->Windows.Ceilings[proposal.target] = held.ceiling;
      }
    }
    this->NumberOfProposals = 0;
  }

  struct Proposal
  {
    double value;
    Slot target;
  };

  RingWindows Windows;
  RingLook<Cost, Values> Look;
  const TriangleMesh& Mesh;
  const Cost& TriangleCost;
  Values& FrontValues;
  RingWays Ways;
  /** What propose() proposes. */
  std::array<Proposal, 4 * RingWindows::Slots + lanes<Quad>> Proposals;
  std::size_t NumberOfProposals = 0;
  bool UsesQuads;
};

}

#endif

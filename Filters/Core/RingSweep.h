#ifndef geodesic_RingSweep_h
#define geodesic_RingSweep_h

#include "ClosedFans.h"
#include "EikonalUpdate.h"
#include "Lanes.h"
#include "RingWindows.h"
#include "SeedFront.h"
#include "TriangleMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

namespace geodesic
{

/** What a front knows of a vertex. */
struct KnownValue
{
  /** +infinity where the front has not been. */
  double value;
  /** Nothing at or above it is of interest; at most the value. */
  double ceiling;
  /** The vertex waits to be swept with this value. */
  bool isQueued;
};

/** What it knows of several; isQueued is in bits 0, 1 and so on. */
template <class Real>
struct KnownValues
{
  Real values;
  Real ceilings;
  unsigned isQueued;
};

/** As many vertices as a Real has numbers. */
template <class Real>
using Indices = std::array<Index, lanes<Real>>;

/** A value that was taken from the queue. */
struct TakenValue
{
  /** NoIndex where it is no longer of interest. */
  Index vertex;
  double value;
};

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
 * them: first the rings are looked at, several neighbours at a time, and what is found noted in the
 * bits of masks; then fronts go along edges; then over edges, several at a time; last the values
 * that were found are proposed.
 *
 * @tparam Cost    of a triangle: UnitCost or VertexCost
 * @tparam Values  of the front that is swept:
 *                 take(Index) -> TakenValue of what was in the queue, and makes its label the
 *                 current one; current(), shape(), setCurrent(Index) tell and change which that is;
 *                 look<Real>(const Indices<Real>&) -> KnownValues<Real> of its values;
 *                 propose(Index, double) -> KnownValue, queues the vertex with the value if that
 *                 counts, and returns what then holds
 */
template <class Cost, class Values>
class RingSweep
{
public:
  /** @param mayUseQuads whether four numbers are treated at once where the processor can; the
   * values are the same either way */
  RingSweep(const TriangleMesh& mesh, const ClosedFans& closed, const Cost& cost, Values& values,
    bool mayUseQuads = true)
    : Mesh(mesh)
    , Closed(closed)
    , TriangleCost(cost)
    , FrontValues(values)
    , UsesQuads(mayUseQuads && hasQuads())
  {
  }

  /** Sweeps over the triangles round the vertices of @p waiting, which were in the queue. */
  void sweep(std::span<const Index> waiting)
  {
    if (this->UsesQuads)
    {
      this->sweepByFour(waiting);
    }
    else
    {
      this->sweepByTwo(waiting);
    }
  }

private:
  using Mask = RingWindows::Mask;
  using Window = RingWindows::Window;
  static Mask bit(bool isSet, std::size_t i) { return static_cast<Mask>(isSet) << i; }

  // Flat: what is called from these and not inlined would not be compiled for AVX2.

  [[gnu::flatten, gnu::noinline, GEODESIC_QUADS]] void sweepByFour(std::span<const Index> waiting)
  {
    this->lookRound<Quad>(waiting, [&] { this->finishByFour(); });
  }
  [[gnu::flatten, gnu::noinline, GEODESIC_QUADS]] void finishByFour() { this->finish<Quad>(); }
  [[gnu::flatten, gnu::noinline]] void sweepByTwo(std::span<const Index> waiting)
  {
    this->lookRound<Pair>(waiting, [&] { this->finishByTwo(); });
  }
  [[gnu::flatten, gnu::noinline]] void finishByTwo() { this->finish<Pair>(); }

  /** @param doNoted  does what was noted in all windows */
  template <class Real, class DoNoted>
  void lookRound(std::span<const Index> waiting, DoNoted doNoted)
  {
    constexpr std::size_t step = RingWindows::Size - 1;
    for (Index next : waiting)
    {
      const TakenValue taken = this->FrontValues.take(next);
      const std::span<const RingEntry> ring =
        taken.vertex != NoIndex ? this->Mesh.ring(taken.vertex) : std::span<const RingEntry>();
      for (std::size_t first = 0; first + 1 < ring.size(); first += step)
      {
        if (this->Windows.Count == RingWindows::Most)
        {
          const Index current = this->FrontValues.current();
          doNoted();
          this->FrontValues.setCurrent(current);
        }
        this->look<Real>(taken, ring, first);
      }
    }
    doNoted();
  }

  /** Notes what there is to do in a window of a ring. */
  template <class Real>
  void look(const TakenValue& taken, std::span<const RingEntry> ring, std::size_t firstEntry)
  {
    const std::size_t number = this->Windows.Count++;
    const std::size_t base = number * RingWindows::Size;
    const RingEntry* const entries = &ring[firstEntry];
    const std::size_t size = std::min(RingWindows::Size, ring.size() - firstEntry);
    const Vector3* const positions = this->Mesh.positions().data();
    const Vector3& centre = positions[taken.vertex];
    const Vector3Of<Real> origin{ Real() + centre.x, Real() + centre.y, Real() + centre.z };
    Mask isQueued = 0;
    Mask along = 0;
    Mask first = 0;
    Mask second = 0;
    Index thinBits = 0;
    // Of the neighbours before those that are looked at.
    Index lastNeighbour = taken.vertex;
    Real lastValues = Real();
    Real lastCeilings = Real();
    Real lastSlacks = Real() + std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < size; i += lanes<Real>)
    {
      // After the last neighbour come any others, with which nothing is done.
      Indices<Real> neighbours;
      for (std::size_t lane = 0; lane < lanes<Real>; ++lane)
      {
        neighbours[lane] = entries[i + lane].neighbour();
        this->Windows.Neighbours[base + i + lane] = neighbours[lane];
        thinBits |= entries[i + lane].thinBit();
      }
      const KnownValues<Real> known = this->FrontValues.template look<Real>(neighbours);
      const Vector3Of<Real> offset =
        sideBySide<Real>([&](int lane) -> const Vector3& { return positions[neighbours[lane]]; }) -
        origin;
      const Real squares = dot(offset, offset);
      store(known.values, &this->Windows.Values[base + i]);
      store(known.ceilings, &this->Windows.Ceilings[base + i]);
      store(offset.x, &this->Windows.X[base + i]);
      store(offset.y, &this->Windows.Y[base + i]);
      store(offset.z, &this->Windows.Z[base + i]);
      store(squares, &this->Windows.SquaredLengths[base + i]);
      isQueued |= known.isQueued << i;

      const Real rises = largest(known.ceilings - taken.value, Real());
      along |= bitsOf(Cost::isUnit ? squares < rises * rises : rises > 0.0) << i;

      // The triangles that end here, each opened by the neighbour before.
      const Real slacks = slacksOf<Real>(entries + i);
      const Real costs = this->costsBefore<Real>(taken.vertex, lastNeighbour, neighbours);
      const Real bounds = taken.value + costs * shiftedIn(lastSlacks, slacks);
      const Real ceilings = 2.0 * known.ceilings;
      first |= bitsOf(bounds + known.values < shiftedIn(lastCeilings, ceilings)) << i;
      second |= bitsOf(bounds + shiftedIn(lastValues, known.values) < ceilings) << i;
      lastNeighbour = neighbours.back();
      lastValues = known.values;
      lastCeilings = ceilings;
      lastSlacks = slacks;
    }
    const std::size_t last = size - 1;
    const bool isRound = entries[0].neighbour() == entries[last].neighbour();
    const Mask triangles = bit(true, last) - 1;
    this->Windows.OwnValues[number] = taken.value;
    Window& window = this->Windows.Windows[number];
    window.vertex = taken.vertex;
    window.label = this->FrontValues.current();
    window.shape = this->FrontValues.shape();
    window.last = isRound ? static_cast<Mask>(last) : 0;
    window.isQueued = isQueued;
    window.isOpen = this->openTriangles(taken.vertex, firstEntry, last) & triangles;
    window.isThin = thinBits != 0 ? thinTriangles({ entries, size }) : 0;
    window.along = along & (isRound ? triangles : triangles << 1 | 1);
    window.first = first >> 1;
    window.second = second >> 1;
  }

  /** Those of as many entries as a Real has numbers. */
  template <class Real>
  GEODESIC_INLINED static Real slacksOf(const RingEntry* entries)
  {
    if constexpr (lanes<Real> == 2)
    {
      return Real{ entries[0].slack(), entries[1].slack() };
    }
    else
    {
      using Floats = float __attribute__((vector_size(16)));
      static_assert(sizeof(Floats) == 2 * sizeof(RingEntry));
      Floats first;
      Floats second;
      std::memcpy(&first, entries, sizeof first);
      std::memcpy(&second, entries + 2, sizeof second);
      return __builtin_convertvector(__builtin_shufflevector(first, second, 1, 3, 5, 7), Real);
    }
  }

  /** Of the triangles of a vertex between each neighbour and the one before. */
  template <class Real>
  GEODESIC_INLINED Real costsBefore(Index vertex, Index last, const Indices<Real>& neighbours) const
  {
    return lanesOf<Real>(
      [&](std::size_t lane)
      {
        return this->TriangleCost.ofTriangle(
          vertex, lane > 0 ? neighbours[lane - 1] : last, neighbours[lane]);
      });
  }

  static Mask thinTriangles(std::span<const RingEntry> ring)
  {
    Mask isThin = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      isThin |= bit(ring[i].isThin(), i);
    }
    return isThin;
  }

  /** Those that may be crossed, @p count of them; or just all, where nothing is closed. */
  Mask openTriangles(Index vertex, std::size_t firstEntry, std::size_t count) const
  {
    if (Cost::isUnit && this->Closed.isEmpty())
    {
      return ~Mask(0);
    }
    Mask isOpen = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      isOpen |= bit(this->Closed.isOpen(vertex, firstEntry + i), i);
    }
    return isOpen;
  }

  template <class Real>
  static void store(const Real& numbers, double* to)
  {
    std::memcpy(to, &numbers, sizeof numbers);
  }

  /** Does what was noted. */
  template <class Real>
  void finish()
  {
    this->Along.clear();
    for (std::size_t number = 0; number < this->Windows.Count; ++number)
    {
      this->noteWaysAlong(number);
    }
    for (std::size_t i = 0; i < this->Along.size(); ++i)
    {
      this->goAlong(this->Along[i]);
    }
    this->Over[0].clear();
    this->Over[1].clear();
    for (std::size_t number = 0; number < this->Windows.Count; ++number)
    {
      this->noteWaysOver(number);
    }
    this->goOver<Real, FrontShape::Round>();
    this->goOver<Real, FrontShape::Straight>();
    this->propose();
    this->Windows.Count = 0;
  }

  void noteWaysAlong(std::size_t number)
  {
    const Window& window = this->Windows.Windows[number];
    const Mask beforeFirst = window.last > 0 ? window.isOpen >> (window.last - 1) : 0;
    const Mask isOpenEdge = window.isOpen | window.isOpen << 1 | beforeFirst;
    this->Along.add(window.along & isOpenEdge,
      [&](int slot) { return static_cast<Slot>(number * RingWindows::Size + slot); });
  }

  void goAlong(Slot slot)
  {
    Window& window = this->Windows.at(slot);
    const double length = std::sqrt(this->Windows.SquaredLengths[slot]);
    const double value =
      this->Windows.OwnValues[RingWindows::windowOf(slot)] + this->edgeCost(slot) * length;
    if (value < this->Windows.Ceilings[slot])
    {
      this->FrontValues.setCurrent(window.label);
      const KnownValue held = this->FrontValues.propose(this->Windows.Neighbours[slot], value);
      this->Windows.Values[slot] = held.value;
      this->Windows.Ceilings[slot] = held.ceiling;
      window.isQueued |= bit(held.isQueued, slot % RingWindows::Size);
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
    const Window& window = this->Windows.at(slot);
    const std::size_t i = slot % RingWindows::Size;
    const std::size_t base = slot - i;
    const std::size_t last = i > 0 ? i - 1 : window.last > 0 ? window.last - 1 : RingWindows::Size;
    const double after = window.isOpen >> i & 1 ? this->triangleCost(slot) : none;
    const double before =
      window.isOpen >> last & 1 ? this->triangleCost(static_cast<Slot>(base + last)) : none;
    return std::min(before, after);
  }

  /** Of the triangle that the neighbour in a slot opens. */
  double triangleCost(Slot slot) const
  {
    return this->TriangleCost.ofTriangle(this->Windows.at(slot).vertex,
      this->Windows.Neighbours[slot], this->Windows.Neighbours[slot + 1]);
  }

  void noteWaysOver(std::size_t number)
  {
    const Window& window = this->Windows.Windows[number];
    const std::size_t base = number * RingWindows::Size;
    // What holds for the first neighbour holds for the last, where that is the same.
    this->Windows.Values[base + window.last] = this->Windows.Values[base];
    this->Windows.Ceilings[base + window.last] = this->Windows.Ceilings[base];
    const auto rounded = [&](Mask mask) { return mask | (mask & 1) << window.last; };
    const Mask isQueued = rounded(window.isQueued);
    const Mask along = rounded(window.along);
    // The edge to a vertex that waits is crossed from there; not so in a thin triangle, where what
    // lies behind the edge may come before it.
    const Mask first = (window.first | (window.isThin & along >> 1)) & window.isOpen &
      (window.isThin | ~(isQueued >> 1));
    const Mask second =
      (window.second | (window.isThin & along)) & window.isOpen & (window.isThin | ~isQueued);
    this->Over[static_cast<std::size_t>(window.shape)].add(first | second << RingWindows::Size,
      [&](int way) { return WayOver(base, base) + waysOver[way]; });
  }

  template <class Real, FrontShape Shape>
  void goOver()
  {
    auto& ways = this->Over[static_cast<std::size_t>(Shape)];
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
    const unsigned isLower = bitsOf(values < gathered<Real>(windows.Ceilings, target));
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
      this->FrontValues.setCurrent(this->Windows.at(proposal.target).label);
      this->FrontValues.propose(this->Windows.Neighbours[proposal.target], proposal.value);
    }
    this->NumberOfProposals = 0;
  }

  struct Proposal
  {
    double value;
    Slot target;
  };

  RingWindows Windows;
  const TriangleMesh& Mesh;
  const ClosedFans& Closed;
  const Cost& TriangleCost;
  Values& FrontValues;
  BitList<Slot, RingWindows::Slots, 3> Along;
  /** By the front's shape. */
  std::array<BitList<WayOver, 2 * RingWindows::Slots, 4>, 2> Over;
  /** What propose() proposes. */
  std::array<Proposal, 4 * RingWindows::Slots + lanes<Quad>> Proposals;
  std::size_t NumberOfProposals = 0;
  bool UsesQuads;
};

}

#endif

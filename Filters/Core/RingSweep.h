#ifndef geodesic_RingSweep_h
#define geodesic_RingSweep_h

#include "ClosedFans.h"
#include "EikonalUpdate.h"
#include "Pair.h"
#include "SeedFront.h"
#include "TriangleMesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

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

/** What it knows of two; isQueued is in bits 0 and 1. */
struct KnownPair
{
  Pair values;
  Pair ceilings;
  unsigned isQueued;
};

/** The ways of a front of a shape over the inside of two edges, at costs @p w. */
template <FrontShape Shape>
inline Pair crossings(const FlatTriangleOf<Pair>& t, Pair a, Pair b, Pair w)
{
  return Shape == FrontShape::Round ? w * pointSourceCrossing(t, a / w, b / w)
                                    : straightFrontCrossing(t, a, b, w);
}

/**
 * Updates the neighbours of a vertex over the edges round it, after its own value fell.
 *
 * An update is the least of three ways: along either edge to the neighbour, and over the inside of
 * the edge opposite to it. Along an edge the front comes when the edge's other end is swept, over
 * an edge when the last of its ends is. Few triangles of a march need their shape: most corners can
 * gain nothing by RingEntry::slack.
 *
 * What is worth a closer look differs from vertex to vertex, and a processor that guesses wrong
 * waits. So the ring is looked at without branches first, in windows and two neighbours at a time,
 * and what is found noted in the bits of a mask. Crossings are computed two at a time as well, and
 * their values only proposed by settle(): so the roots of some sweeps are taken while others go on.
 *
 * @tparam Cost    of a triangle: UnitCost or VertexCost
 * @tparam Values  of the neighbours, for the front that is swept:
 *                 current(), setCurrent(Index) tell and change which label that is;
 *                 look(Index, Index) -> KnownPair;
 *                 propose(Index, double) -> KnownValue, queues the vertex with the value if that
 *                 counts, and returns what then holds
 */
template <FrontShape Shape, class Cost, class Values>
class RingSweep
{
public:
  RingSweep(const TriangleMesh& mesh, const ClosedFans& closed, const Cost& cost, Values& values)
    : Mesh(mesh)
    , Closed(closed)
    , TriangleCost(cost)
    , FrontValues(values)
  {
  }

  // Flat: calls within these two would take a tenth more, and so would further copies of them.

  /** Sweeps over the triangles round @p vertex, whose value is now @p value. To be followed by
   * settle(), after a few sweeps. */
  [[gnu::flatten, gnu::noinline]] void sweep(Index vertex, double value)
  {
    const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
    for (std::size_t first = 0; first + 1 < ring.size(); first += WindowSize - 1)
    {
      const std::size_t size = std::min(WindowSize, ring.size() - first);
      this->sweepWindow(vertex, value, ring.subspan(first, size), first);
    }
  }

  /** Proposes what the sweeps since the last call found over edges. */
  [[gnu::flatten, gnu::noinline]] void settle()
  {
    const Index current = this->FrontValues.current();
    for (std::size_t i = 0; i < this->NumberOfProposals; ++i)
    {
      const Proposal& proposal = this->Proposals[i];
      this->FrontValues.setCurrent(proposal.label);
      this->FrontValues.propose(proposal.vertex, proposal.value);
    }
    this->FrontValues.setCurrent(current);
    this->NumberOfProposals = 0;
  }

private:
  static constexpr std::size_t WindowSize = 16;
  /** One bit a neighbour, or the triangle that it opens; or one for each of two ways. */
  using Mask = std::uint32_t;
  static Mask bit(bool isSet, std::size_t i) { return static_cast<Mask>(isSet) << i; }

  /** A mask in the making, two bits after two. */
  class GrowingMask
  {
  public:
    void add(Mask bits) { this->Bits = this->Bits >> 2 | bits << (Digits - 2); }
    /** The bits that were added, @p size of them. */
    Mask of(std::size_t size) const { return this->Bits >> (Digits - size) % Digits; }

  private:
    static constexpr std::size_t Digits = std::numeric_limits<Mask>::digits;
    Mask Bits = 0;
  };

  /** A vertex and its neighbours in a window of its ring. */
  struct Window
  {
    Index vertex;
    double value;
    Vector3 centre;
    std::span<const RingEntry> ring;
    /** Of the neighbours without the last, where that is the first one again. */
    std::size_t size;
    bool isRound() const { return this->size < this->ring.size(); }
    /** With what holds for the first neighbour also for the last, where that is the same. */
    Mask rounded(Mask mask) const
    {
      return this->isRound() ? mask | bit((mask & 1) != 0, this->size) : mask;
    }
    alignas(Pair) std::array<double, WindowSize> values;
    alignas(Pair) std::array<double, WindowSize> ceilings;
    alignas(Pair) std::array<double, WindowSize> squaredLengths;
    /** Waits to be swept with its value. */
    Mask isQueued;
  };

  /** Who may gain. */
  struct Gains
  {
    /** A neighbour, along the edge to it. */
    Mask along;
    /** The neighbour that opens a triangle, or the one after it, over the edge to the other. */
    Mask first;
    Mask second;
    /** The triangles that are thin. */
    Mask isThin;
  };

  void sweepWindow(Index vertex, double value, std::span<const RingEntry> ring, std::size_t first)
  {
    Window window;
    window.vertex = vertex;
    window.value = value;
    window.centre = this->Mesh.position(vertex);
    window.ring = ring;
    const bool isRound = ring.front().neighbour() == ring.back().neighbour();
    window.size = ring.size() - (isRound ? 1 : 0);
    Gains gains = this->look(window);

    const Mask isOpen = this->openTriangles(vertex, ring, first);
    Mask isOpenEdge = isOpen | isOpen << 1;
    isOpenEdge |= isRound ? isOpenEdge >> window.size : 0;
    for (Mask along = gains.along & isOpenEdge; along != 0; along &= along - 1)
    {
      this->goAlong(window, std::countr_zero(along), isOpen);
    }
    if (isRound)
    {
      window.values[window.size] = window.values[0];
      window.ceilings[window.size] = window.ceilings[0];
      window.squaredLengths[window.size] = window.squaredLengths[0];
    }
    gains.along = window.rounded(gains.along);
    window.isQueued = window.rounded(window.isQueued);

    // The edge to a vertex that waits is crossed from there; not so in a thin triangle, where what
    // lies behind the edge may come before it.
    gains.first |= gains.isThin & gains.along >> 1;
    gains.second |= gains.isThin & gains.along;
    gains.first &= isOpen & (gains.isThin | ~(window.isQueued >> 1));
    gains.second &= isOpen & (gains.isThin | ~window.isQueued);
    for (Mask ways = gains.first | gains.second << WindowSize; ways != 0;)
    {
      const Way a(ways);
      ways &= ways - 1;
      const Way b = ways != 0 ? Way(ways) : a;
      ways &= ways - 1;
      this->crossBoth(window, a, b);
    }
  }

  Gains look(Window& window) const
  {
    GrowingMask isQueued;
    GrowingMask along;
    GrowingMask first;
    GrowingMask second;
    bool hasThin = false;
    // Of the neighbour before the two that are looked at.
    Index lastNeighbour = window.vertex;
    double lastValue = 0.0;
    double lastCeiling = 0.0;
    float lastSlack = std::numeric_limits<float>::infinity();
    const Vector3Of<Pair> centre = pairOf(window.centre, window.centre);
    const double value = window.value;
    const std::span<const RingEntry> ring = window.ring;
    const std::size_t size = window.size;
    for (std::size_t i = 0; i < size; i += 2)
    {
      // After the last one comes any other, with which nothing is done.
      const RingEntry a = ring.data()[i];
      const RingEntry b = ring.data()[i + 1];
      const KnownPair known = this->FrontValues.look(a.neighbour(), b.neighbour());
      const Vector3Of<Pair> offset =
        pairOf(this->Mesh.position(a.neighbour()), this->Mesh.position(b.neighbour())) - centre;
      const Pair squares = dot(offset, offset);
      store(known.values, window.values, i);
      store(known.ceilings, window.ceilings, i);
      store(squares, window.squaredLengths, i);
      isQueued.add(known.isQueued);
      hasThin |= a.isThin() | b.isThin();

      const Pair rises = largest(known.ceilings - value, Pair());
      along.add(bitsOf(Cost::isUnit ? squares < rises * rises : rises > 0.0));

      // The triangles that end here: opened by the neighbour before, and by a.
      const Pair costs{ this->TriangleCost.ofTriangle(window.vertex, lastNeighbour, a.neighbour()),
        this->TriangleCost.ofTriangle(window.vertex, a.neighbour(), b.neighbour()) };
      const Pair bounds = value + costs * Pair{ lastSlack, a.slack() };
      first.add(bitsOf(bounds + known.values < 2.0 * Pair{ lastCeiling, known.ceilings[0] }));
      second.add(bitsOf(bounds + Pair{ lastValue, known.values[0] } < 2.0 * known.ceilings));
      lastNeighbour = b.neighbour();
      lastValue = known.values[1];
      lastCeiling = known.ceilings[1];
      lastSlack = b.slack();
    }
    std::size_t bits = size + size % 2;
    if (window.isRound() && bits == size)
    {
      // The triangle from the last neighbour to the first, which is faster looked up again than
      // kept.
      const Index next = ring[0].neighbour();
      const KnownPair known = this->FrontValues.look(next, next);
      const Pair cost = Pair() + this->TriangleCost.ofTriangle(window.vertex, lastNeighbour, next);
      const Mask gains = bitsOf(value + cost * lastSlack + Pair{ known.values[0], lastValue } <
        2.0 * Pair{ lastCeiling, known.ceilings[0] });
      isQueued.add(0);
      along.add(0);
      first.add(gains & 1);
      second.add(gains >> 1);
      bits += 2;
    }
    window.isQueued = isQueued.of(bits);
    return { along.of(bits) & (bit(true, size) - 1), first.of(bits) >> 1, second.of(bits) >> 1,
      hasThin ? thinTriangles(ring) : 0 };
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

  /** Those that may be crossed, of those that are whole in the window; or just all, where nothing
   * is closed. */
  Mask openTriangles(Index vertex, std::span<const RingEntry> ring, std::size_t first) const
  {
    if (Cost::isUnit && this->Closed.isEmpty())
    {
      return ~Mask(0);
    }
    Mask isOpen = 0;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    {
      isOpen |= bit(this->Closed.isOpen(vertex, first + i), i);
    }
    return isOpen;
  }

  void goAlong(Window& window, int target, Mask isOpen)
  {
    const double length = std::sqrt(window.squaredLengths[target]);
    const double value = window.value + this->edgeCost(window, isOpen, target) * length;
    if (value < window.ceilings[target])
    {
      const KnownValue held = this->FrontValues.propose(window.ring[target].neighbour(), value);
      window.values[target] = held.value;
      window.ceilings[target] = held.ceiling;
      window.isQueued |= bit(held.isQueued, target);
    }
  }

  static void store(Pair two, std::array<double, WindowSize>& numbers, std::size_t i)
  {
    std::memcpy(&numbers[i], &two, sizeof two);
  }

  double triangleCost(const Window& window, std::size_t i) const
  {
    return this->TriangleCost.ofTriangle(
      window.vertex, window.ring[i].neighbour(), window.ring[i + 1].neighbour());
  }

  /** That of the cheaper open triangle beside the edge to neighbour @p i. */
  double edgeCost(const Window& window, Mask isOpen, int i) const
  {
    if constexpr (Cost::isUnit)
    {
      return 1.0;
    }
    constexpr double none = std::numeric_limits<double>::infinity();
    const double after = isOpen >> i & 1 ? this->triangleCost(window, i) : none;
    const std::size_t last = i > 0 ? i - 1 : window.isRound() ? window.size - 1 : WindowSize;
    const double before = isOpen >> last & 1 ? this->triangleCost(window, last) : none;
    return std::min(before, after);
  }

  /** From the vertex and a neighbour over the edge between to the triangle's third corner. */
  struct Way
  {
    /** The one of the lowest bit in Gains::first and, WindowSize higher, Gains::second. */
    explicit Way(Mask ways)
    {
      const int number = std::countr_zero(ways);
      const int isSecond = number / static_cast<int>(WindowSize);
      this->triangle = number % static_cast<int>(WindowSize);
      this->over = this->triangle + 1 - isSecond;
      this->target = this->triangle + isSecond;
    }
    int triangle;
    int over;
    int target;
  };

  void crossBoth(Window& window, Way a, Way b)
  {
    const Vector3Of<Pair> toOver =
      this->offsets(window, window.ring[a.over].neighbour(), window.ring[b.over].neighbour());
    const Vector3Of<Pair> toTarget =
      this->offsets(window, window.ring[a.target].neighbour(), window.ring[b.target].neighbour());
    const Pair length = root(Pair{ window.squaredLengths[a.over], window.squaredLengths[b.over] });
    const Pair perLength = 1.0 / length;
    const FlatTriangleOf<Pair> flat{ length, dot(toOver, toTarget) * perLength,
      norm(cross(toOver, toTarget)) * perLength };
    const Pair values = crossings<Shape>(flat, Pair{ window.value, window.value },
      Pair{ window.values[a.over], window.values[b.over] },
      Pair{ this->triangleCost(window, a.triangle), this->triangleCost(window, b.triangle) });
    if (this->NumberOfProposals + 2 > this->Proposals.size())
    {
      this->settle();
    }
    this->noteProposal(window, a.target, values[0]);
    this->noteProposal(window, b.target, values[1]);
  }

  void noteProposal(const Window& window, int target, double value)
  {
    this->Proposals[this->NumberOfProposals] = { window.ring[target].neighbour(),
      this->FrontValues.current(), value };
    this->NumberOfProposals += value < window.ceilings[target] ? 1 : 0;
  }

  /** From the vertex of a window to two others. */
  Vector3Of<Pair> offsets(const Window& window, Index a, Index b) const
  {
    return pairOf(this->Mesh.position(a), this->Mesh.position(b)) -
      pairOf(window.centre, window.centre);
  }

  struct Proposal
  {
    Index vertex;
    Index label;
    double value;
  };

  const TriangleMesh& Mesh;
  const ClosedFans& Closed;
  const Cost& TriangleCost;
  Values& FrontValues;
  /** What settle() proposes. */
  std::array<Proposal, 32> Proposals;
  std::size_t NumberOfProposals = 0;
};

}

#endif

#ifndef geodesic_RingLook_h
#define geodesic_RingLook_h

#include "ClosedFans.h"
#include "KnownValues.h"
#include "Lanes.h"
#include "RingWindows.h"
#include "TriangleMesh.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <span>

namespace geodesic
{

/**
 * Looks at the rings of vertices and notes what there is to do, several neighbours at a time and
 * without a branch on what is found, so that the processor can go ahead to the next ring while it
 * waits for memory: a part of RingSweep, which see also for Cost and Values.
 */
template <class Cost, class Values>
class RingLook
{
public:
  RingLook(
    const TriangleMesh& mesh, const ClosedFans& closed, const Cost& cost, const Values& values)
    : Mesh(mesh)
    , Closed(closed)
    , TriangleCost(cost)
    , FrontValues(values)
  {
  }

  /** Looks at a window of the ring of what was taken, from @p firstEntry on, and adds it to
   * @p windows, which are not full. */
  template <class Real>
  void note(const TakenValue& taken, std::span<const RingEntry> ring, std::size_t firstEntry,
    RingWindows& windows) const
  {
    const std::size_t number = windows.Count++;
    const std::size_t base = number * RingWindows::Size;
    const RingEntry* const entries = &ring[firstEntry];
    const std::size_t size = std::min(RingWindows::Size, ring.size() - firstEntry);
    const Vector3* const positions = this->Mesh.positions().data();
    const Vector3& centre = positions[taken.vertex];
    const Vector3Of<Real> origin{ Real() + centre.x, Real() + centre.y, Real() + centre.z };
    const typename Values::Sight sight = this->FrontValues.sight(*taken.label);
    std::size_t others = windows.OthersCount;
    Mask isQueued = 0;
    for (std::size_t i = 0; i < size; i += lanes<Real>)
    {
      // After the last neighbour come any others, with which nothing is done.
      Indices<Real> neighbours;
      for (std::size_t lane = 0; lane < lanes<Real>; ++lane)
      {
        neighbours[lane] = entries[i + lane].neighbour();
        windows.Neighbours[base + i + lane] = neighbours[lane];
      }
      const SeenValues<Real> seen = sight.template look<Real>(neighbours);
      const Vector3Of<Real> offset =
        sideBySide<Real>([&](int lane) -> const Vector3& { return positions[neighbours[lane]]; }) -
        origin;
      store(seen.values, &windows.Values[base + i]);
      store(seen.values, &windows.Ceilings[base + i]);
      store(offset.x, &windows.X[base + i]);
      store(offset.y, &windows.Y[base + i]);
      store(offset.z, &windows.Z[base + i]);
      store(dot(offset, offset), &windows.SquaredLengths[base + i]);
      isQueued |= seen.areQueued << i;
      if constexpr (Values::hasOthers)
      {
        windows.OthersSeen[others] = { base + i, seen.areOther };
        others += seen.areOther != 0;
      }
    }
    windows.OthersCount = others;
    windows.OwnValues[number] = taken.value;
    RingWindows::Window& window = windows.Windows[number];
    window.vertex = taken.vertex;
    window.label = taken.label;
    window.firstEntry = static_cast<Index>(firstEntry);
    window.size = static_cast<Index>(size);
    window.isQueued = isQueued;
  }

  /** Notes in the masks of a window what is worth a closer look. */
  template <class Real>
  void judge(std::size_t number, RingWindows& windows) const
  {
    RingWindows::Window& window = windows.Windows[number];
    const std::size_t base = number * RingWindows::Size;
    const RingEntry* const entries = &this->Mesh.ring(window.vertex)[window.firstEntry];
    const double own = windows.OwnValues[number];
    Mask along = 0;
    Mask first = 0;
    Mask second = 0;
    Mask isThin = 0;
    // Of the neighbours before those that are looked at.
    Index lastNeighbour = window.vertex;
    Real lastValues = Real();
    Real lastCeilings = Real();
    Real lastSlacks = Real() + std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < window.size; i += lanes<Real>)
    {
      Indices<Real> neighbours;
      for (std::size_t lane = 0; lane < lanes<Real>; ++lane)
      {
        neighbours[lane] = windows.Neighbours[base + i + lane];
      }
      const Real values = geodesic::load<Real>(&windows.Values[base + i]);
      const Real held = geodesic::load<Real>(&windows.Ceilings[base + i]);
      const Real squares = geodesic::load<Real>(&windows.SquaredLengths[base + i]);
      const Real rises = largest(held - own, Real());
      along |= bitsOf(Cost::isUnit ? squares < rises * rises : rises > 0.0) << i;

      // The triangles that end here, each opened by the neighbour before.
      const Real slacks = slacksOf<Real>(entries + i);
      const Real costs = this->costsBefore<Real>(window.vertex, lastNeighbour, neighbours);
      const Real bounds = own + costs * shiftedIn(lastSlacks, slacks);
      const Real ceilings = 2.0 * held;
      first |= bitsOf(bounds + values < shiftedIn(lastCeilings, ceilings)) << i;
      second |= bitsOf(bounds + shiftedIn(lastValues, values) < ceilings) << i;
      isThin |= thinOf<Real>(entries + i) << i;
      lastNeighbour = neighbours.back();
      lastValues = values;
      lastCeilings = ceilings;
      lastSlacks = slacks;
    }
    const std::size_t last = window.size - 1;
    const bool isRound = windows.Neighbours[base] == windows.Neighbours[base + last];
    const Mask triangles = (Mask(1) << window.size >> 1) - 1;
    window.last = isRound ? static_cast<Mask>(last) : 0;
    window.isOpen = this->openTriangles(window.vertex, window.firstEntry, last) & triangles;
    window.isThin = isThin & triangles;
    window.along = along & (isRound ? triangles : triangles << 1 | 1);
    window.first = first >> 1;
    window.second = second >> 1;
  }

private:
  using Mask = RingWindows::Mask;

  // Of as many entries as a Real has numbers:

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
      return __builtin_convertvector(
        __builtin_shufflevector(load<Floats>(entries), load<Floats>(entries + 2), 1, 3, 5, 7),
        Real);
    }
  }

  /** Which are thin. */
  template <class Real>
  GEODESIC_INLINED static Mask thinOf(const RingEntry* entries)
  {
    if constexpr (lanes<Real> == 2)
    {
      return Mask(entries[0].isThin()) | Mask(entries[1].isThin()) << 1;
    }
    else
    {
      using Bits = BitsOf<Real>;
      const Bits bits =
        __builtin_shufflevector(load<Bits>(entries), load<Bits>(entries + 2), 0, 2, 4, 6);
      return highestBits<Real>(bits << (31 - RingEntry::ThinBitPlace));
    }
  }

  /** A vector that takes the room of two entries. */
  template <class Vector>
  GEODESIC_INLINED static Vector load(const RingEntry* entries)
  {
    static_assert(sizeof(Vector) == 2 * sizeof(RingEntry));
    Vector vector;
    std::memcpy(&vector, entries, sizeof vector);
    return vector;
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
      isOpen |= Mask(this->Closed.isOpen(vertex, firstEntry + i)) << i;
    }
    return isOpen;
  }

  const TriangleMesh& Mesh;
  const ClosedFans& Closed;
  const Cost& TriangleCost;
  const Values& FrontValues;
};

}

#endif

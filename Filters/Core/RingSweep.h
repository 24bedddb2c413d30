#ifndef geodesic_RingSweep_h
#define geodesic_RingSweep_h

#include "ClosedFans.h"
#include "EikonalUpdate.h"
#include "SeedFront.h"
#include "TriangleMesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace geodesic
{

/** What a front knows of a vertex. */
struct FrontValue
{
  /** +infinity where the front has not been. */
  double value;
  /** Nothing at or above it is of interest; at most the value. */
  double ceiling;
  /** The vertex waits to be swept with this value. */
  bool isQueued;
};

/** The way of a front of a shape over the inside of an edge, at cost @p w. */
template <FrontShape Shape>
inline double crossing(const FlatTriangle& t, double a, double b, double w)
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
 * waits. So the ring is looked at without branches first, in windows, and what is found noted in
 * the bits of a mask.
 *
 * @tparam Cost    of a triangle: UnitCost or VertexCost
 * @tparam Values  of the neighbours, for the front that is swept:
 *                 look(Index) -> FrontValue;
 *                 propose(Index, double) -> FrontValue, queues the vertex with the value if that
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

  /** Sweeps over the triangles round @p vertex, whose value is now @p value. */
  void sweep(Index vertex, double value)
  {
    const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
    for (std::size_t first = 0; first + 1 < ring.size(); first += WindowSize - 1)
    {
      const std::size_t size = std::min(WindowSize, ring.size() - first);
      this->sweepWindow(vertex, value, ring.subspan(first, size), first);
    }
  }

private:
  static constexpr std::size_t WindowSize = 16;
  /** One bit a neighbour, or the triangle that it opens; or one for each of two ways. */
  using Mask = std::uint32_t;
  static Mask bit(bool isSet, std::size_t i) { return static_cast<Mask>(isSet) << i; }

  /** Whether the height over an edge, 2 h - c of which is given, is less than a quarter of it. */
  static bool isThinAt(double slack, double squaredLength)
  {
    return slack * std::abs(slack) < -0.25 * squaredLength;
  }

  /** The neighbours in a window of a ring. */
  struct Window
  {
    std::array<Index, WindowSize> vertices;
    std::array<double, WindowSize> values;
    std::array<double, WindowSize> ceilings;
    std::array<double, WindowSize> squaredLengths;
    /** Waits to be swept with its value. */
    Mask isQueued = 0;
  };

  void sweepWindow(Index vertex, double value, std::span<const RingEntry> ring, std::size_t first)
  {
    const Vector3 centre = this->Mesh.position(vertex);
    Window window;
    Mask isOpen = 0;
    Mask isHigher = 0;
    Mask isThin = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Index neighbour = ring[i].neighbour();
      const FrontValue known = this->FrontValues.look(neighbour);
      const Vector3 offset = this->Mesh.position(neighbour) - centre;
      window.vertices[i] = neighbour;
      window.values[i] = known.value;
      window.ceilings[i] = known.ceiling;
      window.squaredLengths[i] = dot(offset, offset);
      window.isQueued |= bit(known.isQueued, i);
      isHigher |= bit(known.ceiling > value, i);
      isOpen |= bit(ring[i].opensTriangle(), i);
      isThin |= bit(isThinAt(ring[i].slack(), window.squaredLengths[i]), i);
    }
    isOpen &= bit(true, ring.size() - 1) - 1;
    for (std::size_t i = 0; !this->Closed.isEmpty() && i < ring.size(); ++i)
    {
      isOpen &= ~bit(!this->Closed.isOpen(vertex, first + i), i);
    }

    Mask gainsAlong = isHigher & (isOpen | isOpen << 1);
    if constexpr (Cost::isUnit)
    {
      Mask isShort = 0;
      for (std::size_t i = 0; i < ring.size(); ++i)
      {
        const double rise = window.ceilings[i] - value;
        isShort |= bit(window.squaredLengths[i] < rise * rise, i);
      }
      gainsAlong &= isShort;
    }
    for (; gainsAlong != 0; gainsAlong &= gainsAlong - 1)
    {
      const int i = std::countr_zero(gainsAlong);
      const double w = this->edgeCost(vertex, window, isOpen, i);
      this->propose(window, i, value + w * std::sqrt(window.squaredLengths[i]));
    }

    Mask gainsFirst = 0;
    Mask gainsSecond = 0;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    {
      const double bound = value + this->triangleCost(vertex, window, i) * ring[i].slack();
      gainsFirst |= bit(bound + window.values[i + 1] < 2.0 * window.ceilings[i], i);
      gainsSecond |= bit(bound + window.values[i] < 2.0 * window.ceilings[i + 1], i);
    }
    // The edge to a vertex that waits is crossed from there; not so in a thin triangle, where what
    // lies behind the edge may come before it.
    gainsFirst &= isOpen & (isThin | ~(window.isQueued >> 1));
    gainsSecond &= isOpen & (isThin | ~window.isQueued);
    for (Mask gains = gainsFirst | gainsSecond << WindowSize; gains != 0; gains &= gains - 1)
    {
      const int number = std::countr_zero(gains);
      const int i = number % WindowSize;
      const int isSecond = number / WindowSize;
      const double w = this->triangleCost(vertex, window, i);
      this->cross(window, centre, value, i + 1 - isSecond, i + isSecond, w);
    }
  }

  double triangleCost(Index vertex, const Window& window, std::size_t i) const
  {
    return this->TriangleCost.ofTriangle(vertex, window.vertices[i], window.vertices[i + 1]);
  }

  /** That of the cheaper open triangle beside the edge to neighbour @p i. */
  double edgeCost(Index vertex, const Window& window, Mask isOpen, int i) const
  {
    constexpr double none = std::numeric_limits<double>::infinity();
    const double after = isOpen >> i & 1 ? this->triangleCost(vertex, window, i) : none;
    const double before = isOpen << 1 >> i & 1 ? this->triangleCost(vertex, window, i - 1) : none;
    return Cost::isUnit ? 1.0 : std::min(before, after);
  }

  /** From the vertex at @p centre and neighbour @p over, over the edge between, to @p target. */
  void cross(Window& window, const Vector3& centre, double value, int over, int target, double w)
  {
    const Vector3 toOver = this->Mesh.position(window.vertices[over]) - centre;
    const Vector3 toTarget = this->Mesh.position(window.vertices[target]) - centre;
    const double length = std::sqrt(window.squaredLengths[over]);
    const double area = norm(geodesic::cross(toOver, toTarget));
    const double perLength = 1.0 / length;
    const FlatTriangle flat{ length, dot(toOver, toTarget) * perLength, area * perLength };
    this->propose(window, target, crossing<Shape>(flat, value, window.values[over], w));
  }

  void propose(Window& window, int target, double value)
  {
    if (value < window.ceilings[target])
    {
      const FrontValue held = this->FrontValues.propose(window.vertices[target], value);
      window.values[target] = held.value;
      window.ceilings[target] = held.ceiling;
      window.isQueued |= bit(held.isQueued, target);
    }
  }

  const TriangleMesh& Mesh;
  const ClosedFans& Closed;
  const Cost& TriangleCost;
  Values& FrontValues;
};

}

#endif

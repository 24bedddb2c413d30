// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_UpdateBounds_h
#define geodesic_UpdateBounds_h

#include "base/BulkVector.h"
#include "base/Platform.h"
#include "base/ThreadTeam.h"
#include "mesh/TriangleMesh.h"

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace geodesic
{

class Partition;

/**
 * The slack of a triangle, and whether the triangle is thin. The slack tells from the values at the
 * corners that no crossing of an edge can lower a value.
 *
 * The slack is the least of 2 h - c over the triangle's sides, with c the length of the side and h
 * the height over it, rounded down. At cost 1 a distance is 1-Lipschitz: with a and b at the ends
 * of a side it is nowhere on the side less than (a + b - c) / 2, so a crossing of the side gives
 * the opposite corner at least (a + b + slack) / 2. A cost w is a factor of the slack. Both updates
 * of EikonalUpdate.h keep this bound; if their formula changes, it must be checked.
 */
class TriangleSlack
{
public:
  /** An infinite slack, for a ring entry that opens no triangle: nothing crosses it. */
  constexpr TriangleSlack() = default;
  /** @param slack finite; less than 0 if the triangle is thin */
  constexpr TriangleSlack(float slack, bool isThin)
    : Value(withFlag(isThin, slack))
  {
  }

  constexpr float value() const { return this->Value; }
  /** Whether the triangle's height over its longest side is less than a quarter of that side. */
  constexpr bool isThin() const
  {
    return (std::bit_cast<std::uint32_t>(this->Value) & ThinBit) != 0;
  }

  /** The bit of a slack that holds isThin(), for code that reads several slacks at once. */
  static constexpr std::uint32_t ThinBit = 1;

private:
  /** The next float down from @p slack, or itself, whose last bit is @p isThin. */
  static constexpr float withFlag(bool isThin, float slack)
  {
    const auto bits = std::bit_cast<std::uint32_t>(slack);
    const std::uint32_t off = (bits ^ (isThin ? ThinBit : 0u)) & ThinBit;
    const std::uint32_t isNegative = bits >> 31;
    return std::bit_cast<float>(bits - off + 2 * (off & isNegative));
  }

  float Value = std::numeric_limits<float>::infinity();
};

/**
 * What FastMarchingSolver and ReferenceSolver compute of a mesh's triangles before any march: the
 * slacks, which tell what updates may be skipped, and the margins, within which a vertex keeps the
 * values of several labels. Made once for a mesh. Memory 32 bytes a vertex.
 */
class UpdateBounds
{
public:
  /** @param team threads that do the work; the bounds do not depend on their number. Time O(n). */
  explicit UpdateBounds(const TriangleMesh& mesh, const ThreadTeam& team = ThreadTeam());

  /** The slacks of the triangles, by the number of the ring entry that opens the triangle, counted
   * over the rings of all vertices. VertexRings::Overrun slacks more may be read behind the last.
   */
  const TriangleSlack* slacks() const { return this->Slacks.data(); }
  /** For each vertex the largest labelMargin() of the triangles round it, for cost 1, rounded up.
   */
  std::span<const float> margins() const { return this->Margins; }
  /** The mean of margins(); 0 if there are no vertices. */
  double meanMargin() const { return this->MeanMargin; }

  /** Has the processor fetch slacks that are soon to be read. @param firstEntry number of the
   * ring's first entry. GCC drops the call unless it is inlined. */
  GEODESIC_INLINED void prefetch(std::size_t firstEntry) const
  {
    prefetchToRead(&this->Slacks[firstEntry]);
    prefetchToRead(&this->Slacks[firstEntry + 6]);
  }

private:
  BulkVector<TriangleSlack> Slacks;
  BulkVector<float> Margins;
  double MeanMargin = 0.0;
};

/** The margins of vertices that all pieces of a surface agree on: at a shared vertex the largest of
 * all pieces. */
class AgreedMargins
{
public:
  /**
   * Collective.
   * @param labels  number of labels; with one, margins have no effect and nothing is exchanged
   */
  AgreedMargins(const UpdateBounds& bounds, std::size_t labels, Partition& partition);

  /** The margins, one for each vertex. Valid as long as this object and the bounds. */
  std::span<const float> ofVertices() const
  {
    return this->Agreed.empty() ? this->Own : this->Agreed;
  }

private:
  std::span<const float> Own;
  std::vector<float> Agreed;
};

}

#endif

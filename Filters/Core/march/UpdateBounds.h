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
 * Tells from three values that no update over a triangle can gain anything, and whether the
 * triangle is thin.
 *
 * The slack is the least of 2 h - c over the triangle's sides, with c the length of the side and h
 * the height over it, rounded down. A distance is 1-Lipschitz: with a and b at the ends of a side
 * it is nowhere on the side less than (a + b - c) / 2, so the corner opposite to the side gets no
 * less than (a + b + slack) / 2 across it. The same holds of both updates in EikonalUpdate.h, which
 * it rests on.
 */
class TriangleSlack
{
public:
  /** Of a ring entry that opens no triangle: infinite. */
  constexpr TriangleSlack() = default;
  /** @param slack finite; less than 0 where the triangle is thin */
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

  /** The bit of a slack that isThin() is, for code that reads several slacks at once. */
  static constexpr std::uint32_t ThinBit = 1;

private:
  /** Rounds down to the next number whose last bit is the flag. */
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
 * What fast marching knows of a mesh's triangles beforehand: which updates it may skip, and for how
 * long a vertex keeps the values of several labels. Made once for a mesh; 32 bytes a vertex.
 */
class UpdateBounds
{
public:
  /** @param team threads to work on; the bounds do not depend on their number. Time O(n). */
  explicit UpdateBounds(const TriangleMesh& mesh, const ThreadTeam& team = ThreadTeam());

  /** By the number of the ring entry that opens the triangle, counted over the rings of all
   * vertices; VertexRings::Overrun more behind the last. */
  const TriangleSlack* slacks() const { return this->Slacks.data(); }
  /** Of each vertex the largest labelMargin() of the triangles round it, rounded up. */
  std::span<const float> margins() const { return this->Margins; }
  /** The mean of margins(); 0 without any. */
  double meanMargin() const { return this->MeanMargin; }

  /** Fetches the slacks of the ring whose first entry has a number, as they are soon read. GCC
   * drops the call unless it is inlined. */
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

/** The margins on all pieces of a surface: at each shared vertex the largest of any piece. */
class AgreedMargins
{
public:
  /** Collective. @param labels how many there are: of one, margins play no part and pieces need not
   * agree on them */
  AgreedMargins(const UpdateBounds& bounds, std::size_t labels, Partition& partition);

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

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RingNumbers_h
#define geodesic_RingNumbers_h

#include "base/BulkVector.h"
#include "base/Index.h"
#include "base/ThreadTeam.h"
#include "base/Vector3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace geodesic
{

class TriangleMesh;

/** A number that is kept with each ring entry. It has 16 bits, as the march reads one for each
 * neighbour of each vertex; what they mean is the measurer's affair. */
using EntryNumber = std::uint16_t;

/** What a RingMeasurer tells of up to 64 triangles. */
struct TriangleNumbers
{
  /** Largest number of triangles. */
  static constexpr std::size_t Most = 64;

  /** The lengths of the longest sides, rounded up. */
  std::array<float, Most> longestSides{};
  /** Stored with each ring entry that opens the triangle. */
  std::array<EntryNumber, Most> ofEntries{};
  /** Each vertex gets the largest of the triangles round it. */
  std::array<float, Most> ofVertices{};
};

/**
 * Computes numbers of triangles that are kept beside the rings of a mesh: one for each ring entry
 * and one for each vertex. A mesh that is given a measurer asks it while it makes its rings and has
 * the triangles at hand, which takes a third of the time of a pass of its own over the rings. The
 * mesh does not know what the numbers mean.
 */
class RingMeasurer
{
public:
  virtual ~RingMeasurer() = default;

  /**
   * Measures some triangles. Several threads may call it at once.
   * @param triangles  at most TriangleNumbers::Most
   * @param positions  of the vertices
   * @param numbers    gets the numbers, in the order of the triangles
   */
  virtual void measure(std::span<const Triangle> triangles, std::span<const Vector3> positions,
    TriangleNumbers& numbers) const = 0;
  /** What is stored with a ring entry that opens no triangle. */
  virtual EntryNumber ofNoTriangle() const = 0;
};

/** Has a measurer measure up to TriangleNumbers::Most triangles; without one, where @p measurer is
 * null, only their longest sides. */
void measureTriangles(const RingMeasurer* measurer, std::span<const Triangle> triangles,
  std::span<const Vector3> positions, TriangleNumbers& numbers);

/** The numbers of a mesh's ring entries and vertices. */
struct RingNumbers
{
  /** Who computed them. */
  const RingMeasurer* measurer = nullptr;
  /** By the number of the ring entry, counted over the rings of all vertices.
   * VertexRings::Overrun numbers more may be read behind the last. */
  BulkVector<EntryNumber> ofEntries;
  /** For each vertex the largest number of the triangles round it, at least 0. */
  BulkVector<float> ofVertices;
};

/**
 * The numbers that a measurer gives for a mesh: those that the mesh was built with, if it was built
 * with this measurer; else they are computed now.
 * @param team threads that do the work; the numbers do not depend on their count. Time O(n).
 */
std::shared_ptr<const RingNumbers> ringNumbers(
  const TriangleMesh& mesh, const RingMeasurer& measurer, const ThreadTeam& team = ThreadTeam());

}

#endif

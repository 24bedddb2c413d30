// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_UpdateBounds_h
#define geodesic_UpdateBounds_h

#include "base/Platform.h"
#include "base/ThreadTeam.h"
#include "mesh/RingNumbers.h"
#include "mesh/TriangleMesh.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace geodesic
{

class Partition;

/** Computes the numbers of UpdateBounds. A mesh that is built for fast marching is given it, so
 * that it makes them along with its rings. */
const RingMeasurer& updateMeasurer();

/**
 * What FastMarchingSolver and ReferenceSolver compute of a mesh's triangles before any march: the
 * slacks, which tell what updates may be skipped, and the margins, within which a vertex keeps the
 * values of several labels. TriangleMeasurer computes them, while the mesh is built if the mesh is
 * given updateMeasurer(), else when this object is made. Memory 18 bytes a vertex.
 */
class UpdateBounds
{
public:
  /** @param team threads that do the work; the bounds do not depend on their number. Time O(n). */
  explicit UpdateBounds(const TriangleMesh& mesh, const ThreadTeam& team = ThreadTeam());

  /** TriangleSlack::stored() of the triangles, by the number of the ring entry that opens the
   * triangle, counted over the rings of all vertices. VertexRings::Overrun slacks more may be read
   * behind the last. */
  const EntryNumber* slacks() const { return this->Slacks; }
  /** For each vertex the largest labelMargin() of the triangles round it, for cost 1, rounded up.
   */
  std::span<const float> margins() const { return this->Numbers->ofVertices; }
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
  std::shared_ptr<const RingNumbers> Numbers;
  const EntryNumber* Slacks;
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

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_MotionTable_h
#define geodesic_MotionTable_h

#include "base/BulkVector.h"
#include "base/Index.h"
#include "base/ThreadTeam.h"
#include "base/Vector3.h"
#include "mesh/RingNumbers.h"

#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace geodesic
{

class TriangleMesh;

/** What a mesh looks up when its points move. It depends on the mesh's structure alone. */
class MotionTable
{
public:
  /** Time O(n), memory 28 bytes a vertex. */
  explicit MotionTable(const TriangleMesh& mesh);

  /** Whether several points are one vertex somewhere. */
  bool hasMergedPoints() const { return !this->MergedPoints.empty(); }
  /** Whether points that are one vertex because they coincided still do.
   * @param points     of the input
   * @param positions  of the vertices, one of these points each */
  bool areMergedTogether(std::span<const Vector3> points, std::span<const Vector3> positions) const;

  /** What was measured round the vertices. */
  struct Measured
  {
    BulkVector<float> longestSides;
    /** Null without a measurer. */
    std::shared_ptr<const RingNumbers> numbers;
  };
  /** Measures each triangle once, and hands its numbers to the ring entries that open it. */
  Measured measure(
    const TriangleMesh& mesh, std::span<const Vector3> positions, const ThreadTeam& team) const;

private:
  /** A point that isn't the first of its vertex. */
  struct MergedPoint
  {
    Index point;
    Index vertex;
  };

  void linkEntries(const TriangleMesh& mesh);
  void listMergedPoints(const TriangleMesh& mesh);

  /** For each ring entry the triangle that it opens; the number of triangles if it opens none. */
  BulkVector<Index> TriangleOfEntry;
  std::vector<MergedPoint> MergedPoints;
};

/** A table that is made when it is first asked for; safe to ask from several threads. */
struct LazyMotionTable
{
  const MotionTable& of(const TriangleMesh& mesh)
  {
    std::call_once(this->IsMade, [&] { this->Table = std::make_unique<MotionTable>(mesh); });
    return *this->Table;
  }

private:
  std::once_flag IsMade;
  std::unique_ptr<const MotionTable> Table;
};

}

#endif

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PointSearch_h
#define geodesic_PointSearch_h

#include "base/Vector3.h"
#include "search/ClosestPointTree.h"

#include <atomic>
#include <memory>
#include <mutex>

namespace geodesic
{

class TriangleMesh;

/**
 * Finds the same points of a surface as ClosestPointTree, which it makes when that pays: the first
 * few nearest points are found by a scan of all vertices, each in a thirtieth of the time that the
 * tree takes to be made. So a surface that is asked once, as each step of a time series, needs no
 * tree. Safe to use from several threads.
 */
class PointSearch
{
public:
  using Result = ClosestPointTree::Result;

  /** @param mesh the surface, which this object shares */
  explicit PointSearch(std::shared_ptr<const TriangleMesh> mesh);

  /** See ClosestPointTree. Time O(n) for the first MostScans calls, unless there is a tree. */
  Result closestPoint(const Vector3& query) const;
  /** The tree, made now if there is none. */
  const ClosestPointTree& tree() const;

  static constexpr int MostScans = 8;

private:
  std::shared_ptr<const TriangleMesh> Mesh;
  mutable std::atomic<int> Scans = 0;
  mutable std::once_flag IsTreeMade;
  mutable std::unique_ptr<const ClosestPointTree> Tree;
  /** Null until the tree is there. */
  mutable std::atomic<const ClosestPointTree*> ReadyTree = nullptr;
};

/** The point of a surface that is nearest to a query, found by a scan of all vertices; as
 * ClosestPointTree::closestPoint(). */
PointSearch::Result scannedClosestPoint(const TriangleMesh& mesh, const Vector3& query);

}

#endif

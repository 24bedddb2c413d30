// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PassableTriangles_h
#define geodesic_PassableTriangles_h

#include "base/Index.h"

#include <vector>

namespace geodesic
{

class EdgeTable;
class TriangleMesh;
struct SolveOptions;

/**
 * Tells which triangles fronts may cross that go from edge to edge: none that is closed or has an
 * excluded corner, nor one with the same three corners as such a triangle.
 */
class PassableTriangles
{
public:
  /** If any triangle is closed or vertex excluded: time O(n), memory 4 bits a vertex. */
  PassableTriangles(const TriangleMesh& mesh, const EdgeTable& edges, const SolveOptions& options);

  /** Whether every triangle may be crossed. */
  bool areAll() const { return this->Passable.empty(); }
  bool contains(Index triangle) const { return this->Passable.empty() || this->Passable[triangle]; }
  /** Whether a triangle, or one with the same three corners, is closed: nothing starts in it. */
  bool isClosed(Index triangle) const { return !this->Closed.empty() && this->Closed[triangle]; }
  /** Whether each vertex is a corner of a triangle that fronts may not cross; empty where there is
   * none. Shortest paths can turn there. Time O(n), unless it is empty. */
  std::vector<bool> verticesBesideOthers(const TriangleMesh& mesh) const;

private:
  std::vector<bool> Passable;
  /** Empty where no triangle is closed. */
  std::vector<bool> Closed;
};

}

#endif

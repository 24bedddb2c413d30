// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleSides_h
#define geodesic_TriangleSides_h

#include "base/Index.h"

#include <vector>

namespace geodesic
{

class TriangleMesh;

/**
 * Which triangles lie beside each other. Side 3 t + i is that of triangle t from its corner i to
 * its corner i + 1. The sides of all triangles that share an edge form a circle: two on a manifold,
 * one at a border, more where sheets meet. Memory 24 bytes a vertex.
 */
class TriangleSides
{
public:
  /** Time O(n log k), with k triangles round a vertex. */
  explicit TriangleSides(const TriangleMesh& mesh);

  static Index triangleOf(Index side) { return side / 3; }
  /** The side of the same triangle that begins where @p side ends. */
  static Index following(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }

  /** The next side on the circle of the same edge; @p side itself where it is the only one. */
  Index next(Index side) const { return this->Next[side]; }

private:
  std::vector<Index> Next;
};

}

#endif

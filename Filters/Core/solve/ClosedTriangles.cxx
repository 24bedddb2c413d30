// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/ClosedTriangles.h"

#include <algorithm>

namespace geodesic
{

ClosedTriangles::ClosedTriangles(const TriangleMesh& mesh, std::span<const std::uint8_t> closed)
  : Mesh(mesh)
{
  if (std::find_if(closed.begin(), closed.end(), [](std::uint8_t c) { return c != 0; }) ==
    closed.end())
  {
    return;
  }
  this->Closed.resize(mesh.rings().numberOfEntries(), 0);
  for (Index t = 0; t < closed.size(); ++t)
  {
    const Triangle& corners = mesh.triangle(t);
    for (int c = 0; closed[t] && c < 3; ++c)
    {
      const Index a = corners[(c + 1) % 3];
      const Index b = corners[(c + 2) % 3];
      const std::span<const RingEntry> ring = mesh.ring(corners[c]);
      for (std::size_t i = 0; i + 1 < ring.size(); ++i)
      {
        const Index p = ring[i].neighbour();
        const Index q = ring[i + 1].neighbour();
        if (ring[i].opensTriangle() && ((p == a && q == b) || (p == b && q == a)))
        {
          this->Closed[mesh.rings().firstEntry(corners[c]) + i] = 1;
        }
      }
    }
  }
}

bool ClosedTriangles::hasOpenTriangle(Index vertex) const
{
  for (std::size_t i = 0; i < this->Mesh.ring(vertex).size(); ++i)
  {
    if (this->isOpen(vertex, i))
    {
      return true;
    }
  }
  return false;
}

}

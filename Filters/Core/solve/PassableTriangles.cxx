// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/PassableTriangles.h"

#include "mesh/EdgeTable.h"
#include "mesh/TriangleMesh.h"
#include "solve/SolveOptions.h"

#include <algorithm>

namespace geodesic
{

PassableTriangles::PassableTriangles(
  const TriangleMesh& mesh, const EdgeTable& edges, const SolveOptions& options)
{
  if (options.excluded.empty() && options.closedTriangles.empty())
  {
    return;
  }
  this->Closed.assign(options.closedTriangles.begin(), options.closedTriangles.end());
  for (const auto& [repeated, first] : edges.repetitions())
  {
    if (this->isClosed(repeated))
    {
      this->Closed[first] = true;
    }
  }
  for (const auto& [repeated, first] : edges.repetitions())
  {
    if (this->isClosed(first))
    {
      this->Closed[repeated] = true;
    }
  }
  this->Passable.resize(mesh.numberOfTriangles());
  for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
  {
    const Triangle& corners = mesh.triangle(t);
    this->Passable[t] = !this->isClosed(t) &&
      std::none_of(
        corners.begin(), corners.end(), [&](Index corner) { return options.isExcluded(corner); });
  }
}

std::vector<bool> PassableTriangles::verticesBesideOthers(const TriangleMesh& mesh) const
{
  std::vector<bool> beside(this->areAll() ? 0 : mesh.numberOfVertices());
  for (Index t = 0; t < this->Passable.size(); ++t)
  {
    if (!this->Passable[t])
    {
      for (const Index corner : mesh.triangle(t))
      {
        beside[corner] = true;
      }
    }
  }
  return beside;
}

}

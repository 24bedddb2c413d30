// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "split/RegionMesh.h"

#include "base/Interruption.h"

namespace geodesic
{

RegionMesh::RegionMesh(std::shared_ptr<const TriangleMesh> mesh)
  : Mesh(std::move(mesh))
  , Edges(*this->Mesh)
{
  this->Areas.reserve(this->Mesh->numberOfTriangles());
  for (Index triangle = 0; triangle < this->Mesh->numberOfTriangles(); ++triangle)
  {
    Interruption::checkAt(triangle);
    const auto [a, b, c] = this->Mesh->triangle(triangle);
    const Vector3& apex = this->Mesh->position(a);
    this->Areas.push_back(
      0.5 * norm(cross(this->Mesh->position(b) - apex, this->Mesh->position(c) - apex)));
    for (Index halfEdge = 3 * triangle; halfEdge < 3 * triangle + 3; ++halfEdge)
    {
      if (!this->Edges.isRepeated(triangle) && this->Edges.next(halfEdge) == halfEdge)
      {
        this->Border.push_back(halfEdge);
      }
    }
  }
}

}

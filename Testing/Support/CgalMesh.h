// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_CgalMesh_h
#define geodesic_testing_CgalMesh_h

#include "Surfaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <stdexcept>

namespace geodesic::testing::cgal
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using ShortestPath = CGAL::Surface_mesh_shortest_path<Traits>;

/** A surface as CGAL's own; throws std::runtime_error for one that is not manifold. */
inline Mesh cgalMeshOf(const Surface& surface)
{
  Mesh mesh;
  for (const Vector3& p : surface.points)
  {
    mesh.add_vertex({ p.x, p.y, p.z });
  }
  for (const Triangle& t : surface.triangles)
  {
    if (mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]),
          Mesh::Vertex_index(t[2])) == Mesh::null_face())
    {
      throw std::runtime_error("CGAL needs a manifold surface");
    }
  }
  return mesh;
}

}

#endif

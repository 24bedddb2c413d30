// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HeatMethod.h"

#include "mesh/TriangleMesh.h"

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>

namespace geodesic::testing
{
namespace
{
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh surfaceOf(const TriangleMesh& mesh)
{
  Mesh surface;
  for (const Vector3& p : mesh.positions())
  {
    surface.add_vertex({ p.x, p.y, p.z });
  }
  for (const Triangle& t : mesh.triangles())
  {
    if (surface.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]),
          Mesh::Vertex_index(t[2])) == Mesh::null_face())
    {
      throw std::runtime_error("the heat method needs a manifold surface");
    }
  }
  return surface;
}
}

struct HeatMethod::Internals
{
  explicit Internals(const TriangleMesh& mesh)
    : surface(surfaceOf(mesh))
    , heat(surface)
  {
  }

  Mesh surface;
  CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh> heat;
};

HeatMethod::HeatMethod(const TriangleMesh& mesh)
  : Internal(std::make_unique<Internals>(mesh))
{
  // The factorization waits for the first source.
  this->solve(0);
}

HeatMethod::~HeatMethod() = default;

std::vector<double> HeatMethod::solve(Index source)
{
  std::vector<double> distances(num_vertices(this->Internal->surface));
  const auto values = CGAL::make_property_map(distances);
  this->Internal->heat.clear_sources();
  this->Internal->heat.add_source(Mesh::Vertex_index(source));
  this->Internal->heat.estimate_geodesic_distances(values);
  return distances;
}

}

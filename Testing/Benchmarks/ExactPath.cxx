#include "ExactPath.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <iterator>
#include <stdexcept>

namespace geodesic::testing
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;

Mesh meshOf(const Surface& surface)
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
      throw std::runtime_error("exact paths need a manifold surface");
    }
  }
  return mesh;
}
}

struct ExactPath::Internals
{
  explicit Internals(const Surface& surface)
    : mesh(meshOf(surface))
    , paths(mesh)
  {
  }

  Mesh mesh;
  CGAL::Surface_mesh_shortest_path<Traits> paths;
};

ExactPath::ExactPath(const Surface& surface, Index source)
  : Internal(std::make_unique<Internals>(surface))
{
  this->Internal->paths.add_source_point(Mesh::Vertex_index(source));
  this->Internal->paths.build_sequence_tree();
}

ExactPath::~ExactPath() = default;

std::vector<Vector3> ExactPath::to(Index target)
{
  std::vector<Kernel::Point_3> points;
  this->Internal->paths.shortest_path_points_to_source_points(
    Mesh::Vertex_index(target), std::back_inserter(points));
  std::vector<Vector3> corners;
  for (const Kernel::Point_3& p : points)
  {
    corners.push_back({ p.x(), p.y(), p.z() });
  }
  return corners;
}

}

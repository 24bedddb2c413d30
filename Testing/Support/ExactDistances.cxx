// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExactDistances.h"

#include "CgalMesh.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
// CGAL 6 renamed it.
#if __has_include(<CGAL/AABB_traits_3.h>)
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <algorithm>
#include <cmath>
#include <random>

namespace geodesic::testing
{
namespace
{
using namespace cgal;

#if __has_include(<CGAL/AABB_traits_3.h>)
using BoxTraits = CGAL::AABB_traits_3<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>;
#else
using BoxTraits = CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>;
#endif

std::vector<double> distancesBy(ShortestPath& paths, const Mesh& mesh)
{
  std::vector<double> distances;
  for (Mesh::Vertex_index v : mesh.vertices())
  {
    distances.push_back(
      mesh.is_isolated(v) ? -1.0 : paths.shortest_distance_to_source_points(v).first);
  }
  return distances;
}

/**
 * Adds a source in a face, or on its border. From a point on an edge CGAL 5.5 gives distances below
 * the straight line, so such a point is moved into the face by a billionth of its size.
 */
void addSource(ShortestPath& paths, Mesh::Face_index face, Traits::Barycentric_coordinates weights)
{
  double sum = 0.0;
  for (double& weight : weights)
  {
    weight = std::max(weight, 1e-9);
    sum += weight;
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  paths.add_source_point(face, weights);
}
}

std::vector<double> exactDistancesFromPositions(
  const Surface& surface, const std::vector<Vector3>& positions)
{
  const Mesh mesh = cgalMeshOf(surface);
  ShortestPath paths(mesh);
  CGAL::AABB_tree<BoxTraits> tree;
  paths.build_aabb_tree(tree);
  for (const Vector3& p : positions)
  {
    const ShortestPath::Face_location location = paths.locate(Kernel::Point_3(p.x, p.y, p.z), tree);
    addSource(paths, location.first, location.second);
  }
  return distancesBy(paths, mesh);
}

std::vector<double> exactDistances(const Surface& surface, const std::vector<Index>& sources)
{
  const Mesh mesh = cgalMeshOf(surface);
  ShortestPath paths(mesh);
  for (Index source : sources)
  {
    paths.add_source_point(Mesh::Vertex_index(source));
  }
  return distancesBy(paths, mesh);
}

std::vector<double> exactDistancesFrom(const Surface& surface, const SurfacePoint& source)
{
  const Mesh mesh = cgalMeshOf(surface);
  ShortestPath paths(mesh);
  // CGAL's weights start at the corner that the face's halfedge comes from, which need not be the
  // first one given.
  const Mesh::Face_index face(source.triangle);
  const Triangle& corners = surface.triangles[source.triangle];
  Traits::Barycentric_coordinates weights{};
  Mesh::Halfedge_index halfedge = mesh.halfedge(face);
  for (double& weight : weights)
  {
    const auto corner = std::find(corners.begin(), corners.end(), mesh.source(halfedge).idx());
    weight = source.weights[corner - corners.begin()];
    halfedge = mesh.next(halfedge);
  }
  addSource(paths, face, weights);
  return distancesBy(paths, mesh);
}

double distanceToTriangle(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& query)
{
  const Kernel::Triangle_3 triangle({ a.x, a.y, a.z }, { b.x, b.y, b.z }, { c.x, c.y, c.z });
  return std::sqrt(CGAL::squared_distance(Kernel::Point_3(query.x, query.y, query.z), triangle));
}

Surface delaunayPlane(Index points, unsigned seed, double grading)
{
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
  using Triangulation =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;
  Surface surface;
  const Index side = static_cast<Index>(std::sqrt(static_cast<double>(points)));
  for (Index i = 0; i < side; ++i)
  {
    const double s = static_cast<double>(i) / side;
    surface.points.insert(
      surface.points.end(), { { s, 0, 0 }, { 1, s, 0 }, { 1 - s, 1, 0 }, { 0, 1 - s, 0 } });
  }
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  while (surface.points.size() < points)
  {
    const double x = uniform(random);
    surface.points.push_back({ x, uniform(random), 0.0 });
  }
  for (Vector3& p : surface.points)
  {
    p.x = std::pow(p.x, grading);
  }
  std::vector<std::pair<Kernel::Point_2, Index>> numbered;
  for (Index i = 0; i < surface.points.size(); ++i)
  {
    numbered.emplace_back(Kernel::Point_2(surface.points[i].x, surface.points[i].y), i);
  }
  const Triangulation triangulation(numbered.begin(), numbered.end());
  for (auto face : triangulation.finite_face_handles())
  {
    surface.triangles.push_back(
      { face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info() });
  }
  return surface;
}

}

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExactPath.h"

#include "CgalMesh.h"

#include <iterator>

namespace geodesic::testing
{
using namespace cgal;

struct ExactPath::Internals
{
  explicit Internals(const Surface& surface)
    : mesh(cgalMeshOf(surface))
    , paths(mesh)
  {
  }

  Mesh mesh;
  ShortestPath paths;
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

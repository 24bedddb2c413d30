// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PickedSurface.h"

#include <algorithm>

namespace geodesic::bridge
{

PickedSurface::NearPoint PickedSurface::nearestPoint(const Vector3& position) const
{
  const TriangleMesh& mesh = this->mesh();
  const ClosestPointTree::Result nearest = this->Surface->closestPoints().closestPoint(position);
  const Triangle& corners = mesh.triangle(nearest.point.triangle);
  const auto isNearer = [&](Index a, Index b)
  { return norm(mesh.position(a) - position) < norm(mesh.position(b) - position); };
  const Index corner = *std::min_element(corners.begin(), corners.end(), isNearer);
  return { static_cast<vtkIdType>(mesh.pointOfVertex(corner)), nearest.distance };
}

std::optional<SurfacePath> PickedSurface::path(
  vtkIdType begin, vtkIdType end, const SolverTraits& method, PathOrder order)
{
  const Index from = this->vertexAt(begin);
  const Index to = this->vertexAt(end);
  if (from == NoIndex || to == NoIndex)
  {
    return std::nullopt;
  }
  const PathStyle style{ order, order == PathOrder::Edges };
  return shortestPath(this->solverOf(method), this->mesh().pointAtVertex(from),
    this->mesh().pointAtVertex(to), {}, style);
}

Index PickedSurface::vertexAt(vtkIdType id) const
{
  const bool exists = id >= 0 && id < static_cast<vtkIdType>(this->mesh().numberOfPoints());
  return exists ? this->mesh().vertexOfPoint(static_cast<Index>(id)) : NoIndex;
}

DistanceSolver& PickedSurface::solverOf(const SolverTraits& method)
{
  std::unique_ptr<DistanceSolver>& solver = this->Solvers[method.number];
  if (!solver)
  {
    solver = method.make(this->Surface->mesh());
  }
  return *solver;
}

}

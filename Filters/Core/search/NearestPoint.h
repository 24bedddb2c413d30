// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NearestPoint_h
#define geodesic_NearestPoint_h

#include "base/NumberText.h"
#include "mesh/TriangleMesh.h"
#include "search/ClosestPointTree.h"
#include "search/NearestOrder.h"
#include "search/SearchedTriangle.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace geodesic
{

/** The point nearest to a query on the triangles that were tried, by NearestOrder; where it lies in
 * several of them, in the first by number. So it does not depend on the order in which they were
 * tried. */
class NearestPoint
{
public:
  NearestPoint(const TriangleMesh& mesh, const Vector3& query)
    : Mesh(mesh)
    , Query(query)
    , Order(query)
  {
  }

  /** The square of the distance up to which a point may come before the best one. */
  double reach() const { return this->Reach; }

  void tryTriangle(Index t)
  {
    const Triangle& vertices = this->Mesh.triangle(t);
    const std::array<Vector3, 3> corners{ this->Mesh.position(vertices[0]),
      this->Mesh.position(vertices[1]), this->Mesh.position(vertices[2]) };
    const SearchedTriangle triangle(corners, this->Query);
    if (triangle.isBeyond(this->Reach))
    {
      return;
    }
    const OnTriangle found = triangle.nearest();
    if (!(found.squaredDistance <= this->Reach))
    {
      return;
    }
    const SurfacePoint point{ t, found.weights };
    const NearestOrder::Candidate candidate{ std::sqrt(found.squaredDistance),
      this->Mesh.positionOf(point) };
    if (this->Order.isBefore(candidate, this->Best) ||
      (t < this->Point.triangle && !this->Order.isBefore(this->Best, candidate)))
    {
      this->Best = candidate;
      this->Point = point;
      this->Reach = std::pow(candidate.distance + this->Order.blur(candidate), 2);
    }
  }

  /** @throws std::invalid_argument where no triangle was near enough to measure its distance */
  ClosestPointTree::Result result() const
  {
    if (this->Point.triangle == NoIndex)
    {
      throw std::invalid_argument("The point (" + textOf(this->Query.x) + ", " +
        textOf(this->Query.y) + ", " + textOf(this->Query.z) +
        ") is too far from the surface to measure its distance. Correct its coordinates.");
    }
    ClosestPointTree::Result result;
    result.point = snapped(this->Point);
    result.position = this->Mesh.positionOf(result.point);
    result.distance = norm(this->Query - result.position);
    return result;
  }

private:
  const TriangleMesh& Mesh;
  Vector3 Query;
  NearestOrder Order;
  NearestOrder::Candidate Best;
  SurfacePoint Point{ NoIndex, {} };
  double Reach = std::numeric_limits<double>::max();
};

}

#endif

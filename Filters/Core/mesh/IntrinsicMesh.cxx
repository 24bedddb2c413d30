// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The functions of TriangleMesh that make an intrinsic mesh.

#include "base/Interruption.h"
#include "mesh/IntrinsicTriangles.h"
#include "mesh/MotionTable.h"
#include "mesh/TriangleMesh.h"
#include "mesh/TriangleShape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace geodesic
{
namespace
{

/** Lays the triangles round a vertex into a plane, fan by fan. */
class FanInPlane
{
public:
  FanInPlane(const IntrinsicTriangles& intrinsic, Index vertex)
    : Intrinsic(intrinsic)
    , Vertex(vertex)
  {
  }

  /** @param offsets gets the vector to the neighbour of each entry
   * @return the length of the longest side of these triangles */
  double lay(std::span<const RingEntry> ring, Vector3* offsets)
  {
    double longest = 0.0;
    Vector3 direction{ 1.0, 0.0, 0.0 };
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const double length = this->Intrinsic.length(this->Vertex, ring[i].neighbour());
      if (i == 0 || !ring[i - 1].opensTriangle())
      {
        direction = { 1.0, 0.0, 0.0 };
      }
      else
      {
        const double before = this->Intrinsic.length(this->Vertex, ring[i - 1].neighbour());
        const double across = this->Intrinsic.length(ring[i - 1].neighbour(), ring[i].neighbour());
        direction = turned(direction, before, length, across);
        longest = std::max(longest, across);
      }
      longest = std::max(longest, length);
      offsets[i] = length * direction;
    }
    return longest;
  }

private:
  /** A direction turned by the angle between two sides. */
  static Vector3 turned(const Vector3& direction, double a, double b, double opposite)
  {
    const double product = 2.0 * a * b;
    if (!(product > 0.0))
    {
      return direction;
    }
    const double cosine = twiceDot(a, b, opposite) / product;
    const double sine = fourAreas(a, b, opposite) / product;
    const double perLength = 1.0 / std::hypot(cosine, sine);
    return { perLength * (direction.x * cosine - direction.y * sine),
      perLength * (direction.x * sine + direction.y * cosine), 0.0 };
  }

  const IntrinsicTriangles& Intrinsic;
  Index Vertex;
};

}

TriangleMesh TriangleMesh::withTriangles(
  const IntrinsicTriangles& intrinsic, const ThreadTeam& team) const
{
  TriangleMesh mesh;
  const Index count = intrinsic.numberOfVertices();
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  mesh.Positions = this->Positions;
  mesh.Positions.resize(count);
  std::fill(mesh.Positions.begin() + this->numberOfVertices(), mesh.Positions.end(),
    Vector3{ none, none, none });
  mesh.VertexOfPoint = this->VertexOfPoint;
  std::vector<Index> points(this->PointOfVertex.begin(), this->PointOfVertex.end());
  points.resize(count, NoIndex);
  mesh.PointOfVertex = SharedVector(std::move(points));
  mesh.BarePoints = this->BarePoints;
  mesh.NumberOfSources = this->NumberOfSources;
  mesh.Motion = std::make_shared<LazyMotionTable>();
  BulkVector<Index> room(VertexRings::RoomOfTriangle * intrinsic.triangles().size());
  std::vector<Index> vertices(count);
  std::iota(vertices.begin(), vertices.end(), 0);
  mesh.orderTriangles(vertices, intrinsic.triangles(), room, team);
  mesh.makeRings(room, team, nullptr);
  mesh.makeOffsets(intrinsic, team);
  return mesh;
}

void TriangleMesh::makeOffsets(const IntrinsicTriangles& intrinsic, const ThreadTeam& team)
{
  BulkVector<Vector3> offsets(this->Rings.numberOfEntries() + VertexRings::Overrun);
  std::fill(offsets.end() - VertexRings::Overrun, offsets.end(), Vector3{});
  BulkVector<float> longestSides(this->numberOfVertices());
  team.run(this->numberOfVertices(),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (Index v = static_cast<Index>(first); v < last; ++v)
      {
        Interruption::checkAt(v);
        const double longest =
          FanInPlane(intrinsic, v).lay(this->ring(v), &offsets[this->Rings.firstEntry(v)]);
        longestSides[v] =
          std::nextafter(static_cast<float>(longest), std::numeric_limits<float>::infinity());
      }
    });
  this->Offsets = SharedVector(std::move(offsets));
  this->Rings = this->Rings.withLongestSides(std::move(longestSides));
  this->measureEdges();
}

}

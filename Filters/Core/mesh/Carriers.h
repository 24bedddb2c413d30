// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Carriers_h
#define geodesic_Carriers_h

#include "base/Index.h"
#include "mesh/TriangleMesh.h"

#include <array>

namespace geodesic
{

/** The vertices that carry a point, those with a weight in it: one vertex, the two ends of an edge,
 * or the three corners of a face. */
class Carriers
{
public:
  constexpr void add(Index vertex)
  {
    if (!this->contains(vertex))
    {
      this->Vertices[this->Count++] = vertex;
    }
  }
  /** Adds a vertex that is not there as yet. */
  constexpr void addNew(Index vertex) { this->Vertices[this->Count++] = vertex; }
  constexpr bool contains(Index vertex) const
  {
    // std::find takes longer for so few.
    for (int i = 0; i < this->Count; ++i)
    {
      if (this->Vertices[i] == vertex)
      {
        return true;
      }
    }
    return false;
  }
  constexpr int size() const { return this->Count; }
  constexpr Index operator[](int i) const { return this->Vertices[i]; }
  constexpr const Index* begin() const { return this->Vertices.data(); }
  constexpr const Index* end() const { return this->Vertices.data() + this->Count; }

private:
  // There is room for the corners of two faces, so that a union needs no check.
  std::array<Index, 6> Vertices{};
  int Count = 0;
};

/** Whether a face may have all vertices that carry two points: it has room for three. */
constexpr bool mayShareFace(const Carriers& a, const Carriers& b)
{
  int size = a.size();
  for (const Index vertex : b)
  {
    size += a.contains(vertex) ? 0 : 1;
  }
  return size <= 3;
}

/** The vertices whose weights carry the point: a vertex, the ends of an edge, a face's corners.
 */
inline Carriers carriersOf(const TriangleMesh& mesh, const SurfacePoint& point)
{
  Carriers carriers;
  for (int c = 0; c < 3; ++c)
  {
    if (point.weights[c] > 0.0)
    {
      carriers.add(mesh.triangle(point.triangle)[c]);
    }
  }
  return carriers;
}

/** The vertices that carry the one point, the other one, or both. */
inline Carriers carriersOf(
  const TriangleMesh& mesh, const SurfacePoint& point, const SurfacePoint& other)
{
  Carriers carriers = carriersOf(mesh, point);
  for (const Index carrier : carriersOf(mesh, other))
  {
    carriers.add(carrier);
  }
  return carriers;
}

}

#endif

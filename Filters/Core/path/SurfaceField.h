// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfaceField_h
#define geodesic_SurfaceField_h

#include "mesh/EdgeTable.h"
#include "mesh/TriangleMesh.h"
#include "path/FaceField.h"
#include "path/FlatFace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <span>
#include <utility>

namespace geodesic
{

/** Distances on a mesh, signed or not, as isolines see them: one value for each vertex, and its
 * cost. Borrows all. */
struct SurfaceField
{
  const TriangleMesh& mesh;
  const EdgeTable& edges;
  /** NaN or infinite where there is none. */
  std::span<const double> values;
  /** Empty: 1 everywhere. */
  std::span<const double> cost;

  /** The sign of values, 0 if there are both. */
  static int signOf(std::initializer_list<double> values)
  {
    const auto [least, most] = std::minmax(values);
    return least >= 0.0 ? 1 : (most <= 0.0 ? -1 : 0);
  }

  std::array<double, 3> valuesOf(Index face) const
  {
    const Triangle& t = this->mesh.triangle(face);
    return { this->values[t[0]], this->values[t[1]], this->values[t[2]] };
  }
  int signOfFace(Index face) const
  {
    const auto v = this->valuesOf(face);
    return signOf({ v[0], v[1], v[2] });
  }
  FlatFace flat(Index face) const
  {
    const Triangle& t = this->mesh.triangle(face);
    return { this->mesh.position(t[0]), this->mesh.position(t[1]), this->mesh.position(t[2]) };
  }
  double areaOf(Index face) const
  {
    const FlatFace flat = this->flat(face);
    return 0.5 * orientation(flat.corners[0], flat.corners[1], flat.corners[2]);
  }
  /** The field inside a face, of the magnitudes of its values. */
  FaceField inFace(Index face, const FlatFace& flat) const
  {
    const Triangle& t = this->mesh.triangle(face);
    std::array<double, 3> magnitudes{};
    std::array<double, 3> costs{ 1.0, 1.0, 1.0 };
    for (int c = 0; c < 3; ++c)
    {
      magnitudes[c] = std::abs(this->values[t[c]]);
      costs[c] = this->cost.empty() ? 1.0 : this->cost[t[c]];
    }
    return { flat.corners, magnitudes, costs };
  }
  /** Whether a face has an area and values, and is the first with its corners. */
  bool hasField(Index face) const
  {
    const auto v = this->valuesOf(face);
    return std::all_of(v.begin(), v.end(), [](double value) { return std::isfinite(value); }) &&
      !this->edges.isRepeated(face) && this->areaOf(face) > 0.0;
  }
  /** A half-edge that is the same for all faces with its edge. */
  Index edgeOf(Index halfEdge) const { return this->edges.first(halfEdge); }
  /** The ends of a half-edge's edge, smaller vertex first. */
  std::pair<Index, Index> endsOf(Index halfEdge) const
  {
    const Triangle& t = this->mesh.triangle(EdgeTable::triangleOf(halfEdge));
    return std::minmax(t[(halfEdge + 1) % 3], t[(halfEdge + 2) % 3]);
  }
};

}

#endif

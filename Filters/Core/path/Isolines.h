// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Isolines_h
#define geodesic_Isolines_h

#include "base/Vector3.h"
#include "mesh/EdgeTable.h"
#include "mesh/TriangleMesh.h"

#include <functional>
#include <span>
#include <vector>

namespace geodesic
{

/** A curve of constant distance. */
struct Isoline
{
  double level;
  /** Its points in order; a closed one has its first point again at the end. */
  std::vector<Vector3> points;
  /** The length of the arcs between the points, not of the chords. */
  double length;
  /** The area of the connected part of the surface beside the curve where the values are less. */
  double area;
};

/**
 * The isolines of a distance field: the borders of where it is less than each level. Inside of a
 * face the field is that of FaceField, and along an edge it is of the kind, a point's or a
 * straight front's, that suits the faces with the edge better; so curves are whole across edges. A
 * face in which values have both signs has linear ones.
 *
 * @param edges   of the mesh
 * @param values  one for each vertex; negative ones are distances on the minus side of a signed
 *                field. NaN and infinity for none: faces with such a corner have no isolines.
 * @param levels  in increasing order, all different and finite
 * @param goesOn  called for each level; false stops
 * @return the curves of each level in turn, those of no length left out. They end at the border, at
 *         faces without values and where edges have more than two faces. Empty if stopped.
 * Time O(n log n) for the mesh, and O(k log k) for each level, where k faces have it.
 */
std::vector<Isoline> isolines(const TriangleMesh& mesh, const EdgeTable& edges,
  std::span<const double> values, std::span<const double> cost, std::span<const double> levels,
  const std::function<bool()>& goesOn);

}

#endif

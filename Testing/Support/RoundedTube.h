// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_RoundedTube_h
#define geodesic_testing_RoundedTube_h

#include "Surfaces.h"
#include "mesh/SurfacePoint.h"

#include <vector>

namespace geodesic::testing
{

/**
 * An open square tube with rounded corners, as CAD programs mesh it: a few long edges along the
 * flat sides, many short ones along the fillets, and rows in the same spirit, so that tiny
 * triangles, large ones and needles between them meet. It unrolls to a rectangle without
 * distortion, which makes the distances on it known.
 */
class RoundedTube
{
public:
  /**
   * @param perSide   edges along a flat side, and rows of long edges, each of length 1
   * @param perFillet edges along a fillet, and rows of short edges between the long ones
   * @param ratio     of a long edge to a short one
   */
  RoundedTube(Index perSide, Index perFillet, double ratio, unsigned seed);

  const Surface& surface() const { return this->Tube; }

  /** True distances of all points from a point in a triangle of the surface. */
  std::vector<double> distancesFrom(const SurfacePoint& source) const;

private:
  Surface Tube;
  /** Each point unrolled: along the profile, and along the axis. */
  std::vector<Vector3> Flat;
  double Perimeter = 0.0;
};

}

#endif

// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_OnIntrinsic_h
#define geodesic_testing_OnIntrinsic_h

#include "ExactDistances.h"
#include "Solving.h"
#include "march/IntrinsicMarchingSolver.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace geodesic::testing
{

/** A square of random points, stretched along x. */
inline Surface stretchedPlane(Index points, double factor)
{
  Surface surface = delaunayPlane(points, 1);
  for (Vector3& point : surface.points)
  {
    point.x *= factor;
  }
  return surface;
}

inline Surface flattenedSphere(int levels, double factor)
{
  Surface surface = icosphere(levels);
  for (Vector3& point : surface.points)
  {
    point.z /= factor;
  }
  return surface;
}

inline SolveOptions intrinsicOptions(SolveOptions options = {})
{
  options.isIntrinsic = true;
  return options;
}

inline std::vector<double> intrinsicDistances(const std::shared_ptr<const TriangleMesh>& mesh,
  const std::vector<Seed>& seeds, const SolveOptions& options = {})
{
  return distances<IntrinsicMarchingSolver>(mesh, seeds, intrinsicOptions(options));
}

/** Infinite numbers that are equal do not differ. */
inline double largestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const bool isSame = a[i] == b[i];
    largest = std::max(largest, isSame ? 0.0 : std::abs(a[i] - b[i]));
  }
  return largest;
}

}

#endif

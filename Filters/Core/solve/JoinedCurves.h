// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_JoinedCurves_h
#define geodesic_JoinedCurves_h

#include "solve/Seed.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace geodesic
{

class TriangleMesh;

/** Seeds that are curves and continue each other, as one curve. */
struct JoinedCurve
{
  /** The least of their numbers. */
  Index seed;
  std::size_t numberOfSeeds;
  std::vector<SurfacePoint> points;
};

/**
 * Joins curves where two of the same value have an end, and no third one, if together they are
 * straight on the surface: then one front is as good as those of all. So is a slice through a
 * surface. Segments that are given several times count once. Curves without points are left out.
 * Time O(n log n) for n curves.
 * @param goesOn called for each few thousand curves; once it has returned false, there are none
 * @return the curves by increasing number of the seed
 */
std::vector<JoinedCurve> joinedCurves(
  const TriangleMesh& mesh, std::span<const Seed> seeds, const std::function<bool()>& goesOn);

}

#endif

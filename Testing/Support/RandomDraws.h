// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_RandomDraws_h
#define geodesic_testing_RandomDraws_h

#include "mesh/TriangleMesh.h"

#include <cstddef>
#include <random>

namespace geodesic::testing
{

using Random = std::mt19937;

inline double between(double low, double high, Random& random)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

/** @param count above 0 */
inline Index below(std::size_t count, Random& random)
{
  return std::uniform_int_distribution<Index>(0, static_cast<Index>(count - 1))(random);
}

inline bool happens(double probability, Random& random)
{
  return std::bernoulli_distribution(probability)(random);
}

/** A vertex, a point of an edge or one inside a face, each as often. */
inline SurfacePoint randomPoint(const TriangleMesh& mesh, Random& random)
{
  SurfacePoint point{ below(mesh.numberOfTriangles(), random), { 1.0, 0.0, 0.0 } };
  const Index carriers = 1 + below(3, random);
  double left = 1.0;
  for (Index i = 0; i + 1 < carriers; ++i)
  {
    point.weights[i] = left * between(0.05, 0.95, random);
    left -= point.weights[i];
  }
  point.weights[carriers - 1] = left;
  return point;
}

/** A point at a vertex, on an edge or in a face, as the remainder of @p kind by 3 is 0, 1 or 2. */
inline SurfacePoint randomPoint(const TriangleMesh& mesh, int kind, Random& random)
{
  std::uniform_real_distribution<double> part(0.1, 0.45);
  SurfacePoint point{ static_cast<Index>(random() % mesh.numberOfTriangles()), { 1.0, 0.0, 0.0 } };
  const double a = part(random);
  const double b = kind % 3 == 2 ? part(random) : 0.0;
  if (kind % 3 > 0)
  {
    point.weights = { 1.0 - a - b, a, b };
  }
  return point;
}

}

#endif

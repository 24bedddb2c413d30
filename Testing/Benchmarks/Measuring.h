// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_Measuring_h
#define geodesic_testing_Measuring_h

#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <ctime>

namespace geodesic::testing
{

/** Of this process, so that what else runs on the core does not count. */
inline double processorSeconds()
{
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

template <class Work>
double seconds(const Work& work)
{
  const double start = processorSeconds();
  work();
  return processorSeconds() - start;
}

/** A point of the mesh as one of the surface it was made from. */
inline SurfacePoint onSurface(const TriangleMesh& mesh, const SurfacePoint& point)
{
  return { mesh.sourceOfTriangle(point.triangle), point.weights };
}

struct Box
{
  Vector3 low;
  Vector3 high;
};

inline Box boxOf(const TriangleMesh& mesh)
{
  Box box{ mesh.position(0), mesh.position(0) };
  for (const Vector3& p : mesh.positions())
  {
    box.low = { std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z) };
    box.high = { std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z) };
  }
  return box;
}

}

#endif

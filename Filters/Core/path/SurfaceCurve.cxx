// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/SurfaceCurve.h"

#include "base/Interruption.h"
#include "path/PathFinder.h"
#include "solve/DistanceSolver.h"

#include <stdexcept>

namespace geodesic
{

SurfacePath joinedCurve(
  DistanceSolver& solver, std::span<const SurfacePoint> points, const std::string& name)
{
  const TriangleMesh& mesh = solver.mesh();
  SolveOptions options;
  options.onProgress = [](std::size_t)
  {
    Interruption::check();
    return true;
  };
  SurfacePath curve{ PathPoint::at(mesh, points[0]) };
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const PathPoint next = PathPoint::at(mesh, points[i]);
    const Carriers corners = unionOf(curve.back(), next);
    if (corners.size() <= 3 && mesh.hasTriangleWith({ corners.begin(), corners.end() }))
    {
      curve.push_back(next);
      continue;
    }
    const auto path = shortestPath(solver, points[i - 1], points[i], options, {});
    if (!path)
    {
      throwUnjoined(name, i);
    }
    curve.insert(curve.end(), path->begin() + 1, path->end());
  }
  return curve;
}

void throwUnjoined(const std::string& name, std::size_t i)
{
  throw std::invalid_argument(name + " can't be joined from its point " + std::to_string(i - 1) +
    " to its point " + std::to_string(i) +
    ": no path over the surface leads there. Connect the parts of the surface, or split the line.");
}

}
